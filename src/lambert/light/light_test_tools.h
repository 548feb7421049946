#pragma once
/// What the tests of several lights share.

#include "lambert/base/hash.h"
#include "lambert/light/light.h"
#include "statistics/chi_square.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace lambert {

/// Jittered samples of the unit square, the same in every run.
class JitteredSquare {
 public:
  explicit JitteredSquare(int side) : side_(side) {}
  int count() const { return side_ * side_; }
  Vec2 operator[](int i) const {
    const Vec2 jitter(hash_to_float(hash_values(i, 0)), hash_to_float(hash_values(i, 1)));
    return glm::min((Vec2(i % side_, i / side_) + jitter) / static_cast<float>(side_), Vec2(one_minus_epsilon));
  }

 private:
  int side_;
};

/// Irradiance on a surface at `p` with unit `normal`, by samples of the light.
template <class L>
double irradiance(const L& light, const LightContext& context, Vec3 p, Vec3 normal, int side = 200) {
  const JitteredSquare square(side);
  double sum = 0;
  for (int i = 0; i < square.count(); ++i) {
    const auto s = light.sample(context, p, square[i]);
    const float cos = s ? dot(s->wi, normal) : 0;
    if (cos > 0) sum += static_cast<double>(luminance(s->radiance) * cos / s->pdf_omega);
  }
  return sum / square.count();
}

/// Directions sampled from a light seen from `from`, against a density towards a direction (0 beside the light).
template <class L, class Pdf>
statistics::TestResult chi_square_of_light(const L& light, Vec3 from, const Pdf& pdf, std::size_t tests) {
  // Lights have sharp edges, which should not run along those of the bins; and bins across them need a fine integral.
  const Transform turn = Transform::rotate(degrees(35), {1, 2, 3});
  statistics::SphereTest settings;
  settings.subdivisions = 32, settings.tests = static_cast<int>(tests);
  const auto sample = [&](Vec2 u, float) -> std::optional<Vec3> {
    const auto s = light.sample(LightContext{}, from, u);
    return s ? std::optional(turn.vector(s->wi)) : std::nullopt;
  };
  const auto density = [&](Vec3 w) { return static_cast<double>(pdf(turn.inverse().vector(w))); };
  return statistics::chi_square_sphere(sample, density, settings);
}

/// Where the ray from `from` meets a plane.
inline std::optional<Vec3> meet_plane(Vec3 from, Vec3 direction, Vec3 on_plane, Vec3 normal) {
  const float t = dot(on_plane - from, normal) / dot(direction, normal);
  return t > 0 && t < 1e6f ? std::optional(from + t * direction) : std::nullopt;
}

/// Lambert's formula for a polygon of radiance 1 all above the horizon: E = 1/2 Σ Θᵢ n·Γᵢ, Θᵢ the angle under which an
/// edge is seen and Γᵢ the normal of its plane.
inline double lambert_polygon_irradiance(Vec3 p, Vec3 normal, std::span<const Vec3> vertices) {
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3d a = glm::normalize(Vec3d(vertices[i] - p));
    const Vec3d b = glm::normalize(Vec3d(vertices[(i + 1) % vertices.size()] - p));
    sum += std::acos(glm::dot(a, b)) * glm::dot(Vec3d(normal), glm::normalize(glm::cross(a, b)));
  }
  return 0.5 * std::abs(sum);
}

/// A two-by-two checkerboard of the given radiances over the unit square of texture coordinates.
inline TextureSet checkerboard(Rgb even, Rgb odd) {
  TextureSet set;
  const TextureId a = set.add(ConstantTexture{{even.r, even.g, even.b, 1}});
  const TextureId b = set.add(ConstantTexture{{odd.r, odd.g, odd.b, 1}});
  CheckerboardTexture c;
  c.even = a, c.odd = b;
  c.uv.matrix = {2, 0, 0, 2, 0, 0};
  set.add(c);
  return set;
}

}  // namespace lambert
