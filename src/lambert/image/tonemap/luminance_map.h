#pragma once
#include "lambert/base/rgb.h"
#include "lambert/image/plane.h"

#include <limits>

namespace lambert::tone {

/// A radiance above this is taken for infinite: it is shown as white and counts in no statistics.
inline constexpr float infinite_radiance = 1e10f;

/// A luminance below this, which logarithms cannot take, is black.
inline constexpr float least_luminance = std::numeric_limits<float>::min();

/// What curves know of a radiance map. Only pixels count whose luminance is above 0 and finite; without any, the values
/// are those of a grey of 1.
struct LuminanceStatistics {
  float log_average = 1;  ///< the geometric mean
  float average = 1;
  float smallest = 1, largest = 1;
  Rgb average_colour{1.0f};
  LuminanceStatistics scaled(float factor) const;
};

/// The luminances of a map with their statistics.
struct LuminanceMap {
  Plane luminance;
  LuminanceStatistics statistics;

  /// The luminance that `percent` of the counted pixels do not exceed.
  float percentile(float percent) const;
};

/// Red, green and blue apart.
struct RgbPlanes {
  Plane r, g, b;
};

/// Sums over some rows; added up in a fixed order.
class StatisticsSum {
 public:
  void add_row(const float* r, const float* g, const float* b, const float* luminance, std::size_t count);
  void add(const StatisticsSum& other);
  LuminanceStatistics statistics() const;

 private:
  double counted_ = 0, log2_ = 0, sum_ = 0, r_ = 0, g_ = 0, b_ = 0;
  float smallest_ = infinite_radiance, largest_ = 0;
};

}  // namespace lambert::tone
