#include "lambert/image/probe/projection.h"

#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

#include <numeric>

namespace lambert::probe {
namespace {

struct Case {
  std::string name;
  AnyProjection projection;
  double seen = 4 * std::numbers::pi;  // solid angle
};

std::vector<Case> cases() {
  const auto cap = [](float half_degrees) {
    return 2 * std::numbers::pi * (1 - std::cos(static_cast<double>(half_degrees) * std::numbers::pi / 180));
  };
  return {
      {"lat-long", LatLong{}},
      {"openexr-lat-long", LatLong{.centre_is_plus_z = true}},
      {"mirror-ball", MirrorBall{}},
      {"mirror-ball at 6", MirrorBall{.distance = 6}, cap(180 - std::asin(1 / 6.0f) * 180 / pi)},
      {"angular", angular_map()},
      {"equidistant", Fisheye{}, cap(90)},
      {"equisolid", Fisheye{Lens::equisolid, degrees(220)}, cap(110)},
      {"stereographic", Fisheye{Lens::stereographic, degrees(200)}, cap(100)},
      {"orthographic", Fisheye{Lens::orthographic, degrees(170)}, cap(85)},
      {"cube", Cube{}},
      {"opengl", Cube{.opengl = true}},
      {"octahedral", Octahedral{}},
      {"equal-area", EqualArea{}},
  };
}

/// No rim, where square roots lose digits.
bool disk_free(const AnyProjection& p) {
  return !std::holds_alternative<MirrorBall>(p) && !std::holds_alternative<Fisheye>(p);
}

// rows: IS-19 IS-20 LF-09
TEST(Projection, DirectionsAndPointsUndoEachOther) {
  for (const Case& c : cases()) {
    int seen = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
      const Vec3 d = random_direction(i);
      const auto p = point(c.projection, d);
      if (!p) continue;
      EXPECT_GE(p->uv.x, -1e-6f) << c.name;
      EXPECT_LE(p->uv.y, 1 + 1e-6f) << c.name;
      const auto back = direction(c.projection, *p);
      if (!back) continue;  // rounded out of the disk
      ++seen;
      EXPECT_NEAR(length(*back), 1, 1e-5f) << c.name;
      // Near the rim of a ball the map compresses without bound.
      EXPECT_LT(length(*back - d), length(disk_free(c.projection) ? Vec3(2e-5f) : Vec3(2e-3f))) << c.name << " " << i;
    }
    EXPECT_NEAR(seen / 4000.0, c.seen / (4 * std::numbers::pi), 0.03) << c.name;
  }
}

// rows: IS-19 IS-20 LF-09
TEST(Projection, DensityIsTheJacobian) {
  constexpr float h = 2e-3f;
  for (const Case& c : cases())
    for (int chart = 0; chart < chart_count(c.projection); ++chart)
      for (int i = 0; i < 144; ++i) {
        const Vec2 uv((static_cast<float>(i % 12) + 0.43f) / 12, (static_cast<float>(i) / 12 + 0.17f) / 12.5f);
        const auto at = [&](float x, float y) { return direction(c.projection, {chart, uv + Vec2(x, y)}); };
        const auto a = at(-h, 0), b = at(h, 0), e = at(0, -h), f = at(0, h);
        const float r = length(2.0f * uv - 1.0f);
        if (!a || !b || !e || !f || r > 0.95f * (disk_free(c.projection) ? 2.0f : 1.0f)) continue;
        const float numeric = length(cross(*b - *a, *f - *e)) / (4 * h * h);
        const float told = density(c.projection, {chart, uv});
        EXPECT_NEAR(numeric, told, 0.01f * told + 0.01f) << c.name << " " << uv.x << " " << uv.y;
      }
}

// rows: IS-19 IS-20 LF-09
TEST(Projection, SolidAnglesOfTexelsAddUp) {
  for (const Case& c : cases())
    for (const TexelRule rule : {TexelRule::cells, TexelRule::edge_to_edge}) {
      Probe probe{c.projection, rule, {}};
      for (int i = 0; i < chart_count(c.projection); ++i) probe.charts.emplace_back(64, 48, rgb_channels());
      const TexelMeasure m = texel_measure(probe);
      const double sum = std::accumulate(m.solid_angle.begin(), m.solid_angle.end(), 0.0) * chart_count(c.projection);
      EXPECT_NEAR(sum, c.seen, 2e-5 * c.seen) << c.name;
    }
}

// The whole chart is the sum of its texels: ∫ d dω of the sphere is 0, of a cap of half angle h it is π sin² h along
// the axis.
TEST(Projection, MomentsOfTexelsAddUp) {
  for (const Case& c : cases()) {
    Probe probe{c.projection, TexelRule::cells, {}};
    for (int i = 0; i < chart_count(c.projection); ++i) probe.charts.emplace_back(47, 64, rgb_channels());
    Vec3d sum(0);
    for (int chart = 0; chart < chart_count(c.projection); ++chart)
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 47; ++x) sum += Vec3d(texel_moment(probe, chart, x, y));
    const double cos_h = 1 - c.seen / (2 * std::numbers::pi), cap = std::numbers::pi * (1 - cos_h * cos_h);
    const double axis = std::holds_alternative<MirrorBall>(c.projection) ? 1 : -1;
    // Folds of octahedral maps run through the middle column.
    const bool folded =
        std::holds_alternative<Octahedral>(c.projection) || std::holds_alternative<EqualArea>(c.projection);
    EXPECT_LT(length(sum - Vec3d(0, 0, axis * cap)), folded ? 6e-4 : 1e-4)
        << c.name << " " << sum.x << " " << sum.y << " " << sum.z;
  }
}

// rows: LF-09
TEST(Projection, EveryMapKnowsWhatIsAhead) {
  const auto uv = [](const AnyProjection& p, Vec3 d) { return point(p, normalize(d)).value(); };
  for (const AnyProjection& p : {AnyProjection(LatLong{}), AnyProjection(angular_map()), AnyProjection(Fisheye{})}) {
    EXPECT_NEAR(uv(p, {0, 0, -1}).uv.x, 0.5f, 1e-6f);
    EXPECT_NEAR(uv(p, {0, 0, -1}).uv.y, 0.5f, 1e-6f);
    EXPECT_GT(uv(p, {0.5f, 0, -1}).uv.x, 0.55f);
    EXPECT_LT(uv(p, {0, 0.5f, -1}).uv.y, 0.45f);
  }
  // A ball shows the camera in its centre, and what is to the right on its right.
  for (const float distance : {std::numeric_limits<float>::infinity(), 8.0f}) {
    const MirrorBall ball{distance};
    EXPECT_NEAR(uv(ball, {0, 0, 1}).uv.x, 0.5f, 1e-6f);
    EXPECT_GT(uv(ball, {1, 0, 0}).uv.x, 0.8f);
    EXPECT_LT(uv(ball, {0, 1, 0}).uv.y, 0.2f);
  }
  EXPECT_NEAR(uv(MirrorBall{}, {1, 0, 0}).uv.x, 0.5f + 0.5f * std::sqrt(0.5f), 1e-6f);
  // A sixth of the sphere behind the ball is hidden from a near camera.
  EXPECT_FALSE(point(MirrorBall{2}, {0, 0, -1}));
  // Debevec's angular map: the radius is the angle.
  EXPECT_NEAR(uv(angular_map(), {1, 0, 0}).uv.x, 0.75f, 1e-6f);
}

// rows: IS-19 LF-13
TEST(Projection, CubeFacesAreViewsOfACamera) {
  for (std::size_t i = 0; i < cube_faces.size(); ++i) {
    const CubeFace& face = cube_faces[i];
    EXPECT_LT(length(cross(face.ahead, face.up) - face.right), 1e-6f) << face.name;
    const auto p = Cube{}.point(face.ahead);
    ASSERT_TRUE(p);
    EXPECT_EQ(p->chart, static_cast<int>(i));
    EXPECT_EQ(p->uv, Vec2(0.5f));
  }
  // OpenGL 4.6, table 8.19: +x has -z along s and -y along t; +y has x and z; +z has x and -y.
  const Cube gl{.opengl = true};
  const auto right_of = [&](int chart) { return *gl.direction({chart, {1, 0.5f}}); };
  EXPECT_LT(right_of(0).z, -0.7f);
  EXPECT_GT(right_of(1).z, 0.7f);
  EXPECT_GT(right_of(2).x, 0.7f);
  EXPECT_GT(right_of(4).x, 0.7f);
  EXPECT_LT(right_of(5).x, -0.7f);
  EXPECT_GT(gl.direction({2, {0.5f, 1}})->z, 0.7f);
  for (int chart = 0; chart < 6; ++chart)
    EXPECT_EQ(gl.point(cube_faces[static_cast<std::size_t>(chart)].ahead)->chart, chart);
}

}  // namespace
}  // namespace lambert::probe
