#include "lambert/image/hdr/merge.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/hdr/hdr_test_tools.h"
#include "lambert/image/hdr/recover.h"
#include "lambert/image/hdr/samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::hdr {
namespace {

const std::vector<double> five{1.0 / 64, 1.0 / 16, 0.25, 1, 4};

/// One row of pixels with these codes; exposures 1, 2, 4 …
ExposureStack row_of(const std::vector<std::vector<std::uint8_t>>& frames) {
  ExposureStack stack{.width = static_cast<int>(frames[0].size()), .height = 1, .channels = 1};
  double exposure = 1;
  for (const auto& codes : frames)
    stack.frames.push_back({.name = "f", .exposure = exposure, .codes = codes}), exposure *= 2;
  return stack;
}

// rows: LF-11
TEST(Merge, EveryWeightingGivesTheRadianceBack) {
  const Image map = test_map(160, 120);
  const ExposureStack stack = photographs(map, "film", five);
  const Response response = response_named("film", 3, 256);
  for (const std::string& name : weighting_names()) {
    const Merged m = merge(stack, response, {.weights = weighting(name)});
    EXPECT_LT(radiance_error(stack, m.image, map), 0.006) << name;
    EXPECT_EQ(m.saturated + m.black, 0u);
  }
}

// rows: LF-11
// Weights by variance lose least to noise.
TEST(Merge, VarianceIsTheBestWeightUnderNoise) {
  const Image map = test_map(160, 120);
  const SensorNoise sensor{.full_well = 4000, .read_noise = 6};
  const ExposureStack stack = photographs(map, "srgb", five, 8, sensor);
  const Response response = response_named("srgb", 3, 256);
  const auto error = [&](const MergeSettings& s) {
    return radiance_error(stack, merge(stack, response, s).image, map);
  };
  const double known = error({.noise = sensor});
  const double measured = error({.code_noise = measure_noise(stack, response)});
  EXPECT_LT(known, error({.weights = Weighting::hat}));
  EXPECT_LT(known, error({.weights = Weighting::gaussian}));
  EXPECT_LT(known, 1.02 * error({.weights = Weighting::robertson}));
  EXPECT_LT(measured, 1.25 * known);
}

// rows: LF-11
TEST(Merge, KeepsBoundsWherePhotographsEnd) {
  const Response linear = response_named("linear", 1, 256);
  const Merged m = merge(row_of({{255, 0, 102, 200}, {255, 0, 204, 255}}), linear);
  EXPECT_FLOAT_EQ(m.image.at(0, 0, 0), 1);  // at least what saturates the shorter exposure
  EXPECT_EQ(m.image.at(1, 0, 0), 0);
  EXPECT_FLOAT_EQ(m.image.at(2, 0, 0), 0.4f);
  EXPECT_FLOAT_EQ(m.image.at(3, 0, 0), 200 / 255.0f);
  EXPECT_EQ(m.saturated, 1u);
  EXPECT_EQ(m.black, 1u);
  EXPECT_EQ(m.image.metadata.at("hdr.exposures"), "1 2");
}

TEST(Merge, LeavesOutWhatIsNotCoveredOrRejected) {
  ExposureStack stack = row_of({{50, 50, 50}, {200, 200, 200}});
  stack.frames[1].covered = {{1, 3}};
  GhostMasks ghosts{.rejected = {{}, {0, 0, 1}}};
  const Image image = merge(stack, response_named("linear", 1, 256), {}, ghosts).image;
  EXPECT_FLOAT_EQ(image.at(0, 0, 0), 50 / 255.0f);
  EXPECT_GT(image.at(1, 0, 0), 60 / 255.0f);  // near the 100 / 255 of the longer exposure
  EXPECT_FLOAT_EQ(image.at(2, 0, 0), 50 / 255.0f);
}

// rows: LF-11
// JPEG scatters what was saturated to codes below the top: taken for values, they would darken lamps, and by channel.
TEST(Merge, ColouredLampsKeepTheirLightThroughJpeg) {
  Image map = test_map(192, 144);
  for (float& v : map.pixels()) v *= 0.02f;
  const int side = 6, step = 16;
  for (int y = 4; y + side < map.height(); y += step)
    for (int x = 4; x + side < map.width(); x += step)
      for (int i = 0; i < side * side; ++i)
        for (std::size_t c = 0; c < 3; ++c)
          map.at(x + i % side, y + i / side, c) = static_cast<std::size_t>(x / step + y / step) % 3 == c ? 24.0f : 6.0f;
  const ExposureStack stack = through_jpeg(photographs(map, "srgb", five));
  EXPECT_TRUE(usable_codes(stack, 0).scattered);
  const Recovery r = recover_response(stack);
  EXPECT_EQ(r.model, "srgb");
  const Image merged = merge(stack, r.response, {.code_noise = r.noise}).image;
  double found[3] = {}, known[3] = {};
  for (std::size_t i = 0; i < map.pixels().size(); ++i)
    found[i % 3] += static_cast<double>(merged.pixels()[i]), known[i % 3] += static_cast<double>(map.pixels()[i]);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / known[c], 1, 0.12) << c;
}

TEST(Merge, PhotographsWithoutLossSaturateAtTheTopCode) {
  const ExposureStack stack = photographs(test_map(192, 144), "srgb", five, 8, {.full_well = 20000, .read_noise = 5});
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(usable_codes(stack, c).saturated, 255);
    EXPECT_FALSE(usable_codes(stack, c).scattered);
  }
}

// rows: LF-11
// Times in another unit: the radiance is that many times less, nothing else changes.
TEST(Merge, ScalesInverselyWithAllTimes) {
  const Image map = test_map(96, 64);
  ExposureStack stack = photographs(map, "film", five);
  const Image once = merge(stack, recover_response(stack).response).image;
  for (Frame& f : stack.frames) f.exposure *= 8;
  const Image eightfold = merge(stack, recover_response(stack).response).image;
  for (std::size_t i = 0; i < once.pixels().size(); ++i)
    ASSERT_NEAR(8 * eightfold.pixels()[i] / once.pixels()[i], 1, 1e-5);
}

TEST(Merge, DoesNotDependOnTheNumberOfThreads) {
  const Image map = test_map(96, 64);
  const ExposureStack stack = photographs(map, "srgb", five, 8, {.full_well = 4000});
  const auto all = [&] {
    const Recovery r = recover_response(stack);
    return merge(stack, r.response, {.code_noise = r.noise}, find_ghosts(stack, r.response, {.noise = r.noise})).image;
  };
  set_thread_count(1);
  const Image one = all();
  set_thread_count(2);
  const Image two = all();
  set_thread_count(0);
  EXPECT_TRUE(std::equal(one.pixels().begin(), one.pixels().end(), two.pixels().begin()));
}

TEST(Merge, RefusesAResponseOfOtherCodes) {
  EXPECT_THROW(merge(row_of({{1}, {2}}), response_named("linear", 1, 65536)), Error);
}

}  // namespace
}  // namespace lambert::hdr
