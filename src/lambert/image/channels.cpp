#include "lambert/image/channels.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cctype>

namespace lambert {
std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

namespace {

std::string layer_of(const std::string& name) {
  const std::size_t point = name.rfind('.');
  return point == std::string::npos ? std::string() : name.substr(0, point);
}

}  // namespace

std::vector<ColourTriple> colour_triples(const std::vector<std::string>& names) {
  static constexpr std::string_view others[] = {"normal", "crypto", "motion", "velocity", "tangent", "pref", "uv"};
  std::vector<ColourTriple> result;
  for (std::size_t r = 0; r < names.size(); ++r) {
    const std::string& name = names[r];
    if (name != "R" && !name.ends_with(".R")) continue;
    const std::string layer = name.substr(0, name.size() - 1), word = lower(layer);
    if (needs_full_floats(name)) continue;
    if (std::ranges::any_of(others, [&](std::string_view o) { return word.find(o) != std::string::npos; })) continue;
    const auto g = std::ranges::find(names, layer + "G"), b = std::ranges::find(names, layer + "B");
    if (g == names.end() || b == names.end()) continue;
    result.push_back({r, static_cast<std::size_t>(g - names.begin()), static_cast<std::size_t>(b - names.begin())});
  }
  return result;
}

bool needs_full_floats(std::string_view channel) {
  static constexpr std::string_view parts[] = {"position.", ".id", "samples.", "variance.", "Crypto", "denoising."};
  if (channel == "Z" || channel == "ZBack" || lower(channel).find("depth") != std::string::npos) return true;
  return std::ranges::any_of(parts, [&](std::string_view p) { return channel.find(p) != std::string_view::npos; });
}

std::vector<bool> light_channels(const std::vector<std::string>& names) {
  std::vector<bool> light(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    light[i] = (names[i] == "Y" || names[i].ends_with(".Y")) && !needs_full_floats(names[i]) &&
               std::ranges::find(names, layer_of(names[i]) + (layer_of(names[i]).empty() ? "X" : ".X")) == names.end();
  for (const ColourTriple& t : colour_triples(names)) light[t.r] = light[t.g] = light[t.b] = true;
  return light;
}

std::vector<ChannelChoice> chosen_channels(const std::vector<std::string>& names, const std::string& layer,
                                           const std::vector<std::string>& wanted, const std::string& file) {
  std::vector<ChannelChoice> in_layer;
  std::vector<std::string> known, layers;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const std::string l = layer_of(names[i]); !l.empty() && std::ranges::find(layers, l) == layers.end())
      layers.push_back(l);
    if (!layer.empty() && !names[i].starts_with(layer + ".")) continue;
    in_layer.push_back({i, layer.empty() ? names[i] : names[i].substr(layer.size() + 1)});
    known.push_back(in_layer.back().name);
  }
  if (in_layer.empty()) {
    if (layers.empty()) throw Error(file + ": has no layers");
    throw Error(file + ": has no layer " + unknown_word(layer, layers));
  }
  if (wanted.empty()) return in_layer;
  std::vector<ChannelChoice> result;
  for (const std::string& word : wanted) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals), old = equals == std::string::npos ? name : word.substr(equals + 1);
    const auto found = std::ranges::find(in_layer, old, &ChannelChoice::name);
    if (found == in_layer.end()) throw Error(file + ": has no channel " + unknown_word(old, known));
    if (name.empty()) throw Error("'" + word + "': expected a name before '='");
    if (std::ranges::find(result, name, &ChannelChoice::name) != result.end())
      throw Error("channel '" + name + "' is asked for twice");
    result.push_back({found->stored, name});
  }
  return result;
}

}  // namespace lambert
