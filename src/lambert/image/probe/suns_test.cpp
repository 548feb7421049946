#include "lambert/image/probe/suns.h"

#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

Rgb sky(Vec3 d) { return d.y > 0 ? Rgb(0.3f, 0.5f, 0.9f) * (1 + d.y) : Rgb(0.1f); }

// rows: LF-25 LF-27
TEST(Suns, SkyAndSunTogetherLightAsTheMapDid) {
  // Of about one resolution.
  for (const auto& [p, rows] : {std::pair<AnyProjection, int>{LatLong{}, 128}, {Cube{}, 64}, {Octahedral{}, 128}})
    for (const Vec3 towards :
         {Vec3(0.3f, 0.6f, -0.5f), Vec3(0.01f, 0.4f, 1), Vec3(0.02f, 1, 0.01f), Vec3(1, 0.5f, 1)}) {
      const Vec3 sun = normalize(towards);
      const Probe probe =
          map_of(p, rows, [&](Vec3 d) { return sky(d) + (dot(d, sun) > std::cos(0.04f) ? Rgb(20000) : Rgb()); });
      const SunsAndSky found = separate_suns(probe);
      ASSERT_EQ(found.suns.size(), 1u) << p.index();
      const Sun& s = found.suns.front();
      EXPECT_LT(length(s.direction - sun), 0.01f) << p.index();
      EXPECT_NEAR(s.solid_angle, 2 * pi * (1 - std::cos(0.04f)), 0.35f * s.solid_angle);
      EXPECT_NEAR(s.angular_radius, 0.04f, 0.006f);
      const Irradiance all(probe), rest(found.sky);
      for (const Vec3 n : {Vec3(0, 1, 0), sun, normalize(sun + Vec3(0.4f, 0, 0.3f))}) {
        const float want = all(n).g, got = rest(n).g + dot(n, s.direction) * s.irradiance.g;
        EXPECT_NEAR(got / want, 1, 1e-4f) << p.index() << " " << sun.x;
      }
      float top = 0;
      for (const Image& chart : found.sky.charts)
        for (const float v : chart.pixels()) top = std::max(top, v);
      EXPECT_LT(top, 2);
    }
}

// Texels so wide that their neighbours' gradients hang on the sun.
TEST(Suns, BooksStayEvenOnCoarseMapsAndAtRims) {
  for (const auto& [p, rows] : {std::pair<AnyProjection, int>{LatLong{}, 32}, {Cube{}, 16}, {MirrorBall{}, 96}})
    for (const Vec3 towards : {Vec3(0.3f, 0.6f, -0.5f), Vec3(0.1f, 0.05f, -1), Vec3(1, 1, 1)}) {
      const Vec3 sun = normalize(towards);
      const Probe probe = map_of(
          p, rows, [&](Vec3 d) { return sky(d) + (dot(d, sun) > std::cos(0.04f) ? Rgb(20000) : Rgb()); }, 6);
      const SunsAndSky found = separate_suns(probe);
      ASSERT_EQ(found.suns.size(), 1u) << p.index();
      const Sun& s = found.suns.front();
      const Irradiance all(probe), rest(found.sky);
      for (const Vec3 n : {s.direction, normalize(s.direction + Vec3(0.4f, 0, 0.3f))}) {
        const float want = all(n).g, got = rest(n).g + dot(n, s.direction) * s.irradiance.g;
        EXPECT_NEAR(got / want, 1, 1e-4f) << p.index() << " " << sun.x;
      }
    }
}

TEST(Suns, ThereMayBeNoneOrSeveral) {
  EXPECT_TRUE(separate_suns(map_of(LatLong{}, 64, sky)).suns.empty());
  EXPECT_TRUE(separate_suns(map_of(LatLong{}, 1, sky)).suns.empty());
  const Vec3 one = normalize(Vec3(1, 1, 1)), two = normalize(Vec3(-1, 0.5f, 0));
  const Probe probe = map_of(LatLong{}, 128, [&](Vec3 d) {
    return sky(d) + (dot(d, one) > 0.999f ? Rgb(500) : Rgb()) + (dot(d, two) > 0.999f ? Rgb(2000) : Rgb());
  });
  const auto found = separate_suns(probe, {.most = 5});
  ASSERT_EQ(found.suns.size(), 2u);
  EXPECT_LT(length(found.suns[0].direction - two), 0.01f);
}

}  // namespace
}  // namespace lambert::probe
