#include "lambert/image/primaries.h"

#include "damage.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

constexpr Chromaticities aces{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}, {0.32168, 0.33767}};

void expect_near(Rgb a, Rgb b, float tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance);
}

TEST(Primaries, Rec709IsTheMatrixOfTheStandard) {
  const glm::dmat3 m = rgb_to_xyz(rec709);
  const double expected[3][3] = {
      {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};  // IEC 61966-2-1
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) EXPECT_NEAR(m[column][row], expected[row][column], 1e-4);
}

TEST(Primaries, OwnPrimariesChangeNothing) {
  expect_near(apply(to_rec709(rec709), {0.2f, 0.5f, 0.9f}), {0.2f, 0.5f, 0.9f}, 1e-6f);
  EXPECT_TRUE(same_primaries(rec709, rec709));
  EXPECT_FALSE(same_primaries(rec709, aces));
}

TEST(Primaries, WhiteStaysWhiteAndTheMeasuredIsLeftMeasured) {
  expect_near(apply(to_rec709(aces), Rgb(1)), Rgb(1), 1e-6f);
  expect_near(apply(to_rec709(cie_xyz), {0.9505f, 1, 1.089f}), Rgb(1), 1e-3f);
  expect_near(apply(to_rec709(cie_xyz), {0.4124f, 0.2126f, 0.0193f}), {1, 0, 0}, 1e-3f);
}

// The matrix that the Academy gives for ACES2065-1 to Rec. 709 with Bradford's adaptation (ACES, utilities).
TEST(Primaries, AcesIsThatOfTheAcademy) {
  const glm::dmat3 m = to_rec709(aces);
  const double expected[3][3] = {
      {2.52169, -1.13413, -0.38756}, {-0.27648, 1.37272, -0.09624}, {-0.01538, -0.15298, 1.16835}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) EXPECT_NEAR(m[column][row], expected[row][column], 1e-3);
}

TEST(Primaries, WhatIsNoSystemIsRefused) {
  EXPECT_NE(error_of([] { rgb_to_xyz({{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, {0.3, 0.3}}); }), "");
  EXPECT_NE(error_of([] { rgb_to_xyz({{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3, 0}}); }), "");
  EXPECT_NE(error_of([] { to_rec709({{0, 0}, {0, 0}, {0, 0}, {0, 0}}); }), "");
}

}  // namespace
}  // namespace lambert
