#pragma once
/// Which light to sample from a point.

#include "lambert/light/any_light.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace lambert {

enum class LightStrategy {
  uniform,
  power,  ///< in proportion to emitted power, the same everywhere
  tree,   ///< by importance at the point, from a bounding hierarchy (Conty Estevez and Kulla 2018)
};
LightStrategy light_strategy(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> light_strategy_names();

class LightChooser {
 public:
  struct Choice {
    std::uint32_t light = 0;
    float probability = 0;
  };
  LightChooser() = default;
  LightChooser(std::span<const Light> lights, const LightContext& context, LightStrategy strategy);
  /// Needs u in [0,1). probability is 0 when there is no light that can matter.
  Choice choose(Vec3 point, Vec3 normal, float u) const;
  /// The probability with which choose(point, normal, ·) returns `light`.
  float probability(Vec3 point, Vec3 normal, std::uint32_t light) const;
};

}  // namespace lambert
