/// Points carried from the square to where they are wanted.

#include "lambert/draw/montage.h"
#include "lambert/draw/plot.h"
#include "lambert/lab/demo.h"
#include "lambert/sampling/distribution.h"
#include "lambert/sampling/patterns.h"
#include "lambert/sampling/rejection.h"
#include "lambert/sampling/warp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace lambert::lab {
namespace {

/// Dots in [-1, 1]² under a title, the unit circle around them.
draw::Drawing scatter(const std::string& title, const std::vector<Vec2>& points,
                      const std::vector<Vec2>& rejected = {}) {
  constexpr double size = 230, top = 30, left = 14;
  const Vec2d centre(left + size / 2, top + size / 2);
  draw::Drawing d{.width = size + 2 * left, .height = size + top + 12, .marks = {}};
  polygon::Ring circle;
  for (int i = 0; i < 96; ++i) {
    const double a = 2 * std::numbers::pi * i / 96;
    circle.push_back(centre + size / 2 * Vec2d(std::cos(a), std::sin(a)));
  }
  d.marks.emplace_back(draw::Stroke{.points = circle, .closed = true, .colour = {140, 149, 159}});
  const auto add = [&](const std::vector<Vec2>& all, const draw::Colour& colour) {
    for (const Vec2 p : all) d.marks.emplace_back(draw::Disk{centre + size / 2 * Vec2d(p.x, -p.y), 1.3, colour});
  };
  add(rejected, {207, 34, 46, 0.55});
  add(points, {9, 80, 180});
  d.marks.emplace_back(draw::Words{{left, 20}, title, {36, 41, 47}, 13});
  return d;
}

std::vector<Vec2> warped(const std::vector<Vec2>& square, const std::function<Vec2(Vec2)>& warp) {
  std::vector<Vec2> points;
  std::transform(square.begin(), square.end(), std::back_inserter(points), warp);
  return points;
}

double share_within(const std::vector<Vec2>& points, float radius) {
  return static_cast<double>(
             std::count_if(points.begin(), points.end(), [&](Vec2 p) { return dot(p, p) < radius * radius; })) /
         static_cast<double>(points.size());
}

/// A sky of one bright sun over a horizon, rows from the zenith.
constexpr int sky_width = 128, sky_height = 64;
float sky(int x, int y) {
  const double theta = std::numbers::pi * (y + 0.5) / sky_height, phi = 2 * std::numbers::pi * (x + 0.5) / sky_width;
  const double toward_sun = std::sin(theta) * std::sin(0.9) * std::cos(phi - 2.2) + std::cos(theta) * std::cos(0.9);
  const double sun = 30 * std::exp(60 * (toward_sun - 1));
  return static_cast<float>((theta < std::numbers::pi / 2 ? 0.35 + 0.4 * std::sin(theta) : 0.08) + sun);
}

std::vector<float> weighted_by_sine(std::vector<float> weights) {
  for (int y = 0; y < sky_height; ++y)
    for (int x = 0; x < sky_width; ++x)
      weights[static_cast<std::size_t>(y * sky_width + x)] *=
          static_cast<float>(std::sin(std::numbers::pi * (y + 0.5) / sky_height));
  return weights;
}

}  // namespace

Shown show_rejection(const LabSettings& settings) {
  const auto numbers = random_points(1400, settings.seed);
  std::size_t at = 0;
  const auto next = [&] {
    const Vec2 p = numbers[at / 2];
    return at++ % 2 == 0 ? p.x : p.y;
  };
  std::vector<Vec2> kept, thrown;
  while (kept.size() < 1000) {
    const Vec2 proposal = 2.0f * numbers[at / 2] - 1.0f;
    if (const auto accepted = disk_by_rejection(next, 1)) {
      kept.push_back(accepted->value);
    } else {
      thrown.push_back(proposal);
    }
  }
  const double share = static_cast<double>(kept.size()) / static_cast<double>(kept.size() + thrown.size());
  return {scatter(fmt::format("{} of {} darts accepted", kept.size(), kept.size() + thrown.size()), kept, thrown),
          {{"share accepted", share}, {"pi / 4", std::numbers::pi / 4}}};
}

Shown show_disk(const LabSettings& settings) {
  const auto square = jittered_points(32, settings.seed);
  const auto plain = warped(square, [](Vec2 u) {
    const float a = 2 * pi * u.y;
    return u.x * Vec2(std::cos(a), std::sin(a));
  });
  const auto polar = warped(square, square_to_uniform_disk_polar);
  const auto concentric = warped(square, [](Vec2 u) { return square_to_uniform_disk_concentric(u); });
  return {draw::side_by_side({scatter("r = xi: crowded (wrong)", plain), scatter("r = root of xi", polar),
                              scatter("concentric (Shirley, Chiu)", concentric)},
                             3),
          {{"share within half the radius, r = xi", share_within(plain, 0.5f)},
           {"share within half the radius, r = root of xi", share_within(polar, 0.5f)},
           {"share within half the radius, concentric", share_within(concentric, 0.5f)}}};
}

Shown show_sphere(const LabSettings& settings) {
  const auto square = jittered_points(32, settings.seed);
  const auto seen_from_side = [](Vec3 w) { return Vec2(w.x, w.z); };
  double z_sphere = 0, z_uniform = 0, z_cosine = 0;
  const auto n = static_cast<double>(square.size());
  const auto sphere = warped(square, [&](Vec2 u) {
    const Vec3 w = square_to_uniform_sphere(u);
    z_sphere += static_cast<double>(w.z * w.z) / n;
    return seen_from_side(w);
  });
  const auto uniform = warped(square, [&](Vec2 u) {
    const Vec3 w = square_to_uniform_hemisphere(u);
    z_uniform += static_cast<double>(w.z) / n;
    return seen_from_side(w);
  });
  const auto cosine = warped(square, [&](Vec2 u) {
    const Vec3 w = square_to_cosine_hemisphere(u);
    z_cosine += static_cast<double>(w.z) / n;
    return seen_from_side(w);
  });
  return {draw::side_by_side({scatter("sphere: z (up) = 1 - 2 xi", sphere), scatter("hemisphere: z (up) = xi", uniform),
                              scatter("cosine: z (up) = root of xi", cosine)},
                             3),
          {{"mean of z squared on the sphere (1/3)", z_sphere},
           {"mean of z, uniform hemisphere (1/2)", z_uniform},
           {"mean of z, cosine hemisphere (2/3)", z_cosine}}};
}

Shown show_environment(const LabSettings& settings) {
  std::vector<float> brightness;
  for (int y = 0; y < sky_height; ++y)
    for (int x = 0; x < sky_width; ++x) brightness.push_back(sky(x, y));
  const PiecewiseConstant2D naive(brightness, sky_width, sky_height),
      right(weighted_by_sine(brightness), sky_width, sky_height);
  const std::vector<float> constant(brightness.size(), 1.0f);
  const PiecewiseConstant2D naive_constant(constant, sky_width, sky_height),
      right_constant(weighted_by_sine(constant), sky_width, sky_height);

  const auto panel = [&](const std::string& name, const PiecewiseConstant2D& distribution) {
    constexpr int factor = 4;
    Image image(sky_width, sky_height, rgb_channels());
    for (int y = 0; y < sky_height; ++y)
      for (int x = 0; x < sky_width; ++x) {
        const float v = sky(x, y);
        image.set_rgb(x, y, Rgb(v / (1 + v)));
      }
    Image large = draw::magnified(image, factor);
    for (const Vec2 u : jittered_points(20, settings.seed)) {
      const Vec2 uv = distribution.sample(u).uv;
      const int px = std::clamp(static_cast<int>(uv.x * static_cast<float>(large.width())), 1, large.width() - 2);
      const int py = std::clamp(static_cast<int>(uv.y * static_cast<float>(large.height())), 1, large.height() - 2);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) large.set_rgb(px + dx, py + dy, Rgb(0.9f, 0.05f, 0.05f));
    }
    return draw::Panel{name, std::move(large)};
  };
  const double row = 1.0 / sky_height;
  const std::vector<draw::Panel> panels{panel("by brightness alone: too many near the pole", naive),
                                        panel("by brightness times sin theta", right)};
  return {montage(panels, {.columns = 1}),
          {{"probability of the top row of a constant sky, brightness alone",
            static_cast<double>(naive_constant.pdf({0.5f, 0.001f})) * row},
           {"probability of the top row of a constant sky, with sin theta",
            static_cast<double>(right_constant.pdf({0.5f, 0.001f})) * row}}};
}

}  // namespace lambert::lab
