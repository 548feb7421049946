#include "lambert/image/composite/element.h"

#include <algorithm>
#include <limits>

namespace lambert::composite {

std::optional<std::size_t> Shape::channel(std::string_view name) const {
  const auto found = std::find(channels.begin(), channels.end(), name);
  if (found == channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - channels.begin());
}

bool is_sampled(std::string_view channel) {
  const auto has = [&](std::string_view part) { return channel.find(part) != std::string_view::npos; };
  return channel == "Z" || channel.ends_with(".id") || channel == "id" || has("Crypto") ||
         channel.starts_with("samples.") || channel.starts_with("variance.");
}

float nothing_of(std::string_view channel) { return channel == "Z" ? std::numeric_limits<float>::infinity() : 0.0f; }

Window covered(const Shape& shape, const Window& region) {
  return shape.data ? intersection(*shape.data, region) : region;
}

void clear_outside(const Shape& shape, Band& band) {
  const Window& w = band.window();
  const Window inside = covered(shape, w);
  for (std::size_t c = 0; c < shape.channels.size(); ++c) {
    const float nothing = nothing_of(shape.channels[c]);
    for (int y = w.y; y < w.y + w.height; ++y) {
      const auto row = band.row(c, y);
      if (is_empty(inside) || y < inside.y || y >= inside.y + inside.height) {
        std::ranges::fill(row, nothing);
        continue;
      }
      const auto left = static_cast<std::size_t>(inside.x - w.x);
      std::ranges::fill(row.first(left), nothing);
      std::ranges::fill(row.subspan(left + static_cast<std::size_t>(inside.width)), nothing);
    }
  }
}

}  // namespace lambert::composite
