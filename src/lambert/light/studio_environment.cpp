#include "lambert/light/environment.h"

#include <cmath>

namespace lambert {
namespace {

float smooth_step(float edge0, float edge1, float x) {
  const float t = std::clamp((x - edge0) / (edge1 - edge0), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// A ceiling that grows brighter towards the top, a floor, a softbox above and to the right, a dim one to the left.
Rgb studio_radiance(Vec3 d) {
  const Vec3 key = normalize(Vec3(0.35f, 0.85f, 0.4f)), fill = normalize(Vec3(-0.85f, 0.3f, 0.45f));
  Rgb sum = lerp(Rgb(0.06f), lerp(Rgb(0.18f), Rgb(0.4f), std::max(d.y, 0.0f)), smooth_step(-0.1f, 0.1f, d.y));
  sum += Rgb(4.2f, 4.0f, 3.8f) * smooth_step(0.82f, 0.88f, dot(d, key));
  sum += Rgb(0.6f, 0.66f, 0.75f) * smooth_step(0.86f, 0.94f, dot(d, fill));
  return sum;
}

}  // namespace

EnvironmentLight studio_environment() {
  constexpr int width = 128, height = 64;
  Image image(width, height, rgb_channels());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float theta = pi * (static_cast<float>(y) + 0.5f) / height;
      const float phi = 2 * pi * ((static_cast<float>(x) + 0.5f) / width - 0.5f);
      image.set_rgb(
          x, y, studio_radiance({std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)}));
    }
  }
  return {image, EnvironmentMapping::lat_long, Rgb(1.0f), Transform()};
}

}  // namespace lambert
