#include "lambert/image/filter/textured_plane.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

double error_against(const Image& image, const Image& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < truth.pixels().size(); ++i)
    sum += std::pow(static_cast<double>(image.pixels()[i] - truth.pixels()[i]), 2);
  return sum / static_cast<double>(truth.pixels().size());
}

// rows: AA-21 AA-22
// Against the average of 16 × 16 samples per pixel, each lookup is better than the one before it.
TEST(TexturedPlane, LookupsInTheOrderOfTheirErrors) {
  const Pyramid board(checkerboard(128, 8));
  const auto show = [&](LookupMethod method, int samples) {
    return textured_plane(board, {.width = 96, .height = 96, .samples = samples, .lookup = {.method = method}});
  };
  const Image truth = show(LookupMethod::nearest, 16);
  const double nearest = error_against(show(LookupMethod::nearest, 1), truth);
  const double bilinear = error_against(show(LookupMethod::bilinear, 1), truth);
  const double trilinear = error_against(show(LookupMethod::trilinear, 1), truth);
  const double anisotropic = error_against(show(LookupMethod::anisotropic, 1), truth);
  EXPECT_GT(nearest, bilinear);
  EXPECT_GT(bilinear, 1.5 * trilinear);
  EXPECT_GT(trilinear, 1.5 * anisotropic);
}

TEST(TexturedPlane, HorizonAndErrors) {
  const Pyramid board(checkerboard(16, 2));
  const Image out = textured_plane(board, {.width = 9, .height = 10});
  EXPECT_EQ(out.rgb(4, 4), Rgb(0.35f, 0.5f, 0.8f)) << "sky down to the middle";
  EXPECT_EQ(out.rgb(4, 5).r, out.rgb(4, 5).b) << "the board from there";
  EXPECT_NE(error_of([&] { textured_plane(board, {.field_of_view = 180}); }).find("180"), std::string::npos);
  EXPECT_NE(error_of([&] { textured_plane(board, {.repeat = 0}); }).find("side"), std::string::npos);
  EXPECT_NE(error_of([&] { textured_plane(board, {.samples = 0}); }).find("64"), std::string::npos);
  EXPECT_NE(error_of([] { checkerboard(4, 5); }).find("pixel"), std::string::npos);
}

}  // namespace
}  // namespace lambert
