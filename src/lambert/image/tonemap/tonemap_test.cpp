#include "lambert/image/tonemap/tonemap.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace lambert {
namespace {

Rgb mapped(Rgb c, const ToneSettings& settings) {
  Image image(1, 1, rgb_channels());
  image.set_rgb(0, 0, c);
  return tonemap(image, settings).rgb(0, 0);
}

// rows: LF-24
// Luminance is mapped and colours keep their ratios (E-LF-10).
TEST(Tonemap, ReinhardMapsLuminance) {
  const ToneSettings reinhard{.op = tone::Reinhard{}};
  const std::array<std::array<double, 2>, 6> known = {{{0, 0},
                                                       {0.005, 0.00497512437811},
                                                       {0.5, 0.333333333333},
                                                       {1, 0.5},
                                                       {10, 0.909090909091},
                                                       {121.741, 0.991852763135}}};
  for (const auto& [in, out] : known) EXPECT_NEAR(mapped(Rgb(static_cast<float>(in)), reinhard).g, out, 1e-6) << in;
  EXPECT_NEAR(mapped(Rgb(1e-4f), reinhard).g / 1e-4f, 1, 2e-4f) << "slope 1 at 0";
  EXPECT_NEAR(mapped(Rgb(1e7f), reinhard).g, 1, 1e-6f) << "limit 1";

  const Rgb c(0.8f, 0.2f, 0.05f);
  const float scale = 1 / (1 + luminance(c));
  const Rgb shown = mapped(c, reinhard);
  EXPECT_FLOAT_EQ(shown.r, c.r * scale);
  EXPECT_FLOAT_EQ(shown.g, c.g * scale);
  EXPECT_FLOAT_EQ(shown.b, c.b * scale);
}

TEST(Tonemap, CurvesRiseFromBlackToWhite) {
  for (const std::string& name : tone_operator_names()) {
    const ToneSettings settings{.op = tone_operator(name)};
    EXPECT_EQ(mapped(Rgb(0.0f), settings), Rgb(0.0f)) << name;
    float previous = 0;
    for (float x = 1e-4f; x < 1e6f; x *= 1.1f) {
      const float y = mapped(Rgb(x), settings).g;
      EXPECT_GE(y, previous) << name << " " << x;
      EXPECT_LE(y, 1) << name << " " << x;
      previous = y;
    }
    EXPECT_GT(previous, 0.99f) << name;
  }
}

TEST(Tonemap, WhateverComesTheDisplayCanShowIt) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::string& name : tone_operator_names()) {
    const ToneSettings settings{.op = tone_operator(name)};
    for (const float v : {1e20f, std::numeric_limits<float>::max(), inf}) {
      EXPECT_GT(mapped(Rgb(v), settings).g, 0.99f) << name << " " << v;
    }
    for (const Rgb c : {Rgb(-3), Rgb(nan), Rgb(-inf)}) EXPECT_EQ(mapped(c, settings), Rgb(0.0f)) << name;
  }
}

TEST(Tonemap, FilmicFollowsItsFit) {
  const ToneSettings filmic{.op = tone::Filmic{}};
  const auto fit = [](float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); };
  for (const float x : {0.01f, 0.18f, 1.0f, 3.0f}) EXPECT_FLOAT_EQ(mapped(Rgb(x), filmic).r, fit(0.6f * x));
}

TEST(Tonemap, ExposureIsInStops) {
  EXPECT_FLOAT_EQ(mapped(Rgb(0.1f), {.exposure = 2}).r, 0.4f);
  EXPECT_FLOAT_EQ(mapped(Rgb(0.4f), {.exposure = -1}).r, 0.2f);
  EXPECT_FLOAT_EQ(mapped(Rgb(0.25f), {.op = tone::Reinhard{}, .exposure = 2}).r, 0.5f);
}

TEST(Tonemap, KeepsAlphaAndMetadataAndDropsOtherChannels) {
  Image image(1, 1, {"R", "G", "B", "A", "Z"});
  image.at(0, 0, 3) = 0.5f;
  image.metadata["seed"] = "7";
  const Image shown = tonemap(image, {.exposure = 3});
  EXPECT_EQ(shown.channels(), rgba_channels());
  EXPECT_EQ(shown.at(0, 0, 3), 0.5f);
  EXPECT_EQ(shown.metadata.at("seed"), "7");
}

TEST(Tonemap, NamesAreSpelledOutInErrors) {
  EXPECT_NE(error_of([] { tone_operator("reinhart"); }).find("reinhard"), std::string::npos);
}

}  // namespace
}  // namespace lambert
