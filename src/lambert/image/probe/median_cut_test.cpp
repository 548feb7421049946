#include "lambert/image/probe/median_cut.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

// rows: LF-08
TEST(MedianCut, LightsAddUpAndAreAlike) {
  const Probe probe = map_of(LatLong{}, 64, pattern);
  const Rgb want = total_light(probe);
  for (const int count : {1, 2, 7, 64}) {
    const auto lights = median_cut(probe, count);
    ASSERT_EQ(lights.size(), static_cast<std::size_t>(count));
    Rgb sum;
    int texels = 0;
    for (const CutLight& l : lights) sum += l.irradiance, texels += l.texels.width * l.texels.height;
    EXPECT_NEAR(sum.r, want.r, 1e-4f * want.r);
    EXPECT_NEAR(sum.b, want.b, 1e-4f * want.b);
    EXPECT_EQ(texels, 128 * 64);
    if (count == 64) {
      EXPECT_LT(luminance(lights.front().irradiance), 2 * luminance(lights.back().irradiance));
    }
  }
  // The irradiance of 64 lights is nearly the map's.
  const Irradiance exact(probe);
  const auto lights = median_cut(probe, 64);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Vec3 n = random_direction(i);
    float e = 0;
    for (const CutLight& l : lights) e += std::max(0.0f, dot(l.direction, n)) * l.irradiance.g;
    EXPECT_NEAR(e, exact(n).g, 0.03f * exact(n).g);
  }
  EXPECT_EQ(median_cut(map_of(LatLong{}, 1, pattern), 100).size(), 2u);
  EXPECT_THROW(median_cut(map_of(Cube{}, 4, pattern), 2), Error);
}

}  // namespace
}  // namespace lambert::probe
