#include "lambert/polygon/convex.h"

#include "lambert/polygon/accurate.h"
#include "lambert/polygon/exact_cross.h"
#include "lambert/polygon/predicates.h"

#include <cmath>
#include <numbers>

namespace lambert::polygon {
namespace {

/// Whether the direction from a to b points to [0, pi), counted from +x to the left.
bool upwards(Vec2d a, Vec2d b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }

int sign_of(long double v) { return (v > 0) - (v < 0); }

Ring without_repetitions(const Ring& ring) {
  Ring distinct;
  for (const Vec2d p : ring)
    if (distinct.empty() || p != distinct.back()) distinct.push_back(p);
  while (distinct.size() > 1 && distinct.back() == distinct.front()) distinct.pop_back();
  return distinct;
}

int turn_at(const Ring& ring, std::size_t i) {
  return orientation(ring[previous_index(i, ring.size())], ring[i], ring[next_index(i, ring.size())]);
}

/// A turn by exactly half a revolution; the vertices are distinct.
bool folds_back_at(const Ring& ring, std::size_t i) {
  const Vec2d before = ring[previous_index(i, ring.size())], at = ring[i], after = ring[next_index(i, ring.size())];
  return orientation(before, at, after) == 0 && dot_sign(before, at, at, after) < 0;
}

/// Of distinct vertices: how often the direction passes that of +x, to the left counted positive.
int count_revolutions(const Ring& ring) {
  const std::size_t n = ring.size();
  int passes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool before = upwards(ring[previous_index(i, n)], ring[i]), after = upwards(ring[i], ring[next_index(i, n)]);
    const int turn = folds_back_at(ring, i) ? 1 : turn_at(ring, i);
    passes += turn > 0 && !before && after;
    passes -= turn < 0 && before && !after;
  }
  return passes;
}

}  // namespace

double turning_angle(Vec2d a, Vec2d b, Vec2d c) {
  if (a == b || b == c) return 0;
  if (orientation(a, b, c) == 0) return dot_sign(a, b, b, c) > 0 ? 0 : std::numbers::pi;
  if (products_fit<2>({a, b, c})) return std::atan2(accurate_cross(a, b, b, c), dot(b - a, c - b));
  const auto along = [&](int axis) {
    return exact_difference<WideReal>(b[axis], a[axis]) * exact_difference<WideReal>(c[axis], b[axis]);
  };
  return static_cast<double>(
      std::atan2(exact_cross<WideReal>(a, b, b, c).estimate(), (along(0) + along(1)).estimate()));
}

double total_turning(const Ring& ring) {
  const Ring distinct = without_repetitions(ring);
  const std::size_t n = distinct.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += turning_angle(distinct[previous_index(i, n)], distinct[i], distinct[next_index(i, n)]);
  return sum;
}

int revolutions(const Ring& ring) {
  const Ring distinct = without_repetitions(ring);
  return distinct.size() < 2 ? 0 : count_revolutions(distinct);
}

bool turns_one_way(const Ring& ring) {
  const Ring distinct = without_repetitions(ring);
  bool left = false, right = false;
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const int turn = turn_at(distinct, i);
    left = left || turn > 0, right = right || turn < 0;
  }
  return !(left && right);
}

bool is_convex(const Ring& ring) {
  const Ring distinct = without_repetitions(ring);
  if (distinct.size() < 3 || !turns_one_way(distinct)) return false;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    if (folds_back_at(distinct, i)) return false;
  return std::abs(count_revolutions(distinct)) == 1;
}

int ring_orientation(const Ring& ring) {
  const Ring distinct = without_repetitions(ring);
  if (distinct.size() < 3) return 0;
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < distinct.size(); ++i)
    if (compare_xy(distinct[i], distinct[lowest]) < 0) lowest = i;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    if (i != lowest && distinct[i] == distinct[lowest]) {
      return sign_of(wide_signed_area(ring));
    }
  if (const int turn = turn_at(distinct, lowest)) return turn;
  return sign_of(wide_signed_area(ring));
}

std::vector<std::size_t> reflex_vertices(const Ring& ring) {
  const int sense = ring_orientation(ring);
  std::vector<std::size_t> reflex;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (turn_at(ring, i) * sense < 0) reflex.push_back(i);
  return reflex;
}

QuadSplit split_quad(const std::array<Vec2d, 4>& quad) {
  const Ring ring(quad.begin(), quad.end());
  const int sense = ring_orientation(ring);
  std::size_t start = 0;
  int least = 1;
  for (std::size_t i = 0; i < 4; ++i)
    if (const int turn = turn_at(ring, i) * sense; turn < least) start = i, least = turn;
  const auto at = [start](std::size_t k) { return (start + k) % 4; };
  return {start, {{{at(0), at(1), at(2)}, {at(0), at(2), at(3)}}}};
}

}  // namespace lambert::polygon
