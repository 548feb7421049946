#include "lambert/image/filter/fill_gaps.h"

#include "damage.h"
#include "lambert/base/hash.h"
#include "lambert/image/filter/nearest_covered.h"
#include "lambert/image/filter/pyramid.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// Two charts, red above and blue below, in a green background of alpha 0; sizes that are not powers of two.
Image atlas() {
  Image image(53, 39, rgba_channels());
  for (int y = 0; y < 39; ++y)
    for (int x = 0; x < 53; ++x) {
      const bool red = x > 4 && x < 25 && y > 3 && y < 15, blue = std::hypot(x - 38, y - 26) < 9;
      image.set_rgb(x, y, red ? Rgb(0.8f, 0, 0) : blue ? Rgb(0, 0, 0.6f) : Rgb(0, 1, 0));
      image.at(x, y, 3) = red || blue;
    }
  return image;
}

// rows: AA-23
TEST(FillGaps, NoLevelTakesInBackground) {
  const Image image = atlas();
  const Pyramid bleeding(image);
  float green = 0;
  for (int i = 1; i < bleeding.level_count(); ++i)
    for (int y = 0; y < bleeding.level(i).height(); ++y)
      for (int x = 0; x < bleeding.level(i).width(); ++x)
        if (bleeding.level(i).at(x, y, 3) > 0) green = std::max(green, bleeding.level(i).at(x, y, 1));
  EXPECT_GT(green, 0.5f) << "without filling it does";

  for (const GapFilling method : {GapFilling::push_pull, GapFilling::nearest}) {
    const Image filled = gaps_filled(image, coverage_of(image), method);
    const Pyramid pyramid(filled);
    for (int i = 0; i < pyramid.level_count(); ++i)
      for (int y = 0; y < pyramid.level(i).height(); ++y)
        for (int x = 0; x < pyramid.level(i).width(); ++x) {
          EXPECT_EQ(pyramid.level(i).at(x, y, 1), 0);
          EXPECT_NEAR(pyramid.level(i).at(x, y, 3), 1, 1e-5f);
          // Between red and blue, never darker than either: r / .8 + b / .6 = 1.
          EXPECT_NEAR(pyramid.level(i).at(x, y, 0) / 0.8f + pyramid.level(i).at(x, y, 2) / 0.6f, 1, 1e-4f);
        }
  }
}

// rows: AA-23
TEST(FillGaps, ChartsStayAndGapsContinueThem) {
  const Image image = atlas();
  for (const GapFilling method : {GapFilling::push_pull, GapFilling::nearest}) {
    const Image filled = gaps_filled(image, coverage_of(image), method);
    for (int y = 0; y < 39; ++y)
      for (int x = 0; x < 53; ++x)
        if (image.at(x, y, 3) > 0) {
          EXPECT_EQ(filled.rgb(x, y), image.rgb(x, y));
        }
    EXPECT_NEAR(filled.at(4, 8, 0), 0.8f, 0.1f) << "beside the red chart";
    EXPECT_NEAR(filled.at(38, 16, 2), 0.6f, 0.1f) << "beside the blue one";
  }
}

TEST(FillGaps, NearestIsTheNearest) {
  for (const int share : {2, 20, 300}) {
    Image image(31, 23, {"A"});
    for (int y = 0; y < 23; ++y)
      for (int x = 0; x < 31; ++x) image.at(x, y, 0) = hash_values(x, y, share) % static_cast<unsigned>(share) == 0;
    const auto nearest = nearest_covered(image, 0);
    for (int y = 0; y < 23; ++y)
      for (int x = 0; x < 31; ++x) {
        const auto square = [&](Vec2i p) { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y); };
        int best = 1 << 20;
        for (int j = 0; j < 23; ++j)
          for (int i = 0; i < 31; ++i)
            if (image.at(i, j, 0) > 0) best = std::min(best, square({i, j}));
        const Vec2i found = nearest[static_cast<std::size_t>(y * 31 + x)];
        if (best == 1 << 20) {
          EXPECT_EQ(found, Vec2i(-1));
          continue;
        }
        ASSERT_GE(found.x, 0);
        EXPECT_GT(image.at(found.x, found.y, 0), 0);
        EXPECT_EQ(square(found), best);
      }
  }
}

TEST(FillGaps, PartlyCoveredPixelsAreCompleted) {
  Image image(3, 1, {"Y", "A"});
  image.at(0, 0, 0) = 0.5f, image.at(0, 0, 1) = 0.5f;  // white, half covered
  for (const GapFilling method : {GapFilling::push_pull, GapFilling::nearest}) {
    const Image filled = gaps_filled(image, coverage_of(image), method);
    for (const float v : filled.pixels()) EXPECT_NEAR(v, 1, 1e-6f);
  }
}

TEST(FillGaps, WhatIsUncoveredMayHoldAnything) {
  Image image = noise(16, 16, {"Y", "A"});
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 16; ++j) image.at(i, j, 1) = i < 8;
  image.at(12, 3, 0) = NAN;
  image.at(13, 3, 0) = HUGE_VALF;
  for (const GapFilling method : {GapFilling::push_pull, GapFilling::nearest}) {
    const Image filled = gaps_filled(image, coverage_of(image), method);
    for (const float v : filled.pixels()) EXPECT_TRUE(v >= 0 && v <= 1);
  }
}

TEST(FillGaps, NothingCoveredAndWrongSizes) {
  const Image image = noise(5, 4, {"Y"});
  EXPECT_TRUE(std::ranges::equal(gaps_filled(image, Image(5, 4, {"Y"})).pixels(), image.pixels()));
  EXPECT_NE(error_of([&] { gaps_filled(image, Image(4, 4, {"Y"})); }).find("4x4"), std::string::npos);
  EXPECT_NE(error_of([&] { coverage_of(image); }).find("channel A"), std::string::npos);
  EXPECT_NE(error_of([] { gap_filling("nearst"); }).find("nearest"), std::string::npos);
}

}  // namespace
}  // namespace lambert
