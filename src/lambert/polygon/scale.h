#pragma once
/// Powers of two that bring coordinates of any size into the range in which the predicates are exact.

#include "lambert/polygon/box.h"

#include <algorithm>
#include <cmath>

namespace lambert::polygon {

/// The largest |coordinate|; 0 when empty.
inline double extent_of(const Box2& box) {
  if (box.empty()) return 0;
  return std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
}

/// 1 while `extent` lies in 2^-100 to 2^200 or is 0; else the power of two (within 2^-1020 to 2^1020) that brings it to
/// about 1. Multiplied by it, coordinates keep all their bits, those apart that fall below 2^-1022, which are more than
/// 2^-900 times smaller than the largest.
inline double scale_to_safe(double extent) {
  if (!(extent > 0) || (extent >= 0x1p-100 && extent <= 0x1p200)) return 1;
  return std::ldexp(1, std::clamp(-std::ilogb(extent), -1020, 1020));
}

}  // namespace lambert::polygon
