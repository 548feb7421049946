#pragma once
/// Are two noisy images estimates of the same one?

#include "lambert/image/image.h"
#include "lambert/image/plane.h"

#include <cstddef>

namespace lambert::compare {

struct ZTest {
  std::size_t pixels = 0;   ///< that have a variance
  std::size_t certain = 0;  ///< pixels that differ though neither image has a variance there
  double largest = 0;       ///< |z|
  int x = 0, y = 0;         ///< where
  double p_largest = 1;     ///< of a |z| as large in any of so many pixels (Šidák 1967)
  double mean_z = 0;  ///< of the sums over the image: not misled, as a mean of z is, by variances that grow with values
  double p_mean = 1;  ///< two-sided, of |mean_z|
  double p_spread =
      1;      ///< of a sum of z² as large (chi-square): small when many pixels differ a little more than they should
  Plane map;  ///< z per pixel, 0 where there is no variance

  /// At the significance `alpha`, shared by the three tests (Šidák). A spread that is too small does not reject: it
  /// says that the variances are too large, as those of stratified samples are.
  bool same(double alpha) const;
};

/// z = (Ya - Yb) / sqrt(va + vb) per pixel, Y luminance, v the channel "variance.Y": the variance of a pixel's mean.
/// An image without that channel counts as exact. The tests assume that pixels are independent and their means normal:
/// many samples a pixel, filters no wider than a pixel. Throws Error when the sizes differ or neither has variances.
ZTest z_test(const Image& a, const Image& b);

}  // namespace lambert::compare
