#include "lambert/draw/sheet.h"

#include "lambert/draw/axis_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::draw {

Sheet::Sheet(const Box2& box, const PictureOptions& options, double title_height) {
  const Vec2d half_min = box.empty() ? Vec2d(-0.5) : 0.5 * box.min, half_max = box.empty() ? Vec2d(0.5) : 0.5 * box.max;
  Vec2d half_size = half_max - half_min;
  half_centre_ = half_min + 0.5 * half_size;
  if (!(std::max(half_size.x, half_size.y) > 0)) half_size = Vec2d(std::max(0.5, std::abs(half_centre_.x) * 1e-6));
  const double inner_width = std::max(64.0, options.width - 2 * margin);
  const double inner_max_height = std::max(64.0, options.max_height - 2 * margin);
  half_pixel_ = std::max({half_size.x / (inner_width - 2 * padding), half_size.y / (inner_max_height - 2 * padding),
                          std::numeric_limits<double>::min()});
  const double inner_height =
      std::clamp(half_size.y / half_pixel_ + 2 * padding, std::min(120.0, inner_max_height), inner_max_height);
  width_ = inner_width + 2 * margin;
  height_ = inner_height + 2 * margin + title_height;
  area_.min = {margin, margin + title_height};
  area_.max = {margin + inner_width, margin + title_height + inner_height};
}

Vec2d Sheet::point(Vec2d p) const {
  const Vec2d centre = area_.centre(), offset = (0.5 * p - half_centre_) / half_pixel_;
  return {centre.x + offset.x, centre.y - offset.y};
}

Ring Sheet::ring(const Ring& ring) const {
  Ring mapped;
  mapped.reserve(ring.size());
  for (const Vec2d p : ring) mapped.push_back(point(p));
  return mapped;
}

Rings Sheet::rings(const Rings& rings) const {
  Rings mapped;
  for (const Ring& r : rings) mapped.push_back(ring(r));
  return mapped;
}

Sheet::Ticks Sheet::ticks(int axis) const {
  Ticks found;
  const double pixels = axis == 0 ? area_.max.x - area_.min.x : area_.max.y - area_.min.y;
  const double centre = 2 * half_centre_[axis], reach = pixels * half_pixel_;
  const double step = round_step(200 * half_pixel_);
  const double first = std::ceil((centre - reach) / step), last = std::floor((centre + reach) / step);
  if (!std::isfinite(step) || !(step > 0) || !(last - first < 1000) || std::abs(first) > 1e12 || std::abs(last) > 1e12)
    return found;
  for (double k = first; k <= last; ++k) {
    Vec2d p = 2.0 * half_centre_;
    p[axis] = k * step;
    found.emplace_back(point(p)[axis], tick_text(p[axis]));
  }
  return found;
}

}  // namespace lambert::draw
