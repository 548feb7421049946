#include "lambert/polygon/arrangement/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lambert::polygon::arrangement {
namespace {

/// Coordinates of a size between these, and 0, serve as they are: multiples of 2^-472 whose products are far from the
/// ends of the exponent's range.
constexpr double smallest = 0x1p-420, largest = 0x1p400;

struct Sizes {
  double least = std::numeric_limits<double>::infinity(), most = 0;  ///< 0 does not count as least
  bool finite = true;
};

Sizes sizes_of(const Rings& rings) {
  Sizes sizes;
  double sum = 0;  // not finite as soon as one coordinate is not
  for (const Ring& ring : rings) {
    for (const Vec2d p : ring) {
      const double x = std::abs(p.x), y = std::abs(p.y);
      sum += (p.x - p.x) + (p.y - p.y);
      sizes.most = std::max(sizes.most, std::max(x, y));
      sizes.least = std::min(sizes.least, std::min(x == 0 ? sizes.least : x, y == 0 ? sizes.least : y));
    }
  }
  sizes.finite = sum == 0;
  return sizes;
}

void append(const Rings& rings, bool scaled, Outline& outline) {
  for (const Ring& ring : rings) {
    if (ring.size() < 3) continue;
    const std::size_t start = outline.points.size();
    for (Vec2d p : ring) {
      if (scaled) p = outline.grid(Vec2d(std::ldexp(p.x, -outline.exponent), std::ldexp(p.y, -outline.exponent)));
      p = p + Vec2d(0, 0);  // no negative zeros
      if (outline.points.size() == start || outline.points.back() != p) outline.points.push_back(p);
    }
    while (outline.points.size() > start + 1 && outline.points.back() == outline.points[start])
      outline.points.pop_back();
    if (outline.points.size() < start + 3) {
      outline.points.resize(start);
      continue;
    }
    outline.points.push_back(outline.points[start]);
    outline.starts.push_back(static_cast<std::uint32_t>(outline.points.size()));
  }
}

std::size_t vertex_count(const Rings& rings) {
  std::size_t count = 0;
  for (const Ring& ring : rings) count += ring.size() + 1;
  return count;
}

}  // namespace

Outline outline_of(const Rings& subject, const Rings& clip) {
  const Sizes a = sizes_of(subject), b = sizes_of(clip);
  if (!a.finite || !b.finite) throw std::invalid_argument("boolean: a coordinate is not finite");
  const std::size_t count = vertex_count(subject) + vertex_count(clip);
  if (count > std::size_t{1} << 31) throw std::length_error("boolean: more than 2^31 vertices");

  Outline outline;
  const double most = std::max(a.most, b.most);
  const bool scaled = most > 0 && (most > largest || std::min(a.least, b.least) < smallest);
  if (scaled) {
    std::frexp(most, &outline.exponent);
    // What a double of the input's scale cannot hold need not be computed: below 2^-1074 there is nothing.
    outline.grid = Grid(std::ldexp(1.0, std::max(-472, -1074 - outline.exponent)));
  }
  outline.points.reserve(count);
  outline.starts.reserve(subject.size() + clip.size() + 1);
  outline.starts.push_back(0);
  append(subject, scaled, outline);
  outline.clip_begin = static_cast<std::uint32_t>(outline.points.size());
  append(clip, scaled, outline);
  return outline;
}

void unscale(const Outline& outline, Regions& regions) {
  if (outline.exponent == 0) return;
  const auto back = [&](Ring& ring) {
    for (Vec2d& p : ring) p = Vec2d(std::ldexp(p.x, outline.exponent), std::ldexp(p.y, outline.exponent));
  };
  for (Region& region : regions) {
    back(region.outer);
    for (Ring& hole : region.holes) back(hole);
  }
}

}  // namespace lambert::polygon::arrangement
