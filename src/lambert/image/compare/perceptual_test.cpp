#include "lambert/image/compare/false_colour.h"
#include "lambert/image/compare/flip.h"
#include "lambert/image/compare/flip_colour.h"
#include "lambert/image/compare/ssim.h"

#include "lambert/base/parallel.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::compare {
namespace {

Image flat(Rgb c, int size = 24) {
  Image image(size, size, rgb_channels());
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) image.set_rgb(x, y, c);
  return image;
}

TEST(Ssim, OfFlatImagesIsTheLuminanceTerm) {
  const double expected = (2 * 0.25 * 0.5 + 1e-4) / (0.25 * 0.25 + 0.5 * 0.5 + 1e-4);
  EXPECT_NEAR(ssim(flat(Rgb(0.25f)), flat(Rgb(0.5f))).mean, expected, 1e-4);
}

TEST(Ssim, OfAnImageWithItselfIsOneAndWithItsNegativeIsBelowZero) {
  const Image a = noise(40, 30, rgb_channels());
  Image negative = a;
  for (float& v : negative.pixels()) v = 1 - v;
  EXPECT_NEAR(ssim(a, a).mean, 1, 1e-6);
  EXPECT_LT(ssim(a, negative).mean, 0);
  EXPECT_NEAR(ssim(a, negative).mean, ssim(negative, a).mean, 1e-6);
}

TEST(Ssim, FallsWithNoise) {
  const Image a = noise(40, 30, rgb_channels());
  double last = 1;
  for (const float strength : {0.05f, 0.2f, 0.8f}) {
    Image b = a;
    const Image other = noise(60, 30, rgb_channels());
    for (std::size_t i = 0; i < b.pixels().size(); ++i) b.pixels()[i] += strength * (other.pixels()[i + 99] - 0.5f);
    const double now = ssim(a, b).mean;
    EXPECT_LT(now, last);
    last = now;
  }
}

TEST(Flip, IsNothingForTheSameAndOneFromGreenToBlue) {
  const Image a = noise(32, 24, rgb_channels());
  EXPECT_EQ(flip(a, a).mean, 0);
  EXPECT_NEAR(static_cast<double>(colour_error(hunt_lab(opponent({0, 1, 0})), hunt_lab(opponent({0, 0, 1})))), 1, 1e-3);
  EXPECT_NEAR(flip(flat({0, 1, 0}), flat({0, 0, 1})).mean, 1, 1e-3);
}

// Flat images have no features, so FLIP is the colour error alone; black to white is |dL| = 100.
TEST(Flip, OfBlackAndWhiteIsTheirDistanceCompressed) {
  const auto lab = [](Rgb c) { return hunt_lab(opponent(c)); };
  EXPECT_NEAR(static_cast<double>(lab(Rgb(1)).x), 100, 1e-2);
  EXPECT_NEAR(static_cast<double>(lab(Rgb(0)).x), 0, 1e-2);
  const Vec3 green = lab({0, 1, 0}), blue = lab({0, 0, 1});
  const double most =
      std::pow(std::abs(static_cast<double>(green.x - blue.x)) +
                   std::hypot(static_cast<double>(green.y - blue.y), static_cast<double>(green.z - blue.z)),
               0.7);
  const double distance = std::pow(100.0, 0.7), knee = 0.4 * most;
  const double expected = distance < knee ? 0.95 * distance / knee : 0.95 + 0.05 * (distance - knee) / (most - knee);
  EXPECT_NEAR(flip(flat(Rgb(0)), flat(Rgb(1))).mean, expected, 2e-3);
}

TEST(Flip, IsSymmetricAndGrowsWithTheDifference) {
  const Image a = noise(32, 24, rgb_channels());
  double last = 0;
  for (const float strength : {0.1f, 0.3f, 0.9f}) {
    Image b = a;
    for (int y = 8; y < 16; ++y)
      for (int x = 8; x < 16; ++x) b.set_rgb(x, y, lerp(b.rgb(x, y), Rgb(1, 0, 0), strength));
    const double forward = flip(a, b).mean;
    EXPECT_NEAR(forward, flip(b, a).mean, 1e-6);
    EXPECT_GT(forward, last);
    last = forward;
  }
}

// A viewer far away sees noise as grey.
TEST(Flip, FineNoiseCountsLessFromAfar) {
  const Image a = noise(64, 64, {"Y"}), b = flat(Rgb(0.5f), 64);
  EXPECT_LT(flip(a, b, {.pixels_per_degree = 200}).mean, 0.5 * flip(a, b, {.pixels_per_degree = 20}).mean);
}

TEST(HdrFlip, SeesWhatOneExposureHides) {
  Image a = flat(Rgb(0.1f), 32);
  for (int x = 0; x < 8; ++x) a.set_rgb(x, 4, Rgb(900));
  Image b = a;
  for (int x = 0; x < 8; ++x) b.set_rgb(x, 4, Rgb(300));
  EXPECT_EQ(flip(a, b).mean, 0);
  EXPECT_GT(hdr_flip(b, a).mean, 0.005);
  EXPECT_EQ(hdr_flip(a, a).mean, 0);
}

TEST(HdrFlip, TakesAnyPixels) {
  for (const float v : {0.0f, -1.0f, 1e30f, NAN, INFINITY}) {
    const Flip f = hdr_flip(flat(Rgb(0.5f), 3), flat(Rgb(v), 3));
    EXPECT_TRUE(f.mean >= 0 && f.mean <= 1) << v;
  }
}

TEST(Flip, DoesNotDependOnThreads) {
  const Image a = noise(50, 40, rgb_channels()), b = flat(Rgb(0.4f), 50);
  Image c(50, 40, rgb_channels());
  std::copy_n(b.pixels().begin(), c.pixels().size(), c.pixels().begin());
  set_thread_count(1);
  const Flip one = flip(a, c);
  set_thread_count(2);
  EXPECT_EQ(one.map.values, flip(a, c).map.values);
  set_thread_count(0);
}

TEST(Heat, GrowsLighterAndStaysInGamut) {
  float last = -1;
  for (int i = 0; i <= 100; ++i) {
    const Rgb c = heat(static_cast<float>(i) / 100);
    EXPECT_GE(min_component(c), 0);
    EXPECT_LE(max_component(c), 1);
    EXPECT_GT(luminance(c), last);
    last = luminance(c);
  }
  EXPECT_TRUE(is_black(heat(NAN)));
  EXPECT_EQ(heat(INFINITY), Rgb(1));
  EXPECT_EQ(heat(2), heat(1e9f));
}

}  // namespace
}  // namespace lambert::compare
