#include "lambert/base/angle.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(Angle, UnitsAgree) {
  EXPECT_FLOAT_EQ(degrees(180).radians(), pi);
  EXPECT_FLOAT_EQ(radians(pi / 2).degrees(), 90);
  EXPECT_LT(degrees(1), radians(1));
}

TEST(Angle, ArithmeticAndFunctions) {
  EXPECT_FLOAT_EQ((2.0f * degrees(20) + degrees(10) - degrees(40) / 2.0f).degrees(), 30);
  EXPECT_FLOAT_EQ(sin(degrees(30)), 0.5f);
  EXPECT_FLOAT_EQ(cos(degrees(60)), 0.5f);
  EXPECT_FLOAT_EQ(tan(degrees(45)), 1);
}

}  // namespace
}  // namespace lambert
