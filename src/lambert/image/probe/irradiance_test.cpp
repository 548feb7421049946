#include "lambert/image/probe/irradiance.h"

#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

const Fisheye whole_equisolid{Lens::equisolid, degrees(360)};

const std::vector<AnyProjection>& maps() {
  static const std::vector<AnyProjection> all{LatLong{},      LatLong{.centre_is_plus_z = true},
                                              Cube{},         Cube{.opengl = true},
                                              EqualArea{},    Octahedral{},
                                              MirrorBall{},   angular_map(),
                                              whole_equisolid};
  return all;
}

// rows: LF-08
TEST(Irradiance, OfAConstantIsPi) {
  const Rgb l(1, 2, 0.5f);
  const auto expect_pi = [&](const AnyProjection& p, TexelRule rule, int rows) {
    Probe map = map_of(
        p, rows, [&](Vec3) { return l; }, 1, rule);
    // Texels at a rim whose middle is not on the disk show a part of it all the same.
    for (Image& chart : map.charts)
      for (int y = 0; y < chart.height(); ++y)
        for (int x = 0; x < chart.width(); ++x) chart.set_rgb(x, y, l);
    const Irradiance e(map);
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Rgb got = e(random_direction(i)) / pi;
      EXPECT_NEAR(got.r, 1, 1e-4f) << p.index() << " " << rows;
      EXPECT_NEAR(got.g, 2, 2e-4f) << p.index() << " " << rows;
      EXPECT_NEAR(got.b, 0.5f, 0.5e-4f) << p.index() << " " << rows;
    }
  };
  for (const AnyProjection& p : maps()) {
    for (const int rows : {1, 2, 64}) expect_pi(p, TexelRule::cells, rows);
    expect_pi(p, TexelRule::edge_to_edge, 13);
  }
}

// rows: LF-08
// A cap of half angle h seen face on: π sin² h, and from behind what of it is over the horizon.
TEST(Irradiance, OfWhatADiskShows) {
  const auto constant = [](const AnyProjection& p) {
    Probe map{p, TexelRule::cells, {Image(96, 96, {"Y"})}};
    for (float& v : map.charts[0].pixels()) v = 1;
    return Irradiance(map);
  };
  const Vec3 ahead(0, 0, -1);
  EXPECT_NEAR(constant(Fisheye{})(ahead).g, pi, 1e-4f * pi);
  EXPECT_NEAR(constant(Fisheye{})({1, 0, 0}).g, 0.5f * pi, 1e-4f * pi);
  EXPECT_NEAR(constant(fisheye(Lens::orthographic, degrees(120)))(ahead).g, 0.75f * pi, 1e-4f * pi);
  EXPECT_NEAR(constant(fisheye(Lens::stereographic, degrees(200)))(-ahead).g, pi * sqr(std::sin(pi / 18)), 1e-4f * pi);
  EXPECT_NEAR(constant(MirrorBall{6})(-ahead).g, pi, 1e-4f * pi);
  EXPECT_NEAR(constant(MirrorBall{6})(ahead).g, pi * (1 - 1.0f / 36), 1e-4f * pi);
}

// rows: LF-08
// L = a + b·d: E = π a + 2π/3 b·n. And L = max(0, d·up)^3 seen face on: 2π/5; one peak is where balls' rims are.
TEST(Irradiance, OfAnalyticEnvironments) {
  const Vec3 b(0.3f, -0.2f, 0.5f), up = normalize(Vec3(1, 2, -0.5f)), behind = normalize(Vec3(0.1f, 0.05f, -1));
  const auto lobe = [](float c) { return c > 0 ? c * c * c : 0; };
  for (const AnyProjection& p : maps()) {
    const bool disk = std::holds_alternative<MirrorBall>(p) || std::holds_alternative<Fisheye>(p);
    const int rows = disk ? 96 : 64, points = disk ? 16 : 4;  // many, for texels of which little is on the disk
    const Irradiance e(map_of(
        p, rows, [&](Vec3 d) { return Rgb(1 + dot(b, d), lobe(dot(d, up)), lobe(std::abs(dot(d, behind)))); }, points));
    constexpr float tolerance = 1e-4f * pi;
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Vec3 n = random_direction(i);
      EXPECT_NEAR(e(n).r, pi + 2 * pi / 3 * dot(b, n), tolerance) << p.index();
    }
    EXPECT_NEAR(e(up).g, 2 * pi / 5, tolerance) << p.index();
    EXPECT_NEAR(e(-up).g, 0, tolerance) << p.index();
    EXPECT_NEAR(e(behind).b, 2 * pi / 5, tolerance) << p.index();
    EXPECT_NEAR(e(-behind).b, 2 * pi / 5, tolerance) << p.index();
  }
}

// rows: LF-08
// Half the sphere: π (1 + cos) / 2.
TEST(Irradiance, OfAnEdge) {
  const Vec3 up = normalize(Vec3(1, 2, -0.5f));
  for (const AnyProjection& p : maps()) {
    const Irradiance e(map_of(
        p, 128, [&](Vec3 d) { return Rgb(dot(d, up) > 0 ? 1.0f : 0.0f); }, 2));
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
        const Vec3 moment = texel_moment(probe, 0, x, y);
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
