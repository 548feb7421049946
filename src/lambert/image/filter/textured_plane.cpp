#include "lambert/image/filter/textured_plane.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"

#include <cmath>

namespace lambert {

Image textured_plane(const Pyramid& texture, const TexturedPlane& s) {
  if (!(s.field_of_view > 0 && s.field_of_view < 180))
    throw Error("a field of view must lie between 0 and 180 degrees");
  if (!(s.repeat > 0) || !std::isfinite(s.repeat)) throw Error("the texture's side must be positive and finite");
  if (s.samples < 1 || s.samples > 64) throw Error("expected 1 to 64 samples per axis");
  Image out(s.width, s.height, rgb_channels());
  const float half = std::tan(0.5f * s.field_of_view * pi / 180);
  const float step = 2 * half / static_cast<float>(s.width);  // of the picture's plane, at distance 1
  const Vec3 sky(0.35f, 0.5f, 0.8f);
  const float share = 1 / static_cast<float>(s.samples);

  parallel_for(static_cast<std::size_t>(s.height), [&](std::size_t row) {
    for (int x = 0; x < s.width; ++x) {
      Vec3 sum(0);
      for (int sample = 0; sample < s.samples * s.samples; ++sample) {
        const Vec2 within((static_cast<float>(sample % s.samples) + 0.5f) * share,
                          (static_cast<float>(sample / s.samples) + 0.5f) * share);
        const float right = (static_cast<float>(x) + within.x) * step - half;
        const float down = (static_cast<float>(row) + within.y - 0.5f * static_cast<float>(s.height)) * step;
        if (!(down > 0)) {
          sum += sky;
          continue;
        }
        // A direction (right, -down, -1) meets the plane at right / down and at the distance 1 / down.
        const float scale = 1 / (down * s.repeat);
        const Vec2 uv(right * scale, scale);
        const float change = step * share;
        const Footprint footprint{{change * scale, 0}, -uv * (change / down)};
        sum += Vec3(texture.lookup(uv, footprint, s.lookup));
      }
      sum *= share * share;
      out.set_rgb(x, static_cast<int>(row), {sum.x, sum.y, sum.z});
    }
  });
  return out;
}

Image checkerboard(int size, int cells) {
  if (cells < 1 || cells > size) throw Error("a checkerboard needs at least a pixel per square");
  Image out(size, size, rgb_channels());
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const std::int64_t column = std::int64_t{x} * cells / size, line = std::int64_t{y} * cells / size;
      out.set_rgb(x, y, Rgb((column + line) % 2 == 0 ? 1.0f : 0.0f));
    }
  return out;
}

}  // namespace lambert
