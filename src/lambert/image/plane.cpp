#include "lambert/image/plane.h"

#include "lambert/image/filter/blur.h"
#include "lambert/image/filter/morphology.h"
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

Plane range_around(const Plane& plane, int radius) {
  if (plane.values.empty()) return plane;
  const Image image = image_of(plane);
  Plane range = plane_of(dilated(image, Vec2i(radius)));
  const Image least = eroded(image, Vec2i(radius));
  for (std::size_t i = 0; i < range.values.size(); ++i) range.values[i] -= least.pixels()[i];
  return range;
}

Plane gaussian_blurred(const Plane& plane, float sigma) {
  if (plane.values.empty()) return plane;
  return plane_of(gaussian_blurred(image_of(plane), Vec2(sigma), EdgeMode::clamp));
}

}  // namespace lambert
