#include "lambert/image/plane.h"

#include "lambert/image/filter/blur.h"
#include "lambert/image/filter/separable.h"
#include "lambert/image/image.h"

namespace lambert {
namespace {

Image image_of(const Plane& plane) {
  Image image(plane.width, plane.height, {"Y"});
  std::ranges::copy(plane.values, image.pixels().begin());
  return image;
}

Plane plane_of(const Image& image) {
  Plane plane;
  plane.width = image.width(), plane.height = image.height();
  plane.values.assign(image.pixels().begin(), image.pixels().end());
  return plane;
}

}  // namespace

Plane filtered(const Plane& plane, std::span<const double> across, std::span<const double> down) {
  if (plane.values.empty()) return plane;
  return plane_of(separably_filtered(image_of(plane), convolution_taps(across, plane.width, EdgeMode::clamp),
                                     convolution_taps(down, plane.height, EdgeMode::clamp)));
}

Plane gaussian_blurred(const Plane& plane, float sigma) {
  if (plane.values.empty()) return plane;
  return plane_of(gaussian_blurred(image_of(plane), Vec2(sigma), EdgeMode::clamp));
}

}  // namespace lambert
