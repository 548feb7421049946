#include "lambert/image/compare/errors.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::compare {
namespace {

Image grey(std::vector<float> values) {
  Image image(static_cast<int>(values.size()), 1, {"Y"});
  std::copy(values.begin(), values.end(), image.pixels().begin());
  return image;
}

TEST(Errors, AreTheirDefinitions) {
  const Errors e = errors_of(grey({1, 2, 3, 4}), grey({1, 1, 5, 4}));
  EXPECT_DOUBLE_EQ(e.mean, 0.75);
  EXPECT_DOUBLE_EQ(e.bias, -0.25);
  EXPECT_DOUBLE_EQ(e.mse, 1.25);
  EXPECT_DOUBLE_EQ(e.relative_mse, (1 / 1.01 + 4 / 25.01) / 4);
  EXPECT_DOUBLE_EQ(e.largest, 2);
  EXPECT_EQ(e.x, 2);
  EXPECT_EQ(e.channel, "Y");
  EXPECT_DOUBLE_EQ(e.psnr(5), 10 * std::log10(25 / 1.25));
  EXPECT_EQ(e.pixels_over(1), 1u);
  EXPECT_EQ(e.pixels_over(0.5), 2u);
}

TEST(Errors, OfEqualImagesAreNothing) {
  const Image image = grey({0, -3, NAN, INFINITY, -INFINITY});
  const Errors e = errors_of(image, image);
  EXPECT_EQ(e.mse, 0);
  EXPECT_EQ(e.incomparable, 0u);
  EXPECT_EQ(e.largest, 0);
  EXPECT_TRUE(std::isinf(e.psnr(1)));
  EXPECT_TRUE(e.channel.empty());
}

TEST(Errors, ValuesWithoutDifferenceFailButEnterNoMean) {
  const Errors e = errors_of(grey({NAN, 1, INFINITY}), grey({0, 2, -INFINITY}));
  EXPECT_EQ(e.incomparable, 2u);
  EXPECT_DOUBLE_EQ(e.mean, 1);
  EXPECT_TRUE(std::isinf(e.largest));
  EXPECT_EQ(e.pixels_over(1e30), 2u);
}

TEST(Errors, TrimmingLeavesOutTheThousandthWithFireflies) {
  std::vector<float> a(2000, 1.1f);
  const std::vector<float> b(2000, 1.0f);
  a[77] = 1e6f, a[1234] = 1e5f;
  const Errors e = errors_of(grey(a), grey(b));
  EXPECT_GT(e.relative_mse, 1e6);
  EXPECT_NEAR(e.trimmed_mse, 0.01 / 1.01, 1e-6);
}

TEST(Errors, RefusesImagesThatAreNotAlike) {
  EXPECT_EQ(error_of([] { errors_of(grey({1}), grey({1, 2})); }), "the sizes differ: 1x1 and 2x1");
  EXPECT_EQ(error_of([] { errors_of(Image(1, 1, {"R"}), grey({1})); }), "the channels differ");
}

TEST(Difference, IsSigned) {
  const Image d = difference(grey({1, INFINITY, 5}), grey({2, INFINITY, 2}));
  EXPECT_EQ(d.at(0, 0, 0), -1);
  EXPECT_EQ(d.at(1, 0, 0), 0);
  EXPECT_EQ(d.at(2, 0, 0), 3);
}

}  // namespace
}  // namespace lambert::compare
