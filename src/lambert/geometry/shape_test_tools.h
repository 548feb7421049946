#pragma once
/// For tests of shapes: random numbers and lines, and all hits along a line.

#include "lambert/base/frame.h"
#include "lambert/base/hash.h"
#include "lambert/geometry/shape.h"
#include "lambert/sampling/warp.h"

#include <cmath>
#include <limits>
#include <vector>

namespace lambert {

class Random {
 public:
  explicit Random(int seed) : state_(hash_values(seed)) {}
  float number() { return hash_to_float(mix_bits(state_ += 0x9e3779b97f4a7c15ull)); }
  float between(float a, float b) { return a + (b - a) * number(); }
  Vec2 square() {
    const float x = number();
    return {x, number()};
  }
  Vec3 cube(float half) {
    const float x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }
  Vec3 direction() { return square_to_uniform_sphere(square()); }

 private:
  std::uint64_t state_;
};

/// A line of the isotropic uniform measure on the lines that meet the sphere, from outside of it. A surface of area A
/// within the sphere is met A / (2π radius²) times on average (Cauchy and Crofton), evenly over its area.
inline Ray random_line(Random& random, Vec3 centre, float radius) {
  const Frame frame(random.direction());
  const Vec2 p = radius * square_to_uniform_disk_polar(random.square());
  return {.origin = centre + p.x * frame.s + p.y * frame.t - 2 * radius * frame.n, .direction = frame.n};
}

template <class ShapeType>
std::vector<ShapeHit> all_hits(const ShapeType& shape, Ray ray) {
  std::vector<ShapeHit> hits;
  while (const auto hit = shape.intersect(ray)) {
    hits.push_back(*hit);
    ray.t_min = std::nextafter(hit->t, std::numeric_limits<float>::infinity());
  }
  return hits;
}

}  // namespace lambert
