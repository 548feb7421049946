#include "lambert/light/environment.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/octahedral.h"
#include "lambert/light/environment_map.h"
#include "lambert/light/light_test_tools.h"
#include "lambert/light/many_lights.h"
#include "lambert/sampling/warp.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

constexpr std::array mappings = {EnvironmentMapping::lat_long, EnvironmentMapping::equal_area};

/// Square, dim with a few bright texels and a black part.
Image test_image(int size = 16) {
  Image image(size, size, rgb_channels());
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float base = y > size / 2 && x > size / 2 ? 0.0f : 0.2f + 0.1f * static_cast<float>((x * 7 + y * 3) % 5);
      image.set_rgb(x, y, Rgb(base, 0.5f * base, 2 * base));
    }
  }
  image.set_rgb(5, 3, Rgb(40, 50, 30));
  image.set_rgb(0, 9, Rgb(20));
  return image;
}

EnvironmentLight turned(EnvironmentMapping mapping) {
  return {test_image(), mapping, Rgb(2, 1, 1), Transform::rotate(degrees(50), {1, 2, 3})};
}

TEST(EnvironmentLight, AConstantOneGivesPi) {
  EXPECT_NEAR(irradiance(EnvironmentLight(Rgb(1)), {}, Vec3(0), normalize(Vec3(1, 2, 3))), static_cast<double>(pi),
              5e-3);
}

TEST(EnvironmentLight, SamplesAgreeWithDensityAndRadiance) {
  const JitteredSquare square(40);
  for (const auto mapping : mappings) {
    const EnvironmentLight light = turned(mapping);
    for (int i = 0; i < square.count(); ++i) {
      const auto s = light.sample({}, Vec3(0), square[i]);
      ASSERT_TRUE(s);
      EXPECT_NEAR(length(s->wi), 1, 1e-5f);
      const float pdf = light.pdf_omega(s->wi);
      // Near a border between texels rounding may fall to either side.
      if (std::abs(pdf / s->pdf_omega - 1) > 1e-2f) {
        const float nudged = light.pdf_omega(normalize(s->wi + Vec3(1e-4f, -1e-4f, 1e-4f)));
        const float other = light.pdf_omega(normalize(s->wi - Vec3(1e-4f, -1e-4f, 1e-4f)));
        EXPECT_LT(std::min(std::abs(nudged / s->pdf_omega - 1), std::abs(other / s->pdf_omega - 1)), 2e-2f);
      }
      const Rgb radiance = light.radiance(s->wi);
      EXPECT_NEAR(radiance.g, s->radiance.g, 2e-3f * (1 + s->radiance.g));
    }
  }
}

// rows: PT-21
TEST(EnvironmentLight, DirectionsFollowTheDensity) {
  for (const auto mapping : mappings) {
    const EnvironmentLight light = turned(mapping);
    const auto result = chi_square_of_light(
        light, Vec3(0), [&](Vec3 w) { return light.pdf_omega(w); }, mappings.size());
    EXPECT_TRUE(result) << result.message;
  }
}

// rows: PT-21
// V-PT-11: its function as the luminance of texels whose neighbours repeat them, so that interpolation changes nothing.
TEST(EnvironmentMap, ChoosesRowThenColumn) {
  constexpr int block = 64;
  Image image(2 * block, 2 * block, rgb_channels());
  constexpr float f[2][2] = {{1, 3}, {0, 4}};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) image.set_rgb(x, y, Rgb(f[y / block][x / block]));
  }
  const EnvironmentMap map(image, EnvironmentMapping::equal_area);
  const auto cell_of = [](const EnvironmentMap::Sample& s) { return probe::equal_area_sphere_to_square(s.direction); };
  const Vec2 first = cell_of(*map.sample({0.2f, 0.2f})), second = cell_of(*map.sample({0.3f, 0.6f}));
  EXPECT_LT(first.x, 0.5f);
  EXPECT_LT(first.y, 0.5f);
  EXPECT_GT(second.x, 0.5f);
  EXPECT_GT(second.y, 0.5f);
  constexpr float pdf[2][2] = {{0.5f, 1.5f}, {0, 2}};
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      const Vec3 centre = probe::equal_area_square_to_sphere(
          {0.25f + 0.5f * static_cast<float>(x), 0.25f + 0.5f * static_cast<float>(y)});
      EXPECT_NEAR(map.pdf_omega(centre) * 4 * pi, pdf[y][x], 1e-4f) << x << y;
    }
  }
}

// rows: PT-21
TEST(EnvironmentLight, DensityIntegratesToOneAndIsPositiveWhereThereIsRadiance) {
  const JitteredSquare square(600);
  for (const auto mapping : mappings) {
    const EnvironmentLight light = turned(mapping);
    double sum = 0;
    for (int i = 0; i < square.count(); ++i) {
      const Vec3 d = square_to_uniform_sphere(square[i]);
      const float pdf = light.pdf_omega(d);
      sum += static_cast<double>(pdf);
      if (luminance(light.radiance(d)) > 1e-4f) {
        EXPECT_GT(pdf, 0);
      }
    }
    EXPECT_NEAR(sum * 4 * static_cast<double>(pi) / square.count(), 1, 0.01);
  }
}

// rows: PT-21
TEST(EnvironmentLight, IrradianceIsThatOfUniformSampling) {
  const JitteredSquare square(600);
  const Vec3 n = normalize(Vec3(-1, 2, 0.5f));
  for (const auto mapping : mappings) {
    const EnvironmentLight light = turned(mapping);
    double uniform = 0;
    for (int i = 0; i < square.count(); ++i) {
      const Vec3 d = square_to_uniform_sphere(square[i]);
      uniform += static_cast<double>(luminance(light.radiance(d)) * std::max(0.0f, dot(d, n)));
    }
    uniform *= 4 * static_cast<double>(pi) / square.count();
    EXPECT_NEAR(irradiance(light, {}, Vec3(0), n, 300), uniform, 0.01 * uniform);
  }
}

// rows: PT-21
// E-PT-08: of a constant sky of 64 rows the top row gets 0.00060 of the samples, not 1/64.
TEST(EnvironmentMap, WeightsRowsByTheirSolidAngle) {
  Image sky(128, 64, rgb_channels());
  for (float& v : sky.pixels()) v = 1;
  const EnvironmentMap map(sky, EnvironmentMapping::lat_long);
  const float top = 0.5f * (1 - std::cos(pi / 64));
  EXPECT_NEAR(top, 0.00060f, 5e-6f);
  int in_top_row = 0;
  const JitteredSquare square(500);
  for (int i = 0; i < square.count(); ++i) {
    if (map.sample(square[i])->direction.y > std::cos(pi / 64)) ++in_top_row;
  }
  EXPECT_NEAR(static_cast<float>(in_top_row) / static_cast<float>(square.count()), top, 1e-4f);
  EXPECT_NEAR(map.pdf_omega({0, 0, 1}), 1 / (4 * pi), 1e-3f);
}

TEST(EnvironmentMap, LatLongHasItsTopUpAndItsCentreAheadAndTurnsToTheRight) {
  Image image(8, 4, rgb_channels());
  image.set_rgb(4, 0, Rgb(1)), image.set_rgb(3, 0, Rgb(1));  // the top, ahead
  image.set_rgb(5, 1, Rgb(3));                               // to the right of the centre
  const EnvironmentMap map(image, EnvironmentMapping::lat_long);
  EXPECT_GT(map.radiance(normalize(Vec3(0, 2, -1))).g, map.radiance(normalize(Vec3(0, 2, 1))).g);
  EXPECT_GT(map.radiance(normalize(Vec3(1, 0.5f, -1))).g, 1);
  EXPECT_EQ(map.radiance(normalize(Vec3(-1, 0.5f, -1))).g, 0);
}

TEST(EnvironmentMap, IsContinuousAcrossItsBorders) {
  for (const auto mapping : mappings) {
    const EnvironmentMap map(test_image(), mapping);
    TestNumbers r(2);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 d = r.next_direction(), e = normalize(d + 1e-4f * r.next_in_cube());
      if (std::abs(d.y) > 0.99f) continue;  // at the poles of a map in angles it is not
      EXPECT_NEAR(map.radiance(d).g, map.radiance(e).g, 0.1f) << d.x << " " << d.y << " " << d.z;
    }
  }
}

TEST(EnvironmentLight, PowerIsWhatEntersTheScene) {
  LightContext context;
  context.scene_bounds.add(Vec3(-1)), context.scene_bounds.add(Vec3(1));
  EXPECT_NEAR(EnvironmentLight(Rgb(2)).bounds(context).power, 2 * 4 * pi * pi * 3, 1e-2f);
  Image sky(4, 4, rgb_channels());
  for (float& v : sky.pixels()) v = 1;
  const EnvironmentLight image(sky, EnvironmentMapping::lat_long, Rgb(2), {});
  EXPECT_NEAR(image.bounds(context).power, 2 * 4 * pi * pi * 3, 1e-2f);
}

TEST(EnvironmentLight, ABlackOneGivesNoSamples) {
  const EnvironmentLight black(Image(4, 2, rgb_channels()), EnvironmentMapping::lat_long, Rgb(1), {});
  EXPECT_FALSE(black.sample({}, Vec3(0), Vec2(0.5f)));
  EXPECT_EQ(black.pdf_omega({0, 1, 0}), 0);
}

template <class Make>
std::string error_of(const Make& make) {
  try {
    make();
    return "";
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(EnvironmentLight, RefusesWhatIsNoRadianceMap) {
  Image image = test_image();
  image.set_rgb(2, 1, Rgb(NAN));
  EXPECT_NE(
      error_of([&] { EnvironmentLight(image, EnvironmentMapping::lat_long, Rgb(1), {}); }).find("column 2, row 1"),
      std::string::npos);
  EXPECT_NE(error_of([] {
              EnvironmentLight(Image(4, 2, rgb_channels()), EnvironmentMapping::equal_area, Rgb(1), {});
            }).find("must be square, not 4 by 2"),
            std::string::npos);
  EXPECT_NE(error_of([] { EnvironmentLight(Image(), EnvironmentMapping::lat_long, Rgb(1), {}); }), "");
}

TEST(StudioEnvironment, IsBrightAboveAndDarkBelow) {
  const EnvironmentLight studio = studio_environment();
  EXPECT_GT(luminance(studio.radiance(normalize(Vec3(0.35f, 0.85f, 0.4f)))), 3);
  EXPECT_LT(luminance(studio.radiance({0, -1, 0})), 0.1f);
  const double up = irradiance(studio, {}, Vec3(0), {0, 1, 0});
  EXPECT_GT(up, 2);
  EXPECT_LT(up, 5);
}

}  // namespace
}  // namespace lambert
