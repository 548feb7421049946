#include "lambert/image/formats/exr_attributes.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/image/formats/exr_stream.h"

#include <ImfOpaqueAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <memory>
#include <sstream>
#include <string_view>

namespace lambert {
namespace {

static_assert(std::endian::native == std::endian::little, "values are copied as OpenEXR stores them");

/// The numbers that make up a type, in the order of the file format's specification ("OpenEXR File Layout").
struct Layout {
  std::string_view type;
  char number;  // i and u of 32 bits, f and d for float and double
  int count;    // 0: any number
};
constexpr Layout layouts[] = {
    {"int", 'i', 1},         {"float", 'f', 1},    {"double", 'd', 1},
    {"v2i", 'i', 2},         {"v2f", 'f', 2},      {"v2d", 'd', 2},
    {"v3i", 'i', 3},         {"v3f", 'f', 3},      {"v3d", 'd', 3},
    {"m33f", 'f', 9},        {"m33d", 'd', 9},     {"m44f", 'f', 16},
    {"m44d", 'd', 16},       {"box2i", 'i', 4},    {"box2f", 'f', 4},
    {"timecode", 'u', 2},    {"keycode", 'i', 7},  {"chromaticities", 'f', 8},
    {"floatvector", 'f', 0}, {"rational", 'r', 2},  // one signed, one not
};
const Layout* layout_of(std::string_view type) {
  const auto found = std::ranges::find(layouts, type, &Layout::type);
  return found == std::end(layouts) ? nullptr : found;
}

constexpr std::string_view environment_maps[] = {"latlong", "cube"};

/// What describes the file and not the picture.
bool is_layout(std::string_view name, std::string_view type) {
  static constexpr std::string_view names[] = {
      "channels", "compression", "dataWindow", "displayWindow", "lineOrder",
      "tiles",    "type",        "version",    "chunkCount",    "maxSamplesPerPixel"};
  return type == "preview" || std::ranges::find(names, name) != std::end(names);
}

/// What every header has, and what it is without a note.
bool is_default(std::string_view name, std::string_view value) {
  return ((name == "pixelAspectRatio" || name == "screenWindowWidth") && value == "1") ||
         (name == "screenWindowCenter" && value == "0 0");
}

template <class T>
T load(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}
template <class T>
void store(std::vector<std::byte>& to, T value) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&value);
  to.insert(to.end(), bytes, bytes + sizeof value);
}

/// 'r' stands for i, then u.
char number_at(const Layout& layout, int i) { return layout.number != 'r' ? layout.number : i == 0 ? 'i' : 'u'; }

std::string numbers_text(Bytes bytes, const Layout& layout) {
  std::string text;
  std::size_t at = 0;
  for (int i = 0; layout.count == 0 || i < layout.count; ++i) {
    const char number = number_at(layout, i);
    const std::size_t size = number == 'd' ? 8 : 4;
    if (at + size > bytes.size()) break;
    if (!text.empty()) text += ' ';
    const std::byte* p = bytes.data() + at;
    if (number == 'f')
      append_number(text, load<float>(p));
    else if (number == 'd')
      append_number(text, load<double>(p));
    else
      text += number == 'i' ? std::to_string(load<std::int32_t>(p)) : std::to_string(load<std::uint32_t>(p));
    at += size;
  }
  return text;
}

/// Words of any characters: a backslash stands before spaces and backslashes, "\0" for an empty word.
std::string escaped(std::string_view word) {
  if (word.empty()) return "\\0";
  std::string text;
  for (const char c : word) {
    if (c == ' ' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}
std::string words_text(Bytes bytes) {
  std::string text;
  for (std::size_t at = 0; at + 4 <= bytes.size();) {
    const auto length = load<std::uint32_t>(bytes.data() + at);
    at += 4;
    if (length > bytes.size() - at) break;
    if (!text.empty()) text += ' ';
    text += escaped({reinterpret_cast<const char*>(bytes.data()) + at, length});
    at += length;
  }
  return text;
}
std::vector<std::byte> words_bytes(std::string_view text) {
  std::vector<std::string> words;
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ') {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (text[i] == '\\' && i + 1 < text.size()) {
      if (text[++i] == '0') continue;
    }
    words.back() += text[i];
  }
  std::vector<std::byte> bytes;
  for (const std::string& word : words) {
    store(bytes, static_cast<std::uint32_t>(word.size()));
    for (const char c : word) bytes.push_back(static_cast<std::byte>(c));
  }
  return bytes;
}

constexpr std::string_view hex_digits = "0123456789abcdef";
std::string hex_text(Bytes bytes) {
  std::string text;
  for (const std::byte b : bytes) {
    text += hex_digits[std::to_integer<std::size_t>(b >> 4)];
    text += hex_digits[std::to_integer<std::size_t>(b & std::byte{15})];
  }
  return text;
}

[[noreturn]] void wrong_value(const std::string& name, const Attribute& a) {
  throw Error("attribute '" + printable(name) + "' of type " + printable(a.type) + " cannot be '" + printable(a.value) +
              "'");
}

std::vector<std::byte> hex_bytes(const std::string& name, const Attribute& a) {
  std::vector<std::byte> bytes;
  if (a.value.size() % 2 != 0) wrong_value(name, a);
  for (std::size_t i = 0; i < a.value.size(); i += 2) {
    const std::size_t high = hex_digits.find(a.value[i]), low = hex_digits.find(a.value[i + 1]);
    if (high > 15 || low > 15) wrong_value(name, a);
    bytes.push_back(static_cast<std::byte>(high << 4 | low));
  }
  return bytes;
}

/// The value as the file has it.
std::vector<std::byte> attribute_bytes(const std::string& name, const Attribute& a) {
  if (a.type == "stringvector") return words_bytes(a.value);
  if (a.type == "envmap") {
    const auto found = std::ranges::find(environment_maps, a.value);
    if (found == std::end(environment_maps)) wrong_value(name, a);
    return {static_cast<std::byte>(found - std::begin(environment_maps))};
  }
  const Layout* layout = layout_of(a.type);
  if (!layout) return hex_bytes(name, a);
  std::istringstream words(a.value);
  std::vector<std::byte> bytes;
  int count = 0;
  for (std::string word; words >> word; ++count) {
    const char number = number_at(*layout, count), *end = word.data() + word.size();
    bool whole = false;
    // from_chars and not base/number.h: values may be infinite.
    if (number == 'f') {
      float value = 0;
      whole = std::from_chars(word.data(), end, value).ptr == end;
      store(bytes, value);
    } else if (number == 'd') {
      double value = 0;
      whole = std::from_chars(word.data(), end, value).ptr == end;
      store(bytes, value);
    } else {
      std::int64_t value = 0;
      whole = parse_int(word.data(), end, value) == end &&
              (number == 'u' ? value >= 0 && value <= UINT32_MAX : value >= INT32_MIN && value <= INT32_MAX);
      store(bytes, static_cast<std::uint32_t>(value));
    }
    if (!whole || (layout->count != 0 && count >= layout->count)) wrong_value(name, a);
  }
  if (layout->count != 0 && count != layout->count) wrong_value(name, a);
  return bytes;
}

std::string value_text(const std::string& type, Bytes bytes) {
  if (type == "stringvector") return words_text(bytes);
  if (type == "envmap" && bytes.size() == 1 && std::to_integer<std::size_t>(bytes[0]) < std::size(environment_maps))
    return std::string(environment_maps[std::to_integer<std::size_t>(bytes[0])]);
  const Layout* layout = layout_of(type);
  return layout ? numbers_text(bytes, *layout) : hex_text(bytes);
}

}  // namespace

void read_attributes(const Imf::Header& header, std::map<std::string, std::string>& metadata,
                     std::map<std::string, Attribute>& attributes) {
  for (auto a = header.begin(); a != header.end(); ++a) {
    const std::string name = a.name(), type = a.attribute().typeName();
    if (is_layout(name, type)) continue;
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute())) {
      metadata[name] = text->value();
      continue;
    }
    MemoryOutput out;
    a.attribute().writeValueTo(out, Imf::EXR_VERSION);
    const std::string value = value_text(type, out.bytes);
    if (!is_default(name, value)) attributes[name] = {type, value};
  }
}

void write_attributes(Imf::Header& header, const std::map<std::string, std::string>& metadata,
                      const std::map<std::string, Attribute>& attributes) {
  for (const auto& [name, text] : metadata) {
    if (is_layout(name, "string")) throw Error("OpenEXR keeps the name '" + name + "' for itself");
    header.insert(name, Imf::StringAttribute(text));
  }
  for (const auto& [name, a] : attributes) {
    if (is_layout(name, a.type)) throw Error("OpenEXR keeps the name '" + name + "' for itself");
    const std::vector<std::byte> bytes = attribute_bytes(name, a);
    const std::unique_ptr<Imf::Attribute> attribute(Imf::Attribute::knownType(a.type.c_str())
                                                        ? Imf::Attribute::newAttribute(a.type.c_str())
                                                        : new Imf::OpaqueAttribute(a.type.c_str()));
    MemoryInput in(bytes, name);
    attribute->readValueFrom(in, static_cast<int>(bytes.size()), Imf::EXR_VERSION);
    header.insert(name, *attribute);
  }
}

}  // namespace lambert
