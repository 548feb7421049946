#include "lambert/image/compare/false_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert::compare {
namespace {

/// Oklab to linear Rec. 709 RGB (Ottosson 2020).
Rgb from_oklab(Vec3 lab) {
  const auto cube = [](float v) { return v * v * v; };
  const float l = cube(lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z);
  const float m = cube(lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z);
  const float s = cube(lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z);
  return {4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s,
          -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s,
          -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s};
}

/// Lightness, and the two chromatic axes, at even steps.
constexpr std::array<Vec3, 6> stops{Vec3(0.0f, 0, 0),          Vec3(0.28f, 0.07f, -0.13f), Vec3(0.46f, 0.18f, -0.04f),
                                    Vec3(0.64f, 0.17f, 0.11f), Vec3(0.82f, 0.04f, 0.15f),  Vec3(0.98f, -0.02f, 0.08f)};

}  // namespace

Rgb heat(float t) {
  if (std::isinf(t) && t > 0) return Rgb(1.0f);
  const float at = (t > 0 ? std::min(t, 1.0f) : 0.0f) * static_cast<float>(stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return clamp(from_oklab(glm::mix(stops[i], stops[i + 1], at - static_cast<float>(i))), 0, 1);
}

Image false_colour(const Plane& plane, float top) {
  Image image(plane.width, plane.height, rgb_channels());
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      const float value = plane.row(y)[static_cast<std::size_t>(x)];
      image.set_rgb(x, y, heat(top > 0 ? value / top : (std::isinf(value) ? value : 0.0f)));
    }
  return image;
}

}  // namespace lambert::compare
