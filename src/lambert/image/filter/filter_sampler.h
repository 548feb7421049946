#pragma once
#include "lambert/base/vec.h"
#include "lambert/image/filter/kernel.h"

#include <vector>

namespace lambert {

/// Draws offsets in proportion to |filter| (filter importance sampling, Ernst et al. 2006): each sample belongs to one
/// pixel only, and a pixel's value is Σ weight L / Σ weight. `weight` is ±1 (its sign that of the filter) times a
/// constant, so that its expected value is 1.
class FilterSampler {
 public:
  struct Sample {
    Vec2 offset;  ///< from the pixel's centre
    float weight;
  };
  explicit FilterSampler(const FilterSettings& settings = {});
  Sample sample(Vec2 u) const;
  float eval(Vec2 offset) const;  ///< the filter itself; its integral over the plane is 1
  Vec2 radius() const { return radius_; }

 private:
  struct Axis {
    Kernel kernel;
    std::vector<float> cdf;    // of |f| over equal bins on [-radius, radius]
    std::vector<float> value;  // f at bin centres
    float radius = 0;
  };
  FilterKind kind_;
  Axis x_, y_;
  Vec2 radius_;
  float scale_ = 1;   // 1 / integral of the filter
  float weight_ = 1;  // integral of |f| over integral of f
};

}  // namespace lambert
