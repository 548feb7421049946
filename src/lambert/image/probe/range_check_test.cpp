#include "lambert/image/probe/range_check.h"

#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

Rgb sky(Vec3 d) { return d.y > 0 ? Rgb(0.3f, 0.5f, 0.9f) * (1 + d.y) : Rgb(0.1f); }

// rows: LF-25
TEST(RangeCheck, SeesAClippedSunAndWhatIsMissing) {
  const Vec3 sun = normalize(Vec3(0.5f, 0.7f, -0.5f));
  const auto with_sun = [&](float top) {
    return map_of(LatLong{}, 128, [&](Vec3 d) {
      const float c = dot(d, sun);
      return sky(d) + (c > std::cos(0.05f) ? Rgb(std::min(top, 3e4f * (1 + c))) : Rgb());
    });
  };
  const Probe whole = with_sun(1e9f), clipped = with_sun(600);
  const RangeReport good = check_range(whole), bad = check_range(clipped);
  EXPECT_TRUE(bad.clipped);
  EXPECT_NEAR(bad.plateau_value, 600, 2);
  EXPECT_LT(length(bad.plateau_direction - sun), 0.03f);
  EXPECT_NEAR(bad.plateau_solid_angle, 2 * pi * (1 - std::cos(0.05f)), 2e-3f);
  EXPECT_NEAR(good.stops, std::log2(good.ratio), 1e-4f);
  EXPECT_FALSE(check_range(map_of(LatLong{}, 32, sky)).clipped);
  const Vec3 up(0, 1, 0);
  const Rgb truth = Irradiance(whole)(up);
  EXPECT_NEAR(good.irradiance_up.g, truth.g, 2e-3f * truth.g);
  const auto factor = missing_factor(clipped, {up, truth});
  ASSERT_TRUE(factor);
  EXPECT_NEAR(factor->g, 6e4f / 600, 2);
  EXPECT_NEAR(Irradiance(restored(clipped, *factor))(up).g, truth.g, 1e-3f * truth.g);
  EXPECT_FALSE(missing_factor(clipped, {-up, truth}));
}

}  // namespace
}  // namespace lambert::probe
