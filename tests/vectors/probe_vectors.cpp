#include "vectors.h"

#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/suns.h"
#include "lambert/image/probe/texels.h"

#include <gtest/gtest.h>

#include <numeric>

namespace lambert {
namespace {

using namespace probe;

Probe lat_long(int width, int height, Rgb radiance) {
  Probe map{LatLong{}, TexelRule::cells, {Image(width, height, rgb_channels())}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) map.charts[0].set_rgb(x, y, radiance);
  return map;
}

// rows: LF-05 LF-09 IS-20
const CheckOf solid_angles("V-LF-02", [](const Vector& v) {
  const Probe map = lat_long(v.input.at("width").get<int>(), v.input.at("height").get<int>(), Rgb(1));
  const TexelMeasure m = texel_measure(map);
  v.expect_near(m.solid_angle.front(), v.expected.at("row0"));
  v.expect_near(std::accumulate(m.solid_angle.begin(), m.solid_angle.end(), 0.0), v.expected.at("total"),
                Precision::in_float);
});

// rows: LF-27
// A sky with one bright texel: the light of its parts is that of the whole.
const CheckOf sky_and_sun("V-LF-15", [](const Vector& v) {
  const auto rgb = [](const nlohmann::json& j) { return Rgb(j[0].get<float>(), j[1].get<float>(), j[2].get<float>()); };
  const Rgb sky = rgb(v.input.at("sky")), sun = rgb(v.input.at("sun"));
  const Vec3 both(sky.r + sun.r, sky.g + sun.g, sky.b + sun.b);
  v.expect_near(both, v.expected.at("both"));
  // Such irradiances, as a map gives them: the sky's of constant radiance, the sun's by a small bright disk.
  Probe map = lat_long(64, 32, sky / pi);
  const float e = texel_moment(map, 0, 20, 5).y;
  map.charts[0].set_rgb(20, 5, sky / pi + sun / e);
  const SunsAndSky parts = separate_suns(map, {.contrast = 5});
  ASSERT_EQ(parts.suns.size(), 1u);
  const Rgb together = Irradiance(parts.sky)({0, 1, 0}) + parts.suns[0].direction.y * parts.suns[0].irradiance;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(together[k], both[k], 1e-4f);
});

}  // namespace
}  // namespace lambert
