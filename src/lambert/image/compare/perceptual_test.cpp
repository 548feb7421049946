#include "lambert/image/compare/false_colour.h"
#include "lambert/image/compare/flip.h"
#include "lambert/image/compare/flip_colour.h"
#include "lambert/image/compare/ssim.h"

#include "lambert/base/parallel.h"
#include "lambert/image/image_test_tools.h"
#include "lambert/image/primaries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// FLIP by its paper: sums over squares of pixels in double precision, nothing separated.
class FlipByDefinition {
 public:
  explicit FlipByDefinition(double pixels_per_degree) : ppd_(pixels_per_degree) {}

  double at(const Image& a, const Image& b, int x, int y) const {
    const double most = std::pow(distance(hunt({0, 1, 0}), hunt({0, 0, 1})), 0.7);
    const double colour = std::pow(distance(hunt(seen(a, x, y)), hunt(seen(b, x, y))), 0.7);
    const double redistributed =
        colour < 0.4 * most ? colour * 0.95 / (0.4 * most) : 0.95 + (colour - 0.4 * most) / (most - 0.4 * most) * 0.05;
    const double edges = std::abs(feature(a, x, y, true) - feature(b, x, y, true));
    const double points = std::abs(feature(a, x, y, false) - feature(b, x, y, false));
    return std::pow(redistributed, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0)));
  }

 private:
  double ppd_;

  static Vec3d pixel(const Image& image, int x, int y) {
    const Rgb c = image.rgb(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
    return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)};
  }
  /// X, Y and Z over those of white; the primaries' chromaticities are Rec. 709's.
  static Vec3d xyz(Vec3d c) {
    const glm::dmat3 m = rgb_to_xyz(rec709);
    return (m * c) / (m * Vec3d(1));
  }
  static Vec3d opponent_of(Vec3d c) {
    const Vec3d t = xyz(c);
    return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
  }
  static Vec3d hunt(Vec3d linear) {
    const Vec3d t = xyz(linear);
    const auto f = [](double v) { return v > std::pow(6.0 / 29, 3) ? std::cbrt(v) : v * 841 / 108 + 4.0 / 29; };
    const double l = 116 * f(t.y) - 16;
    return {l, 0.01 * l * 500 * (f(t.x) - f(t.y)), 0.01 * l * 200 * (f(t.y) - f(t.z))};
  }
  static double distance(Vec3d a, Vec3d b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

  Vec3d seen(const Image& image, int x, int y) const {
    const double pi = std::numbers::pi;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_));
    Vec3d sum(0), weights(0);
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const double d = (dx * dx + dy * dy) / (ppd_ * ppd_);
        const auto bell = [&](double a, double b) { return a * std::sqrt(pi / b) * std::exp(-pi * pi * d / b); };
        const Vec3d w(bell(1, 0.0047), bell(1, 0.0053), bell(34.1, 0.04) + bell(13.5, 0.025));
        sum += w * opponent_of(pixel(image, x + dx, y + dy)), weights += w;
      }
    const Vec3d o = sum / weights;
    const double luma = (o.x + 16) / 116;
    const Vec3d t(luma + o.y / 500, luma, luma - o.z / 200);
    const glm::dmat3 m = rgb_to_xyz(rec709);
    return glm::clamp(glm::inverse(m) * (t * (m * Vec3d(1))), 0.0, 1.0);
  }

  /// The length of the two answers of an edge or point detector.
  double feature(const Image& image, int x, int y, bool edge) const {
    const double sigma = 0.5 * 0.082 * ppd_;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto weight = [&](int u, int v) {
      const double g = std::exp(-(u * u + v * v) / (2 * sigma * sigma));
      return (edge ? -u : u * u / (sigma * sigma) - 1) * g;
    };
    double positive = 0, negative = 0, across = 0, down = 0;
    for (int v = -radius; v <= radius; ++v)
      for (int u = -radius; u <= radius; ++u) (weight(u, v) > 0 ? positive : negative) += std::abs(weight(u, v));
    for (int v = -radius; v <= radius; ++v)
      for (int u = -radius; u <= radius; ++u) {
        const double w = weight(u, v) / (weight(u, v) > 0 ? positive : negative);
        across += w * xyz(pixel(image, x + u, y + v)).y, down += w * xyz(pixel(image, x + v, y + u)).y;
      }
    return std::hypot(across, down);
  }
};

TEST(Flip, IsWhatItsPaperDefines) {
  const Image a = noise(14, 11, rgb_channels());
  Image b = a;
  for (int y = 3; y < 8; ++y)
    for (int x = 4; x < 11; ++x) b.set_rgb(x, y, Rgb(0.9f, 0.2f, 0.1f * static_cast<float>(y)));
  for (const double ppd : {9.0, 25.0}) {
    const FlipByDefinition expected(ppd);
    const Flip found = flip(a, b, {.pixels_per_degree = ppd});
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        ASSERT_NEAR(static_cast<double>(found.map.at(x, y)), expected.at(a, b, x, y), 3e-3)
            << ppd << " " << x << " " << y;
  }
}

// Flat greys: FLIP at the exposure where the reference is at 0.85 of the curve, its brightest and its median alike.
TEST(HdrFlip, ExposesTheReferenceToEightyFivePercentOfTheCurve) {
  const auto curve = [](double x) {
    x *= 0.6;
    return static_cast<float>(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
  };
  double white = 1;
  while (curve(white) < 0.85f) white *= 1.0001;
  for (const float factor : {0.25f, 0.9f, 1.5f}) {
    const double expected = flip(flat(Rgb(0.85f)), flat(Rgb(curve(white * static_cast<double>(factor))))).mean;
    EXPECT_NEAR(hdr_flip(flat(Rgb(7 * factor)), flat(Rgb(7))).mean, expected, 1e-3) << factor;
  }
}

TEST(HdrFlip, WhatIsTooBrightForTheCurveIsWhite) {
  EXPECT_EQ(hdr_flip(flat(Rgb(1e30f), 3), flat(Rgb(1), 3)).mean, hdr_flip(flat(Rgb(1e8f), 3), flat(Rgb(1), 3)).mean);
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
