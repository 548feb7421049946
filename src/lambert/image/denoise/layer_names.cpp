#include "lambert/image/denoise/layer_names.h"

#include <optional>
#include <string>

namespace lambert::denoise {
namespace {

std::optional<std::size_t> find(const Image& image, const std::string& name) {
  if (const auto exact = image.channel(name)) return exact;
  if (name.size() == 1) return std::nullopt;  // below a view layer "Z" may be part of a normal
  const std::string below = "." + name;
  for (std::size_t c = 0; c < image.channel_count(); ++c)
    if (image.channels()[c].ends_with(below)) return c;
  return std::nullopt;
}

}  // namespace

std::vector<std::size_t> find_triple(const Image& image, std::initializer_list<std::string_view> layers) {
  for (const std::string_view layer : layers)
    for (const std::string_view letters : {"RGB", "XYZ", "rgb", "xyz"}) {
      std::vector<std::size_t> found;
      for (const char letter : letters) {
        const auto at =
            layer.empty() ? image.channel(std::string(1, letter)) : find(image, std::string(layer) + "." + letter);
        if (at) found.push_back(*at);
      }
      if (found.size() == 3) return found;
      if (layer.empty()) break;
    }
  return {};
}

std::vector<std::size_t> find_single(const Image& image, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    if (const auto at = find(image, std::string(name))) return {*at};
  return {};
}

}  // namespace lambert::denoise
