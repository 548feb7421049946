#include "lambert/material/spectrum.h"

#include "lambert/base/vec.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

void expect_near(Rgb a, Rgb b, float tolerance) {
  EXPECT_NEAR(a.r, b.r, tolerance);
  EXPECT_NEAR(a.g, b.g, tolerance);
  EXPECT_NEAR(a.b, b.b, tolerance);
}

// The fit's stated error is about one percent of the peak. Values of the CIE 1931 table.
TEST(Cie1931, IsNearTheTable) {
  const struct {
    float nm;
    Xyz c;
  } table[] = {{450, {0.3362f, 0.0380f, 1.7721f}},
               {500, {0.0049f, 0.3230f, 0.2720f}},
               {555, {0.5121f, 1.0000f, 0.0057f}},
               {600, {1.0622f, 0.6310f, 0.0008f}},
               {650, {0.2835f, 0.1070f, 0.0000f}}};
  for (const auto& [nm, c] : table) {
    EXPECT_NEAR(cie_1931(nm).x, c.x, 0.03f) << nm;
    EXPECT_NEAR(cie_1931(nm).y, c.y, 0.03f) << nm;
    EXPECT_NEAR(cie_1931(nm).z, c.z, 0.03f) << nm;
  }
}

TEST(Spectrum, D65WhiteIsWhite) { expect_near(xyz_to_rgb({0.95047f, 1, 1.08883f}), Rgb(1), 2e-3f); }

TEST(Spectrum, AConstantReflectanceIsGrey) {
  expect_near(spectrum_to_reflectance_rgb({{400, 0.3f}, {700, 0.3f}}), Rgb(0.3f), 1e-5f);
}

TEST(Spectrum, AConstantEmissionHasTheColourOfEqualEnergyWhite) {
  const Rgb c = spectrum_to_emission_rgb({{500, 2.0f}});
  EXPECT_NEAR(luminance(c), 2, 0.01f);
  expect_near(c / 2.0f, xyz_to_rgb({1, 1, 1}), 0.02f);
}

TEST(Spectrum, ReflectancesHaveTheirHues) {
  const Rgb red = spectrum_to_reflectance_rgb({{590, 0.0f}, {610, 1.0f}});
  EXPECT_GT(red.r, 5 * std::abs(red.g));
  const Rgb blue = spectrum_to_reflectance_rgb({{480, 1.0f}, {500, 0.0f}});
  EXPECT_GT(blue.b, 5 * std::abs(blue.r));
}

TEST(Spectrum, AnEmptySpectrumIsBlack) { EXPECT_EQ(spectrum_to_emission_rgb({}), Rgb()); }

TEST(Blackbody, HasItsMaximumWhereWienSays) {
  const SpectrumSamples s = blackbody(5000);
  float peak_nm = 0, peak = 0;
  for (const auto& [nm, value] : s) {
    if (value > peak) peak = value, peak_nm = nm;
  }
  EXPECT_NEAR(peak, 1, 1e-4f);
  EXPECT_NEAR(peak_nm, 2.897772e6f / 5000, 5);
}

// A 6504 K black body lies near D65; a candle is orange.
TEST(Blackbody, GrowsBluerWithHeat) {
  const Rgb day = spectrum_to_emission_rgb(blackbody(6504));
  EXPECT_NEAR(day.r / day.g, 1, 0.1f);
  EXPECT_NEAR(day.b / day.g, 1, 0.1f);
  const Rgb candle = spectrum_to_emission_rgb(blackbody(1850));
  EXPECT_GT(candle.r, 2 * candle.g);
  EXPECT_GT(candle.g, 2 * candle.b);
}

}  // namespace
}  // namespace lambert
