#include "lambert/image/colour.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

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

}  // namespace
}  // namespace lambert
