#include "lambert/base/rgb.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambert {
namespace {

TEST(Rgb, ArithmeticIsByChannel) {
  const Rgb a(1, 2, 3), b(4, 5, 6);
  EXPECT_EQ(a + b, Rgb(5, 7, 9));
  EXPECT_EQ(b - a, Rgb(3));
  EXPECT_EQ(a * b, Rgb(4, 10, 18));
  EXPECT_EQ(Rgb(4, 10, 18) / b, a);
  EXPECT_EQ(2.0f * a, a + a);
  EXPECT_EQ(lerp(a, b, 0.5f), Rgb(2.5f, 3.5f, 4.5f));
  EXPECT_EQ(clamp(a, 1.5f, 2.5f), Rgb(1.5f, 2, 2.5f));
  EXPECT_EQ(max(Rgb(1, 5, 2), Rgb(3)), Rgb(3, 5, 3));
}

TEST(Rgb, MeasuresOfAColour) {
  EXPECT_FLOAT_EQ(luminance(Rgb(1)), 1);
  EXPECT_FLOAT_EQ(luminance(Rgb(0, 1, 0)), 0.7152f);
  EXPECT_EQ(max_component(Rgb(1, 3, 2)), 3);
  EXPECT_EQ(min_component(Rgb(2, 3, 1)), 1);
  EXPECT_FLOAT_EQ(average(Rgb(1, 2, 6)), 3);
  EXPECT_TRUE(is_black(Rgb()) && !is_black(Rgb(0, 0, 1e-30f)));
}

TEST(Rgb, FiniteMeansAllChannels) {
  EXPECT_TRUE(is_finite(Rgb(1, 2, 3)));
  EXPECT_FALSE(is_finite(Rgb(1, std::numeric_limits<float>::quiet_NaN(), 3)));
  EXPECT_FALSE(is_finite(Rgb(1, 2, std::numeric_limits<float>::infinity())));
}

}  // namespace
}  // namespace lambert
