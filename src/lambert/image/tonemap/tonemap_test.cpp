#include "lambert/image/tonemap/tonemap.h"

#include "lambert/base/parallel.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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

/// Those that give every pixel of one colour the same, and need nothing that may be missing.
std::vector<std::string> global_operators() {
  std::vector<std::string> names;
  for (const std::string& name : tone_operator_names())
    if (name != "photographic-local" && name != "durand" && name != "fattal" && name != "mertens" && name != "ocio")
      names.push_back(name);
  return names;
}
std::vector<std::string> built_in_operators() {
  std::vector<std::string> names = tone_operator_names();
  std::erase(names, "ocio");
  return names;
}

/// A row of greys.
Image greys(const std::vector<float>& values) {
  Image image(static_cast<int>(values.size()), 1, rgb_channels());
  for (std::size_t i = 0; i < values.size(); ++i) image.set_rgb(static_cast<int>(i), 0, Rgb(values[i]));
  return image;
}

// rows: LF-21 LF-24
TEST(Tonemap, CurvesRiseFromBlackToWhite) {
  std::vector<float> ramp{0};
  for (float x = 1e-4f; x < 1e7f; x *= 1.1f) ramp.push_back(x);
  for (const std::string& name : global_operators())
    for (const std::string& channels : tone_channels_names()) {
      const Image shown = tonemap(greys(ramp), {.op = tone_operator(name), .channels = tone_channels(channels)});
      EXPECT_EQ(shown.rgb(0, 0), Rgb(0.0f)) << name;
      float previous = 0;
      for (int x = 0; x < shown.width(); ++x) {
        const float y = shown.rgb(x, 0).g;
        EXPECT_GE(y, previous - 1e-6f) << name << " " << ramp[static_cast<std::size_t>(x)];
        EXPECT_LE(y, 1) << name;
        previous = y;
      }
      EXPECT_GT(previous, 0.99f) << name;
    }
}

TEST(Tonemap, WhateverComesTheDisplayCanShowIt) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::string& name : built_in_operators()) {
    const ToneSettings settings{.op = tone_operator(name)};
    for (const float v : {1e20f, std::numeric_limits<float>::max(), inf})
      if (name != "photographic-local") {
        EXPECT_GT(mapped(Rgb(v), settings).g, 0.99f) << name << " " << v;
      }
    for (const Rgb c : {Rgb(-3), Rgb(nan), Rgb(-inf)}) EXPECT_EQ(mapped(c, settings), Rgb(0.0f)) << name;
    const Image mixed = tonemap(greys({0, nan, 1e-30f, 0.5f, -1, 3, inf, 1e-3f, 40, 1e30f}), settings);
    for (const float v : mixed.pixels()) EXPECT_TRUE(v >= 0 && v <= 1) << name << " " << v;
  }
}

TEST(Tonemap, InfiniteLightDoesNotDarkenTheRest) {
  const std::vector<float> values{0.1f, 0.5f, 2, 7, 0.3f, 0.9f};
  std::vector<float> with = values;
  with.push_back(std::numeric_limits<float>::infinity());
  for (const std::string& name : global_operators()) {
    if (name == "reinhard-devlin") continue;  // stretched to the brightest
    const Image a = tonemap(greys(values), {.op = tone_operator(name)}),
                b = tonemap(greys(with), {.op = tone_operator(name)});
    for (int x = 0; x < a.width(); ++x) EXPECT_EQ(a.rgb(x, 0), b.rgb(x, 0)) << name;
  }
}

/// Greys and colours over five decades with edges, slopes and texture.
Image scene(int width, int height, float scale = 1) {
  Image image(width, height, rgb_channels());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(width),
                  v = static_cast<float>(y) / static_cast<float>(height);
      const float light = u > 0.6f ? 300.0f : 0.02f + v;
      const float texture = 1 + 0.3f * std::sin(40 * u) * std::cos(31 * v);
      image.set_rgb(x, y, Rgb(1, 0.6f + 0.3f * v, 0.4f + 0.5f * u) * (light * texture * scale));
    }
  return image;
}

TEST(Tonemap, OperatorsThatMeasureTheMapDoNotSeeItsScale) {
  for (const char* name : {"darkest-range", "darkest-pixels", "photographic", "photographic-local", "drago", "durand",
                           "fattal", "mertens"}) {
    const ToneSettings settings{.op = tone_operator(name)};
    const Image a = tonemap(scene(70, 41), settings), b = tonemap(scene(70, 41, 1024), settings);
    for (std::size_t i = 0; i < a.pixels().size(); ++i) ASSERT_NEAR(a.pixels()[i], b.pixels()[i], 2e-4f) << name;
  }
}

TEST(Tonemap, ThreadsDoNotChangeABit) {
  for (const std::string& name : built_in_operators()) {
    const ToneSettings settings{.op = tone_operator(name)};
    set_thread_count(1);
    const Image one = tonemap(scene(131, 77), settings);
    set_thread_count(0);
    const Image all = tonemap(scene(131, 77), settings);
    EXPECT_TRUE(std::ranges::equal(one.pixels(), all.pixels())) << name;
  }
}

TEST(Tonemap, InPlaceIsTheSame) {
  for (const std::string& name : built_in_operators())
    for (const ToneChannels channels : {ToneChannels::luminance, ToneChannels::rgb}) {
      const ToneSettings settings{.op = tone_operator(name), .channels = channels};
      Image image = scene(33, 21);
      const Image apart = tonemap(image, settings), in_place = tonemap(std::move(image), settings);
      EXPECT_TRUE(std::ranges::equal(apart.pixels(), in_place.pixels())) << name;
    }
}

TEST(Tonemap, TakesAnyImage) {
  for (const std::string& name : built_in_operators())
    for (const auto& channels : std::vector<std::vector<std::string>>{
             {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}, {"R", "G", "B", "A", "Z", "normal.X"}})
      for (const auto& size : {Vec2i(1, 1), Vec2i(1, 9), Vec2i(17, 1), Vec2i(5, 3)}) {
        Image image(size.x, size.y, channels);
        for (std::size_t i = 0; i < image.pixels().size(); ++i) image.pixels()[i] = 0.25f + static_cast<float>(i % 7);
        const Image shown = tonemap(image, {.op = tone_operator(name)});
        EXPECT_EQ(shown.has_colour(), image.has_colour()) << name;
        EXPECT_EQ(shown.channel("A").has_value(), image.channel("A").has_value()) << name;
        for (const float v : shown.pixels()) ASSERT_TRUE(v >= 0 && v <= 1) << name << " " << v;
      }
}

// rows: LF-22
// White by the range of values or by the share of pixels (E-LF-09).
TEST(Tonemap, DarkestByRangeAndByPixels) {
  std::vector<float> values;
  for (int i = 1; i <= 2000; ++i) values.push_back(121.741f * static_cast<float>(i) / 2000);
  const Image map = greys(values);
  const Image range = tonemap(map, {.op = tone::DarkestRange{}}), pixels = tonemap(map, {.op = tone::DarkestPixels{}});
  EXPECT_NEAR(range.rgb(0, 0).g, 0.5f, 1e-5f) << "half of 0.1 % of the largest";
  EXPECT_NEAR(range.rgb(1, 0).g, 1, 1e-5f);
  EXPECT_NEAR(pixels.rgb(0, 0).g, 0.5f, 1e-5f) << "2 of 2000 pixels are not white";
  EXPECT_NEAR(tonemap(map, {.op = tone::DarkestPixels{.percent = 50}}).rgb(499, 0).g, 0.5f, 1e-5f);
  // A map whose values crowd in the dark, as maps do: the readings differ widely.
  std::vector<float> crowded;
  for (int i = 0; i < 5000; ++i) crowded.push_back(std::exp(9.0f * static_cast<float>(i) / 5000));
  const Image by_range = tonemap(greys(crowded), {.op = tone::DarkestRange{}});
  const Image by_pixels = tonemap(greys(crowded), {.op = tone::DarkestPixels{}});
  const auto below_white = [](const Image& image) {
    int count = 0;
    for (int x = 0; x < image.width(); ++x) count += image.rgb(x, 0).g < 1;
    return count;
  };
  EXPECT_NEAR(below_white(by_range), 5000 * (1 - std::log(1000.0) / 9), 3);
  EXPECT_LE(below_white(by_pixels), 5);
}

// rows: LF-24
TEST(Tonemap, ReinhardsWhiteIsWhite) {
  const ToneSettings burn{.op = tone::Reinhard{.white = 4}};
  EXPECT_FLOAT_EQ(mapped(Rgb(4.0f), burn).g, 1);
  EXPECT_FLOAT_EQ(mapped(Rgb(1.0f), burn).g, (1 + 1 / 16.0f) / 2);
}

// rows: LF-21
TEST(Tonemap, LinearScalesToItsWhite) {
  EXPECT_FLOAT_EQ(mapped(Rgb(2.0f), {.op = tone::Linear{.white = 8}}).g, 0.25f);
  const Image shown = tonemap(greys({1, 50}), {.op = tone::Linear{.white = 0}});
  EXPECT_FLOAT_EQ(shown.rgb(0, 0).g, 0.02f);
  EXPECT_FLOAT_EQ(shown.rgb(1, 0).g, 1);
}

// rows: LF-24
// E-LF-10: (8, 2, 0.5) by luminance and by channel.
TEST(Tonemap, ChannelsAreAStatedChoice) {
  const Rgb c(8, 2, 0.5f);
  const Rgb each = mapped(c, {.op = tone::Reinhard{}, .channels = ToneChannels::rgb});
  EXPECT_NEAR(each.r, 8 / 9.0f, 1e-6f);
  EXPECT_NEAR(each.g, 2 / 3.0f, 1e-6f);
  EXPECT_NEAR(each.b, 1 / 3.0f, 1e-6f);
  const Rgb ratios = mapped(c, {.op = tone::Reinhard{}});
  EXPECT_EQ(ratios.r, 1) << "1.92, clipped";
  EXPECT_NEAR(ratios.g, 0.4799f, 1e-4f);
  EXPECT_NEAR(ratios.b, 0.12f, 1e-4f);
}

TEST(Tonemap, SaturationIsTheExponentOfRatios) {
  const Rgb c(0.4f, 0.2f, 0.1f);
  const float l = luminance(c), shown = l / (1 + l);
  for (const float s : {0.5f, 1.0f, 1.5f}) {
    const Rgb out = mapped(c, {.op = tone::Reinhard{}, .saturation = s});
    EXPECT_NEAR(out.r, std::pow(c.r / l, s) * shown, 2e-6f);
    EXPECT_NEAR(out.b, std::pow(c.b / l, s) * shown, 2e-6f);
  }
  const Rgb grey = mapped(c, {.op = tone::Reinhard{}, .saturation = 0.0f});
  EXPECT_NEAR(grey.r, grey.b, 1e-6f);
}

TEST(Tonemap, AlphaIsTakenOutAndPutBack) {
  Image solid(1, 1, rgb_channels()), half(1, 1, rgba_channels());
  solid.set_rgb(0, 0, {3, 1, 0.2f});
  half.set_rgb(0, 0, {1.5f, 0.5f, 0.1f});
  half.at(0, 0, 3) = 0.5f;
  for (const std::string& name : global_operators()) {
    const Rgb a = tonemap(solid, {.op = tone_operator(name)}).rgb(0, 0),
              b = tonemap(half, {.op = tone_operator(name)}).rgb(0, 0);
    EXPECT_NEAR(a.r / 2, b.r, 1e-6f) << name;
    EXPECT_NEAR(a.b / 2, b.b, 1e-6f) << name;
  }
}

TEST(Tonemap, AutoExposurePlacesTheLogAverageAtTheKey) {
  const Image map = greys({2, 8, 32});
  EXPECT_NEAR(auto_exposure_stops(map, {.key = 0.5f, .low = 0, .high = 100}), -4, 1e-5f);
  EXPECT_NEAR(tonemap(map, {.automatic = AutoExposure{.low = 0, .high = 100}}).rgb(1, 0).g, 0.18f, 1e-6f);
  EXPECT_NEAR(tonemap(map, {.exposure = 1, .automatic = AutoExposure{.low = 0, .high = 100}}).rgb(1, 0).g, 0.36f,
              1e-6f);
  std::vector<float> values(98, 4.0f);
  values.push_back(1e-6f), values.push_back(1e9f);
  EXPECT_NEAR(auto_exposure_stops(greys(values), {.key = 1, .low = 1.5f, .high = 98.5f}), -2, 1e-5f)
      << "without the ends";
}

TEST(Tonemap, DragoIsItsFormula) {
  const std::vector<float> values{0.01f, 0.5f, 3, 77};
  double logs = 0;
  for (const float v : values) logs += std::log(static_cast<double>(v)) / 4;
  const double average = std::exp(logs), largest = 77 / average;
  const Image shown = tonemap(greys(values), {.op = tone::Drago{}});
  for (int i = 0; i < 4; ++i) {
    const double l = static_cast<double>(values[static_cast<std::size_t>(i)]) / average;
    const double base = 2 + 8 * std::pow(l / largest, std::log(0.85) / std::log(0.5));
    EXPECT_NEAR(shown.rgb(i, 0).g, std::log(l + 1) / std::log(base) / std::log10(largest + 1), 2e-6) << i;
  }
}

TEST(Tonemap, PhotographicIsItsFormula) {
  const Image shown = tonemap(greys({1, 4, 16}), {.op = tone::Photographic{.key = 0.5f}});
  for (int i = 0; i < 3; ++i) {
    const double l = std::pow(4.0, i) * 0.5 / 4, white = 2;
    EXPECT_NEAR(shown.rgb(i, 0).g, l * (1 + l / (white * white)) / (1 + l), 1e-6) << i;
  }
}

TEST(Tonemap, ReinhardDevlinIsItsFormula) {
  const tone::LuminanceStatistics s{.log_average = 2, .average = 3, .smallest = 1, .largest = 16};
  EXPECT_NEAR(tone::ReinhardDevlin::contrast_of(s), 0.3 + 0.7 * std::pow(0.75, 1.4), 1e-6);
  const Image shown =
      tonemap(greys({1, 2, 9}), {.op = tone::ReinhardDevlin{.intensity = 1, .contrast = 0.6f, .light = 0}});
  const auto v = [](double i) { return i / (i + std::pow(std::exp(-1.0) * 4, 0.6)); };
  EXPECT_NEAR(shown.rgb(1, 0).g, (v(2) - v(1)) / (v(9) - v(1)), 2e-6);
}

// The published numbers of Hill's matrices, found again from the primaries.
TEST(Tonemap, AcesMatricesComeFromThePrimaries) {
  const auto in = tone::Aces::input_matrix(), out = tone::Aces::output_matrix();
  EXPECT_NEAR(in[0][0], 0.59719, 2e-3);
  EXPECT_NEAR(in[1][0], 0.35458, 2e-3);
  EXPECT_NEAR(in[2][2], 0.83777, 2e-3);
  EXPECT_NEAR(out[0][0], 1.60475, 5e-3);
  EXPECT_NEAR(out[1][0], -0.53108, 5e-3);
  EXPECT_NEAR(mapped(Rgb(0.18f), {.op = tone::Aces{}}).g, 0.1, 0.01);
}

TEST(Tonemap, AgxKeepsMiddleGreyAndBleachesBrightColours) {
  EXPECT_NEAR(mapped(Rgb(0.18f), {.op = tone::Agx{}}).g, 0.18f, 1e-4f);
  const Rgb blue = mapped(Rgb(0.0f, 0.0f, 200.0f), {.op = tone::Agx{}});
  EXPECT_GT(blue.r, 0.3f) << "goes to white, not to the corner";
  EXPECT_GT(blue.b, blue.r);
  // Slope of the curve at its middle, in the coded value over log2.
  const float up = 0.18f * std::exp2(0.05f), down = 0.18f * std::exp2(-0.05f);
  const auto coded = [](float v) { return std::pow(mapped(Rgb(v), {.op = tone::Agx{}}).g, 1 / 2.2f); };
  EXPECT_NEAR((coded(up) - coded(down)) / 0.1f, 2.2f / 16.5f, 2e-3f);
}

TEST(Tonemap, EveryOperatorExplainsItself) {
  for (const std::string& name : tone_operator_names()) {
    ToneOperator op = tone_operator(name);
    EXPECT_EQ(tone_operator_name(op), name);
    EXPECT_FALSE(tone_operator_summary(op).empty());
    const SettingTable table = tone_operator_settings(op);
    for (const Setting& s : table.settings()) {
      EXPECT_FALSE(s.help.empty()) << name << " " << s.key;
      // Defaults are allowed values.
      SettingTable again = tone_operator_settings(op);
      EXPECT_NO_THROW(again.set(s.key, to_string(s))) << name << " " << s.key;
    }
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
