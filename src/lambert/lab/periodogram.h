#pragma once
#include "lambert/base/vec.h"

#include <span>
#include <vector>

namespace lambert::lab {

/// The power |Σ exp(-2πi k·x)|² / n of a point set at the integer frequencies k in [-reach, reach]², (2 reach + 1)²
/// values, rows from ky = -reach. Random points have an expected power of 1 everywhere but at 0, where it is n.
/// O(n reach²).
std::vector<double> periodogram(std::span<const Vec2> points, int reach);

/// The mean over all k with |k| in [r - 1/2, r + 1/2), for r = 0 … reach.
std::vector<double> radial_mean(std::span<const double> power, int reach);

}  // namespace lambert::lab
