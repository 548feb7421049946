#pragma once
#include "lambert/image/hdr/grey.h"

namespace lambert::hdr {

/// Ward 2003: the shift by which reference point p is seen at p + shift in `other`, up to about ±`largest` pixels (the
/// next power of two). Both are cut at the same percentile of their codes, the median unless one is black or white
/// there; pixels within 4 codes of it do not count. From the coarsest picture to the finest the best of 9 shifts.
Vec2i bitmap_shift(const std::vector<Grey>& reference, const std::vector<Grey>& other, int largest);

}  // namespace lambert::hdr
