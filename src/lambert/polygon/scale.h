#pragma once
/// How the module treats coordinates of any size. Decisions (predicates.h) are exact for all finite doubles, but fast
/// only while products of coordinates are doubles themselves; sums of products overflow or vanish beyond that. So what
/// decides often or adds up products first multiplies everything by one power of two, which is exact, and divides the
/// coordinates of its result by it: answers are the same to the bit as at an ordinary size.
///
/// Coordinates of one input may be of any different sizes. Where no power of two suits them all (some 2^-415 times as
/// large as others, or less), decisions stay exact and take longer; sums lose what is below 2^-800 of the largest
/// part; the Boolean operations round to a grid of 2^-472 of the largest coordinate (boolean.h).

#include "lambert/polygon/box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace lambert::polygon {

/// The sizes of the coordinates that are not 0.
struct Sizes {
  double least = std::numeric_limits<double>::infinity(), most = 0;

  void add(double coordinate) {
    const double size = std::abs(coordinate);
    most = std::max(most, size);
    least = std::min(least, size == 0 ? std::numeric_limits<double>::infinity() : size);
  }
  void add(Vec2d p) { add(p.x), add(p.y); }
  void add(std::span<const Vec2d> points) {
    for (const Vec2d p : points) add(p);
  }
  void add(const Rings& rings) {
    for (const Ring& ring : rings) add(ring);
  }
};

inline Sizes sizes_of(std::span<const Vec2d> points) {
  Sizes sizes;
  sizes.add(points);
  return sizes;
}
inline Sizes sizes_of(const Rings& rings) {
  Sizes sizes;
  sizes.add(rings);
  return sizes;
}

/// The power of two that brings the largest size near 2^200, where products of four differences fit when the least is
/// above 2^-215; 1 where all sizes lie between these anyhow, or where some coordinate would lose bits.
inline double safe_scale(const Sizes& sizes) {
  if (!(sizes.most > 0) || (sizes.least >= 0x1p-215 && sizes.most <= 0x1p200)) return 1;
  const double scale = std::ldexp(1, std::clamp(200 - std::ilogb(sizes.most), -1020, 1020));
  return sizes.least * scale >= std::numeric_limits<double>::min() ? scale : 1;
}

/// The power of two that brings a size near 1, for sums in which what vanishes beside the largest part may be lost; 1
/// for sizes from 2^-200 to 2^200, and for 0.
inline double unit_scale(double most) {
  if (!(most > 0) || !std::isfinite(most) || (most >= 0x1p-200 && most <= 0x1p200)) return 1;
  return std::ldexp(1, std::clamp(-std::ilogb(most), -1020, 1020));
}

/// Whether multiplying by a power of two can be undone.
inline bool keeps(double scale, Vec2d p) { return scale == 1 || (p * scale) / scale == p; }

inline Ring scaled(Ring ring, double scale) {
  for (Vec2d& p : ring) p *= scale;
  return ring;
}
inline Rings scaled(Rings rings, double scale) {
  for (Ring& ring : rings)
    for (Vec2d& p : ring) p *= scale;
  return rings;
}

/// Of a vector of 2 or 3 components.
template <class Vector>
double largest_component(const Vector& v) {
  double most = 0;
  for (int i = 0; i < Vector::length(); ++i) most = std::max(most, std::abs(v[i]));
  return most;
}

/// The length of a vector of any size.
template <class Vector>
double safe_length(const Vector& v) {
  const double scale = unit_scale(largest_component(v));
  return length(v * scale) / scale;
}

}  // namespace lambert::polygon
