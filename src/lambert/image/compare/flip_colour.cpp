#include "lambert/image/compare/flip_colour.h"

#include <algorithm>
#include <cmath>

namespace lambert::compare {
namespace {

/// CIE XYZ of Rec. 709 primaries and a D65 white (IEC 61966-2-1), as rows, and the inverse.
constexpr float to_xyz[3][3] = {{0.41238656f, 0.35759149f, 0.18045049f},
                                {0.21263682f, 0.71518298f, 0.0721802f},
                                {0.01933062f, 0.11919716f, 0.95037259f}};
constexpr float from_xyz[3][3] = {{3.24100326f, -1.53739899f, -0.49861587f},
                                  {-0.96922426f, 1.87592999f, 0.04155422f},
                                  {0.05563942f, -0.20401121f, 1.05714897f}};

Vec3 times(const float (&m)[3][3], Vec3 v) {
  Vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z;
  return result;
}

Vec3 white() { return times(to_xyz, Vec3(1)); }

Vec3 rgb_to_lab(Vec3 rgb) {
  const Vec3 ratio = times(to_xyz, rgb) / white();
  constexpr float delta = 6.0f / 29;
  const auto f = [](float t) { return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29; };
  const float x = f(ratio.x), y = f(ratio.y), z = f(ratio.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Vec3 hunt(Vec3 lab) { return {lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z}; }

float hyab(Vec3 a, Vec3 b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

}  // namespace

Vec3 opponent(Rgb rgb) {
  const Vec3 r = times(to_xyz, {rgb.r, rgb.g, rgb.b}) / white();
  return {116 * r.y - 16, 500 * (r.x - r.y), 200 * (r.y - r.z)};
}

Vec3 hunt_lab(Vec3 o) {
  const float y = (o.x + 16) / 116;
  const Vec3 xyz = Vec3(y + o.y / 500, y, y - o.z / 200) * white();
  return hunt(rgb_to_lab(glm::clamp(times(from_xyz, xyz), 0.0f, 1.0f)));
}

float colour_error(Vec3 a, Vec3 b) {
  static const float most = std::pow(hyab(hunt(rgb_to_lab({0, 1, 0})), hunt(rgb_to_lab({0, 0, 1}))), 0.7f);
  constexpr float knee = 0.4f, top = 0.95f;
  const float distance = std::pow(hyab(a, b), 0.7f);
  if (distance < knee * most) return distance * top / (knee * most);
  return std::min(1.0f, top + (distance - knee * most) / (most - knee * most) * (1 - top));
}

}  // namespace lambert::compare
