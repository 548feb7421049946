#pragma once
/// Walks over the paths of the inputs, and how messages name them.

#include "verb.h"

#include "lambert/polygon/formats/features.h"

#include <optional>
#include <string>
#include <vector>

namespace lambert::cli {

struct PathPlace {
  const PolygonInput* input;
  std::size_t feature;
  std::optional<std::size_t> polygon, ring, line;

  const polygon::Feature& feature_of() const { return input->features.features[feature]; }
  /// "a.wkt: feature 0 'Fiji', polygon 1, ring 0"; a single polygon goes without saying.
  std::string text() const;
  nlohmann::ordered_json json() const;
};

/// Calls f(place, path) for the rings and lines of every feature.
template <class F>
void for_each_path(const std::vector<PolygonInput>& inputs, F&& f) {
  for (const PolygonInput& input : inputs)
    for (std::size_t i = 0; i < input.features.features.size(); ++i) {
      const polygon::Feature& feature = input.features.features[i];
      for (std::size_t p = 0; p < feature.polygons.size(); ++p)
        for (std::size_t r = 0; r < feature.polygons[p].size(); ++r)
          f(PathPlace{&input, i, p, r, {}}, feature.polygons[p][r]);
      for (std::size_t l = 0; l < feature.lines.size(); ++l) f(PathPlace{&input, i, {}, {}, l}, feature.lines[l]);
    }
}

/// The vertices in space; those without a height lie in z = 0.
std::vector<Vec3d> in_space(const polygon::Path& path);

/// Adds to a picture every path of the inputs: rings filled lightly, with their indices.
void show_inputs(draw::Picture& picture, const std::vector<PolygonInput>& inputs,
                 polygon::FillRule rule = polygon::FillRule::even_odd);
/// Rings of several pieces, each with a colour of its own and, while there are few, its number.
void show_pieces(draw::Picture& picture, const std::vector<polygon::Rings>& pieces);

inline constexpr draw::Colour ink{36, 41, 47}, slate{87, 96, 106}, alarm{207, 34, 46};

}  // namespace lambert::cli
