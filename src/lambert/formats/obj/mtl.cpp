#include "lambert/formats/obj/mtl.h"

#include "lambert/base/number.h"
#include "lambert/formats/obj/lines.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert::obj {
namespace {

constexpr std::array<std::pair<std::string_view, std::optional<float> MtlMaterial::*>, 10> number_keys{{
    {"Ns", &MtlMaterial::ns},
    {"Ni", &MtlMaterial::ni},
    {"d", &MtlMaterial::dissolve},
    {"Pr", &MtlMaterial::roughness},
    {"Pm", &MtlMaterial::metallic},
    {"Ps", &MtlMaterial::sheen},
    {"Pc", &MtlMaterial::clearcoat},
    {"Pcr", &MtlMaterial::clearcoat_roughness},
    {"aniso", &MtlMaterial::anisotropy},
    {"anisor", &MtlMaterial::anisotropy_rotation},
}};
constexpr std::array<std::pair<std::string_view, std::optional<Rgb> MtlMaterial::*>, 3> colour_keys{
    {{"Kd", &MtlMaterial::kd}, {"Ks", &MtlMaterial::ks}, {"Ke", &MtlMaterial::ke}}};
constexpr std::array<std::pair<std::string_view, MtlMap MtlMaterial::*>, 8> map_keys{{
    {"map_Kd", &MtlMaterial::map_kd},
    {"map_Ke", &MtlMaterial::map_ke},
    {"map_d", &MtlMaterial::map_dissolve},
    {"map_Pr", &MtlMaterial::map_roughness},
    {"map_Pm", &MtlMaterial::map_metallic},
    {"norm", &MtlMaterial::normal_map},
    {"map_Kn", &MtlMaterial::normal_map},
    {"map_norm", &MtlMaterial::normal_map},
}};

template <class Table>
auto find_key(const Table& table, std::string_view key) {
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.first == key; });
}

/// One number is grey. "spectral" and "xyz" colours are noted and left out.
std::optional<Rgb> parse_colour(Words& words, std::string_view key, Notes& notes) {
  const auto r = words.try_number();
  if (!r) {
    const std::string_view kind = words.next();
    if (kind != "spectral" && kind != "xyz") words.fail("expected the colour '" + std::string(key) + "' as numbers");
    notes.add("MTL: '" + std::string(key) + " " + std::string(kind) + "' is ignored");
    return std::nullopt;
  }
  if (words.at_end()) return Rgb(*r);
  const float g = words.number("green");
  return Rgb(*r, g, words.number("blue"));
}

/// -o and -s take one to three numbers.
void parse_vector(Words& words, Vec2& v) {
  v.x = words.number("a texture coordinate");
  if (const auto y = words.try_number()) v.y = *y;
  words.try_number();
}

MtlMap parse_map(Words& words, Notes& notes) {
  MtlMap map;
  for (;;) {
    Words ahead = words;
    const std::string_view option = ahead.next();
    if (!option.starts_with('-') || option.size() < 2) break;
    words = ahead;
    if (option == "-s") {
      parse_vector(words, map.scale);
    } else if (option == "-o") {
      parse_vector(words, map.offset);
    } else if (option == "-clamp") {
      map.clamp = words.next() == "on";
    } else if (option == "-bm") {
      map.multiplier = words.number("the multiplier");
    } else {
      notes.add("MTL: texture option '" + printable(option) + "' is ignored");
      if (option == "-t" || option == "-mm") {
        while (words.try_number()) {
        }
      } else {
        words.next();
      }
    }
  }
  map.file = std::string(words.rest());
  std::replace(map.file.begin(), map.file.end(), '\\', '/');
  return map;
}

void parse_key(std::string_view key, Words& words, MtlMaterial& m, Notes& notes) {
  if (const auto k = find_key(number_keys, key); k != number_keys.end()) {
    if (key == "d" && Words(words).next() == "-halo") words.next();
    m.*(k->second) = words.number("a value");
  } else if (const auto c = find_key(colour_keys, key); c != colour_keys.end()) {
    if (const auto colour = parse_colour(words, key, notes)) m.*(c->second) = *colour;
  } else if (const auto t = find_key(map_keys, key); t != map_keys.end()) {
    m.*(t->second) = parse_map(words, notes);
  } else if (key == "Tr") {
    m.dissolve = 1 - words.number("the transparency");
  } else if (key == "illum") {
    m.illumination = static_cast<int>(std::clamp(words.number("the illumination model"), 0.0f, 10.0f));
  } else if (key != "Ka" && key != "map_Ka") {
    // Ambient light is a substitute for light transport, which is computed here.
    notes.add("MTL: '" + printable(key) + "' is ignored");
  }
}

}  // namespace

void parse_mtl(std::string_view text, const std::string& name, MtlLibrary& library, Notes& notes) {
  LineReader lines(text, name);
  Words words;
  MtlMaterial* current = nullptr;
  while (lines.next(words)) {
    const std::string_view key = words.next();
    if (key.empty()) continue;
    if (key == "newmtl") {
      current = &library[std::string(words.rest())];
      *current = {};
    } else if (!current) {
      words.fail("'" + printable(key) + "' must stand behind newmtl");
    } else {
      parse_key(key, words, *current, notes);
    }
  }
}

}  // namespace lambert::obj
