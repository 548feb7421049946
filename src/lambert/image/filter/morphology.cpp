#include "lambert/image/filter/morphology.h"

#include "lambert/image/filter/sliding_window.h"

#include <algorithm>

namespace lambert {
namespace {

/// An edge pixel is in every window that reaches beyond it: to repeat it is to pass over what is outside.
Image slid_inside(const Image& image, Vec2i radius, WindowOperation operation) {
  const auto needed = [](int r, int size) { return r < 0 ? r : std::min(r, size); };
  return slid(image, {needed(radius.x, image.width()), needed(radius.y, image.height())}, operation, EdgeMode::clamp);
}

}  // namespace

Image eroded(const Image& image, Vec2i radius) { return slid_inside(image, radius, WindowOperation::least); }
Image dilated(const Image& image, Vec2i radius) { return slid_inside(image, radius, WindowOperation::greatest); }
Image opened(const Image& image, Vec2i radius) { return dilated(eroded(image, radius), radius); }
Image closed(const Image& image, Vec2i radius) { return eroded(dilated(image, radius), radius); }

}  // namespace lambert
