#pragma once
/// Pixel reconstruction filters, centred on 0, separable, in pixels.

#include "lambert/base/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class FilterKind { box, triangle, gaussian, mitchell, lanczos, blackman_harris };
FilterKind filter_kind(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> filter_names();

struct FilterSettings {
  FilterKind kind = FilterKind::blackman_harris;
  Vec2 radius{0};  ///< half extent in pixels; 0 means the kind's default (box .5, triangle 1, gaussian 1.5, mitchell 2,
                   ///< lanczos 3, blackman-harris 1.5)
  float sigma = 0.5f;                ///< gaussian
  float b = 1.0f / 3, c = 1.0f / 3;  ///< mitchell
};

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
    std::vector<float> cdf;    // of |f| over equal bins on [-radius, radius]
    std::vector<float> value;  // f at bin centres
    float radius = 0;
  };
  FilterSettings settings_;
  Vec2 radius_{0.5f};
  Axis x_, y_;
  float scale_ = 1;   // 1 / integral of the filter
  float weight_ = 1;  // integral of |f| over integral of f
};

}  // namespace lambert
