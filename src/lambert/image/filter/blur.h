#pragma once
#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/image.h"

namespace lambert {

/// Blurs of every channel; size, windows and metadata stay. A radius or deviation of 0 leaves its axis alone.

enum class GaussianMethod {
  automatic,  ///< direct below a deviation of 4 pixels, decimated above
  direct,     ///< the sampled Gaussian to five deviations, normalised: what is cut off is 6e-7 of it
  decimated,  ///< blurred to a coarser grid by 1/√2 of the deviation and from it by the rest, at a cost that does not
              ///< depend on the deviation; differs from direct by at most 3e-6 of the largest value. From a deviation
              ///< of 2 pixels.
};
/// `sigma` is the standard deviation in pixels. Throws Error when it is negative or above 65536.
Image gaussian_blurred(const Image& image, Vec2 sigma, EdgeMode edge = EdgeMode::clamp,
                       GaussianMethod method = GaussianMethod::automatic);

/// The mean of (2 radius + 1)² pixels; time does not depend on the radius. Throws Error for a radius that is negative
/// or above 65536.
Image box_blurred(const Image& image, Vec2i radius, EdgeMode edge = EdgeMode::clamp);

/// Bartlett's weights, falling from radius + 1 at the pixel to 1 at `radius` beside it (1 is the 1-2-1 kernel).
/// Throws Error for a radius that is negative or above 4096.
Image bartlett_blurred(const Image& image, Vec2i radius, EdgeMode edge = EdgeMode::clamp);

}  // namespace lambert
