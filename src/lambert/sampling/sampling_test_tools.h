#pragma once
#include "lambert/base/hash.h"
#include "lambert/base/vec.h"

#include <cmath>
#include <cstdint>

namespace lambert {

/// Independent numbers in [0,1), the same for the same seed.
class TestNumbers {
 public:
  explicit TestNumbers(std::uint64_t seed) : state_(mix_bits(seed + 1)) {}
  float operator()() { return hash_to_float(mix_bits(state_ += 0x9e3779b97f4a7c15ull)); }
  Vec2 pair() {
    const float x = (*this)();
    return {x, (*this)()};
  }

 private:
  std::uint64_t state_;
};

/// Mean and standard error of values added one by one.
class Mean {
 public:
  void add(double x) { ++n_, sum_ += x, squares_ += x * x; }
  double value() const { return sum_ / n_; }
  double variance() const { return (squares_ - sum_ * sum_ / n_) / (n_ - 1); }  ///< of one value
  double standard_error() const { return std::sqrt(variance() / n_); }

 private:
  double n_ = 0, sum_ = 0, squares_ = 0;
};

/// The solid angle of a triangle (Van Oosterom and Strackee 1983), in double.
inline double exact_solid_angle(Vec3d from, Vec3d a, Vec3d b, Vec3d c) {
  a = glm::normalize(a - from), b = glm::normalize(b - from), c = glm::normalize(c - from);
  return 2 * std::abs(std::atan2(glm::dot(a, glm::cross(b, c)), 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a)));
}

}  // namespace lambert
