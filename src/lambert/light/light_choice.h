#pragma once
/// Which light to sample from a point.

#include "lambert/light/any_light.h"
#include "lambert/light/light_tree.h"
#include "lambert/sampling/distribution.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
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

/// Chooses one light out of many (row PT-28). With the tree, lights at infinity stand beside it: each of them and the
/// tree as a whole has the same share.
class LightChooser {
 public:
  using Choice = LightTree::Choice;
  LightChooser() = default;
  LightChooser(std::span<const Light> lights, const LightContext& context, LightStrategy strategy);

  /// False where choose() takes no notice of u: there is one light or none.
  bool has_choice() const { return light_count_ > 1; }
  /// Needs u in [0,1). probability is 0 when there is no light that can matter. Lights on both sides of the surface
  /// count, since it may transmit; a zero normal stands for a point on no surface.
  Choice choose(Vec3 point, Vec3 normal, float u) const {
    if (light_count_ <= 1) return {0, static_cast<float>(light_count_)};
    return choose_among_many(point, normal, u);
  }
  /// The probability with which choose(point, normal, ·) returns `light`.
  float probability(Vec3 point, Vec3 normal, std::uint32_t light) const {
    if (light_count_ <= 1) return 1;
    return probability_among_many(point, normal, light);
  }

 private:
  Choice choose_among_many(Vec3 point, Vec3 normal, float u) const;
  float probability_among_many(Vec3 point, Vec3 normal, std::uint32_t light) const;

  std::uint32_t light_count_ = 0;
  bool use_tree_ = false;
  std::optional<DiscreteDistribution> table_;  // without the tree
  LightTree tree_;
  std::vector<std::uint32_t> infinite_;  // with the tree: lights at infinity
  std::vector<bool> is_infinite_;        // per light
  float share_ = 1;                      // of the tree, and of each light at infinity
};

}  // namespace lambert
