#include "lambert/image/probe/irradiance.h"

#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

const std::vector<AnyProjection>& maps() {
  static const std::vector<AnyProjection> all{LatLong{}, Cube{}, EqualArea{}, Octahedral{}, angular_map()};
  return all;
}

// rows: LF-08
TEST(Irradiance, OfAConstantIsPi) {
  for (const AnyProjection& p : maps()) {
    const Irradiance e(map_of(p, 128, [](Vec3) { return Rgb(1, 2, 0.5f); }));
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Rgb got = e(random_direction(i));
      const float tolerance = std::holds_alternative<Fisheye>(p) ? 3e-4f : 1e-4f;
      EXPECT_NEAR(got.r / pi, 1, tolerance) << p.index();
      EXPECT_NEAR(got.g / pi, 2, 2 * tolerance) << p.index();
      EXPECT_NEAR(got.b / pi, 0.5f, tolerance) << p.index();
    }
  }
}

// rows: LF-08
// L = a + b·d: E = π a + 2π/3 b·n. And L = max(0, d·up)^3 seen face on: 2π/5.
TEST(Irradiance, OfAnalyticEnvironments) {
  const Vec3 b(0.3f, -0.2f, 0.5f), up = normalize(Vec3(1, 2, -0.5f));
  for (const AnyProjection& p : maps()) {
    const Irradiance e(map_of(
        p, 128,
        [&](Vec3 d) {
          const float c = std::max(0.0f, dot(d, up));
          return Rgb(1 + dot(b, d), c * c * c, dot(d, up) > 0 ? 1.0f : 0.0f);
        },
        2));
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Vec3 n = random_direction(i);
      EXPECT_NEAR(e(n).r, pi + 2 * pi / 3 * dot(b, n), (p.index() == 0 || p.index() == 3 ? 1e-4f : 3e-4f) * pi)
          << p.index();
    }
    EXPECT_NEAR(e(up).g, 2 * pi / 5, (p.index() == 0 || p.index() == 3 ? 1e-4f : 3e-4f) * pi) << p.index();
    EXPECT_NEAR(e(-up).g, 0, 1e-4f * pi) << p.index();
    // Half the sphere: π (1 + cos) / 2.
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Vec3 n = random_direction(i + 77);
      EXPECT_NEAR(e(n).b, pi * (1 + dot(n, up)) / 2, 2e-3f * pi) << p.index();
    }
  }
}

TEST(Irradiance, TreeAndLoopAgree) {
  const Probe probe = map_of(LatLong{}, 60, pattern);  // no power of two
  const Irradiance e(probe);
  const TexelMeasure m = texel_measure(probe);
  for (std::uint64_t i = 0; i < 10; ++i) {
    const Vec3 n = random_direction(i);
    double sum = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 120; ++x) {
        const Vec3 moment = texel_moment(probe, 0, x, y, m.solid_angle[static_cast<std::size_t>(y * 120 + x)]);
        sum += static_cast<double>(std::max(0.0f, dot(moment, n)) * probe.charts[0].rgb(x, y).g);
      }
    EXPECT_NEAR(static_cast<double>(e(n).g), sum, 1e-3 * sum);
  }
}

// rows: LF-08
TEST(DiffuseMap, OfAConstantIsTheConstant) {
  const Probe map = diffuse_map(map_of(Cube{}, 32, [](Vec3) { return Rgb(2); }), 8);
  ASSERT_EQ(map.charts.size(), 6u);
  for (const float v : map.charts[3].pixels()) EXPECT_NEAR(v, 2, 2e-3f);
}

}  // namespace
}  // namespace lambert::probe
