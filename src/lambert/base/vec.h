#pragma once
/// Vectors and matrices: GLM's, under the names used everywhere here. Matrices act on columns.

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <numbers>

namespace lambert {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Vec2i = glm::ivec2;
using Vec3i = glm::ivec3;
using Mat3 = glm::mat3;
using Mat4 = glm::mat4;

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

inline constexpr float pi = std::numbers::pi_v<float>;
inline constexpr float inv_pi = std::numbers::inv_pi_v<float>;
/// The largest float below 1: random numbers never exceed it.
inline constexpr float one_minus_epsilon = 0x1.fffffep-1f;

inline float sqr(float x) { return x * x; }
inline float length_squared(Vec3 v) { return dot(v, v); }

inline bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool is_finite(const Mat4& m) {
  bool finite = true;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) finite = finite && std::isfinite(m[column][row]);
  return finite;
}

}  // namespace lambert
