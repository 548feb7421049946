#pragma once
/// Finite point sets in the unit square, for looking at and for comparing; rendering uses sampler.h.

#include "lambert/base/vec.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class PatternKind : std::uint8_t { regular, random, jittered, poisson_disk, best_candidate, sobol };
PatternKind pattern_kind(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> pattern_names();

/// The centres of side x side cells, row by row.
std::vector<Vec2> regular_points(int side);
std::vector<Vec2> random_points(int count, std::uint64_t seed);
/// One point somewhere in each of side x side cells, row by row (row AA-13). Neighbours may come arbitrarily close: it
/// is no Poisson-disk pattern, though the notes say so.
std::vector<Vec2> jittered_points(int side, std::uint64_t seed);

/// Dart throwing (Cook 1986; row AA-18): random points of which those nearer than `radius` to an earlier one are thrown
/// away, on the torus. Ends at `count` points or after `most_misses` darts in a row that found no room. Throws Error
/// unless 0 < radius < 0.5.
std::vector<Vec2> poisson_disk_points(double radius, int count, std::uint64_t seed, int most_misses = 20000);
/// The radius at which about `count` points fit: 0.74 of that of a hexagonal packing, where darts still find room.
double poisson_disk_radius(int count);

/// Mitchell 1991 (row AA-19): each point is the one of `candidates_per_point` times as many random candidates as there
/// are points already that lies farthest from them, on the torus. Any prefix is well spread; no distance is guaranteed.
/// O(count² candidates_per_point / 2) distance tests at most; a grid keeps it near O(count^1.5).
std::vector<Vec2> best_candidate_points(int count, std::uint64_t seed, int candidates_per_point = 10);

/// `count` points of a kind; regular and jittered need a square number, and others take any. Throws Error else.
std::vector<Vec2> pattern_points(PatternKind kind, int count, std::uint64_t seed);

/// The smallest distance between two points on the torus; infinite for fewer than two.
double smallest_separation(const std::vector<Vec2>& points);

}  // namespace lambert
