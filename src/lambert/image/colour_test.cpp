#include "lambert/image/colour.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace lambert {
namespace {

/// The formula in double precision.
int exact_code(float linear) {
  const double x = static_cast<double>(linear);
  return static_cast<int>(std::floor(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055) + 0.5));
}

std::uint8_t code_of(float linear) {
  std::uint8_t code = 0;
  srgb_encode8({&linear, 1}, {&code, 1});
  return code;
}

TEST(Srgb, KnownPoints) {
  EXPECT_EQ(srgb_encode(0.0f), 0);
  EXPECT_NEAR(srgb_encode(1.0f), 1, 1e-6f);
  // IEC 61966-2-1: the code 188 of 255 is half the light, 0.18 is code 118.
  EXPECT_NEAR(255 * srgb_encode(0.5f), 187.516f, 1e-2f);
  EXPECT_NEAR(255 * srgb_encode(0.18f), 117.644f, 1e-2f);
  EXPECT_NEAR(srgb_decode(0.5f), 0.2140411f, 1e-6f);
  EXPECT_FLOAT_EQ(srgb_decode(0.02f), 0.02f / 12.92f);
  EXPECT_FLOAT_EQ(srgb_encode(0.002f), 0.02584f);
}

TEST(Srgb, RoundTrips) {
  for (float x = -2; x <= 8; x += 1 / 64.0f) {
    EXPECT_NEAR(srgb_decode(srgb_encode(x)), x, 2e-6f * (1 + std::abs(x)));
    EXPECT_NEAR(srgb_encode(srgb_decode(x)), x, 2e-6f * (1 + std::abs(x)));
  }
}

TEST(Srgb, RisesWithoutAJumpWhereItsPiecesMeet) {
  float previous = -1;
  for (float x = 0.002f; x < 0.005f; x += 1e-5f) {
    EXPECT_GT(srgb_encode(x), previous);
    if (previous > 0) {
      EXPECT_LT(srgb_encode(x) - previous, 1.5e-4f) << x;
    }
    previous = srgb_encode(x);
  }
}

TEST(Srgb, IsOddBelowZero) {
  EXPECT_EQ(srgb_encode(-0.3f), -srgb_encode(0.3f));
  EXPECT_EQ(srgb_decode(-0.02f), -srgb_decode(0.02f));
  EXPECT_EQ(srgb_encode(Rgb(-0.3f, 0.5f, 0)), Rgb(srgb_encode(-0.3f), srgb_encode(0.5f), 0));
}

TEST(Srgb, EveryCodeComesBack) {
  for (int code = 0; code < 256; ++code) {
    const float linear = srgb_decode8(static_cast<std::uint8_t>(code));
    EXPECT_FLOAT_EQ(linear, srgb_decode(static_cast<float>(code) / 255));
    EXPECT_EQ(std::lround(255 * srgb_encode(linear)), code);
  }
}

// A float on either side of each of the 255 steps, and the floats next to them.
TEST(Srgb, CodesStepWhereTheFormulaRoundsUp) {
  for (int code = 1; code < 256; ++code) {
    float below = 0, at = 1;  // code_of(below) < code <= code_of(at)
    while (std::nextafter(below, 1.0f) < at) {
      const float middle = below + (at - below) / 2 > below ? below + (at - below) / 2 : std::nextafter(below, 1.0f);
      (code_of(middle) < code ? below : at) = middle;
    }
    EXPECT_EQ(exact_code(below), code - 1) << below;
    EXPECT_EQ(exact_code(at), code) << at;
    EXPECT_EQ(code_of(below), code - 1);
    EXPECT_EQ(code_of(at), code);
  }
}

TEST(Srgb, CodesAreTheRoundedFormula) {
  std::vector<float> linear;
  for (int i = 0; i <= 200000; ++i) linear.push_back(std::exp2(-18.0f + 18.0f * static_cast<float>(i) / 200000));
  std::vector<std::uint8_t> codes(linear.size());
  srgb_encode8(linear, codes);
  for (std::size_t i = 0; i < codes.size(); ++i) ASSERT_EQ(codes[i], exact_code(linear[i])) << linear[i];
}

TEST(Srgb, CodesOfWhatNoScreenShowsAreBlackOrWhite) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const std::array<float, 8> odd{-1, -infinity, NAN, -NAN, 0, 1.5f, 1e30f, infinity};
  std::array<std::uint8_t, 8> codes{};
  srgb_encode8(odd, codes);
  EXPECT_EQ(codes, (std::array<std::uint8_t, 8>{0, 0, 0, 0, 0, 255, 255, 255}));
}

}  // namespace
}  // namespace lambert
