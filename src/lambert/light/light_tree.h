#pragma once
#include "lambert/light/light_bounds.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambert {

/// A binary hierarchy over lights with a place, which is descended by the importance of each side (Conty Estevez and
/// Kulla 2018; without their splitting, as in Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th
/// ed., 12.6.3).
class LightTree {
 public:
  struct Choice {
    std::uint32_t light = 0;
    float probability = 0;  ///< 0: no light of the tree reaches the point
  };
  LightTree() = default;
  /// Over those `lights` (indices into `bounds`) that have an intensity.
  LightTree(std::span<const LightBounds> bounds, std::vector<std::uint32_t> lights);

  bool empty() const { return nodes_.empty(); }
  Choice choose(Vec3 point, Vec3 normal, float u) const;
  /// Exactly the probability that choose() reports when it returns `light`.
  float probability(Vec3 point, Vec3 normal, std::uint32_t light) const;

 private:
  struct Node {
    LightBounds bounds;
    std::uint32_t index = 0;  ///< leaf: the light; else the second child (the first follows its parent)
    bool leaf = false;
  };
  struct Importances {
    float first, second;
  };
  std::uint32_t build(std::span<const LightBounds> bounds, std::span<std::uint32_t> lights, std::uint64_t trail,
                      std::uint32_t depth);
  Importances child_importances(std::uint32_t node, Vec3 point, Vec3 normal) const;

  std::vector<Node> nodes_;
  std::vector<std::uint64_t> trails_;  // per light: bit d tells which child leads to it at depth d
  std::vector<bool> contains_;         // per light
};

}  // namespace lambert
