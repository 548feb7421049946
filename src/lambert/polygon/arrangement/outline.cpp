#include "lambert/polygon/arrangement/outline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lambert::polygon::arrangement {
namespace {

/// Coordinates of a size between these, and 0, serve as they are: multiples of 2^-472 whose products are far from the
/// ends of the exponent's range.
constexpr double smallest = 0x1p-420, largest = 0x1p400;

/// Sizes of coordinates as the bits of their absolute values, which sort as those do; zeros do not count as least.
/// Integers, so that the loop becomes vector instructions.
struct Sizes {
  std::int64_t least = std::numeric_limits<std::int64_t>::max(), most = 0;

  void add(double x) {
    const std::int64_t bits = std::bit_cast<std::int64_t>(x) & std::numeric_limits<std::int64_t>::max();
    const std::int64_t counted = bits == 0 ? std::numeric_limits<std::int64_t>::max() : bits;
    most = bits > most ? bits : most;
    least = counted < least ? counted : least;
  }
};

Sizes sizes_of(const Rings& subject, const Rings& clip) {
  Sizes sizes;
  for (const Rings* rings : {&subject, &clip}) {
    for (const Ring& ring : *rings) {
      Sizes here;
      for (const Vec2d p : ring) {
        here.add(p.x);
        here.add(p.y);
      }
      sizes.most = std::max(sizes.most, here.most);
      sizes.least = std::min(sizes.least, here.least);
    }
  }
  return sizes;
}

/// Writes over the points from `size` on, which are there already: one more for each ring than it has vertices.
void append(const Rings& rings, bool scaled, Outline& outline, std::size_t& size) {
  Vec2d* const points = outline.points.data();
  for (const Ring& ring : rings) {
    if (ring.size() < 3) continue;
    const std::size_t start = size;
    Vec2d last(std::numeric_limits<double>::quiet_NaN(), 0);  // differs from all points
    for (Vec2d p : ring) {
      if (scaled) p = outline.grid(Vec2d(std::ldexp(p.x, -outline.exponent), std::ldexp(p.y, -outline.exponent)));
      p = p + Vec2d(0, 0);  // no negative zeros
      if (p == last) continue;
      points[size++] = p;
      last = p;
    }
    while (size > start + 1 && points[size - 1] == points[start]) --size;
    if (size < start + 3) {
      size = start;
      continue;
    }
    points[size++] = points[start];
    outline.starts.push_back(static_cast<std::uint32_t>(size));
  }
}

std::size_t vertex_count(const Rings& rings) {
  std::size_t count = 0;
  for (const Ring& ring : rings) count += ring.size() + 1;
  return count;
}

}  // namespace

Outline outline_of(const Rings& subject, const Rings& clip) {
  const Sizes sizes = sizes_of(subject, clip);
  const auto most = std::bit_cast<double>(sizes.most), least = std::bit_cast<double>(sizes.least);
  if (!std::isfinite(most)) throw std::invalid_argument("boolean: a coordinate is not finite");
  const std::size_t count = vertex_count(subject) + vertex_count(clip);
  if (count > std::size_t{1} << 31) throw std::length_error("boolean: more than 2^31 vertices");

  Outline outline;
  const bool scaled = most > 0 && (most > largest || least < smallest);
  if (scaled) {
    std::frexp(most, &outline.exponent);
    // What a double of the input's scale cannot hold need not be computed: below 2^-1074 there is nothing.
    outline.grid = Grid(std::ldexp(1.0, std::max(-472, -1074 - outline.exponent)));
  }
  outline.points.resize(count);
  outline.starts.reserve(subject.size() + clip.size() + 1);
  outline.starts.push_back(0);
  std::size_t size = 0;
  append(subject, scaled, outline, size);
  outline.clip_begin = static_cast<std::uint32_t>(size);
  append(clip, scaled, outline, size);
  outline.points.resize(size);
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
