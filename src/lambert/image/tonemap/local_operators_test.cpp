#include "lambert/image/colour.h"
#include "lambert/image/tonemap/bilateral.h"
#include "lambert/image/tonemap/durand.h"
#include "lambert/image/tonemap/fattal.h"
#include "lambert/image/tonemap/mertens.h"
#include "lambert/image/tonemap/photographic_local.h"
#include "lambert/image/tonemap/poisson.h"
#include "lambert/image/tonemap/pyramid.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace lambert::tone {
namespace {

Plane random_plane(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Plane plane(width, height);
  for (float& v : plane.values) v = static_cast<float>(random()) / static_cast<float>(random.max());
  return plane;
}

/// Smooth parts, an edge of two decades, and a little noise.
Plane decades(int width, int height) {
  Plane plane = random_plane(width, height, 5);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float slope = 0.6f * static_cast<float>(x + y) / static_cast<float>(width + height);
      plane.at(x, y) = 0.1f * plane.at(x, y) + slope + (2 * x > width + y ? 2.0f : 0.0f);
    }
  return plane;
}

LuminanceMap map_of(Plane plane) {
  StatisticsSum sum;
  for (int y = 0; y < plane.height; ++y) {
    const float* const row = plane.row(y).data();
    sum.add_row(row, row, row, row, static_cast<std::size_t>(plane.width));
  }
  return {.luminance = std::move(plane), .statistics = sum.statistics()};
}

TEST(Bilateral, IsTheSumOverAllPixels) {
  const float spatial = 6, range = 0.4f;
  const Plane plane = decades(48, 37);
  const Plane fast = bilateral_filter(plane, spatial, range);
  double worst = 0;
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      double sum = 0, weights = 0;
      for (int v = 0; v < plane.height; ++v)
        for (int u = 0; u < plane.width; ++u) {
          const double d = ((u - x) * (u - x) + (v - y) * (v - y)) / static_cast<double>(spatial * spatial);
          const double r = static_cast<double>((plane.at(u, v) - plane.at(x, y)) / range);
          const double w = std::exp(-0.5 * (d + r * r));
          sum += w * static_cast<double>(plane.at(u, v)), weights += w;
        }
      worst = std::max(worst, std::abs(sum / weights - static_cast<double>(fast.at(x, y))));
    }
  EXPECT_LT(worst, 0.03 * 0.4);
}

TEST(Bilateral, LeavesWhatIsFlat) {
  const Plane flat(20, 9, 3.5f);
  EXPECT_EQ(bilateral_filter(flat, 4, 0.4f).values, flat.values);
}

TEST(Durand, CompressesTheBaseAndKeepsTheDetail) {
  // Two flat halves, 10^4 apart, each with a texture of 10 %.
  Plane plane(200, 60);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) plane.at(x, y) = (x < 100 ? 0.01f : 100.0f) * ((x + y) % 2 ? 1.1f : 1.0f);
  const Plane shown = Durand{}.map(map_of(plane));
  EXPECT_NEAR(shown.at(50, 30) / shown.at(51, 30), 1 / 1.1f, 1e-3f);
  EXPECT_NEAR(shown.at(150, 30) / shown.at(151, 30), 1 / 1.1f, 1e-3f);
  EXPECT_NEAR(shown.at(150, 30) / shown.at(50, 30), 5, 0.05f);
}

TEST(Durand, SoftEdgesOfLampsDoNotGlow) {
  // A lamp 1000 times its surroundings, the edge half covered and less: nothing is brighter than both sides.
  Plane plane(160, 90, 0.5f);
  for (int y = 30; y < 60; ++y)
    for (int x = 60; x < 90; ++x) plane.at(x, y) = 500;
  for (int y = 30; y < 60; ++y) plane.at(59, y) = 500 * 0.02f, plane.at(90, y) = 500 * 0.1f;
  const Plane shown = Durand{}.map(map_of(plane));
  const float lamp = shown.at(75, 45);
  EXPECT_LT(shown.at(59, 45), lamp);
  EXPECT_LT(shown.at(90, 45), lamp * 1.05f);
}

TEST(Durand, SlopesOfSoftEdgesKeepTheirSign) {
  // A lamp of 3000 in a field of 1, parted by ten pixels of their mixtures, as between texels.
  Plane plane(320, 60);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x)
      plane.at(x, y) = 1 + 2999 * std::clamp(static_cast<float>(x - 155) / 10, 0.0f, 1.0f);
  const Plane shown = Durand{}.map(map_of(plane));
  for (int x = 1; x < plane.width; ++x) EXPECT_GT(shown.at(x, 30), 0.97f * shown.at(x - 1, 30)) << x;
}

/// Gauss-Seidel until nothing moves.
std::vector<double> by_relaxation(int w, int h, const std::vector<double>& f) {
  std::vector<double> u(f.size(), 0.0);
  const auto at = [&](int x, int y) -> double& { return u[static_cast<std::size_t>(y * w + x)]; };
  for (int sweep = 0; sweep < 20000; ++sweep)
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        double sum = 0, n = 0;
        if (x > 0) sum += at(x - 1, y), ++n;
        if (x + 1 < w) sum += at(x + 1, y), ++n;
        if (y > 0) sum += at(x, y - 1), ++n;
        if (y + 1 < h) sum += at(x, y + 1), ++n;
        at(x, y) = (sum - f[static_cast<std::size_t>(y * w + x)]) / n;
      }
  double mean = 0;
  for (const double v : u) mean += v / static_cast<double>(u.size());
  for (double& v : u) v -= mean;
  return u;
}

TEST(Poisson, AgreesWithRelaxationToTheEnd) {
  for (const auto& [w, h] : std::vector<std::pair<int, int>>{{13, 9}, {16, 16}, {7, 1}, {2, 3}}) {
    const Plane noise = random_plane(w, h, 11);
    std::vector<double> f(noise.values.begin(), noise.values.end());
    double mean = 0;
    for (const double v : f) mean += v / static_cast<double>(f.size());
    for (double& v : f) v -= mean;
    const std::vector<double> expected = by_relaxation(w, h, f), solved = solve_poisson(w, h, f);
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(solved[i], expected[i], 1e-5) << w << "x" << h << " " << i;
  }
}

TEST(Poisson, FindsAnyPlaneFromItsGradients) {
  for (const auto& [w, h] : std::vector<std::pair<int, int>>{{257, 130}, {100, 3}, {1, 40}, {1, 1}}) {
    Plane plane = random_plane(w, h, 3);
    double mean = 0;
    for (const float v : plane.values) mean += static_cast<double>(v) / static_cast<double>(plane.values.size());
    const Plane back = with_scaled_gradients(plane, Plane(w, h, 1));
    for (std::size_t i = 0; i < plane.values.size(); ++i)
      ASSERT_NEAR(back.values[i], plane.values[i] - static_cast<float>(mean), 1e-4f) << w << "x" << h;
  }
}

TEST(Fattal, WithoutAttenuationOnlyScales) {
  Plane plane = decades(90, 71);
  for (float& v : plane.values) v = std::exp2(v);
  const Plane shown = Fattal{.beta = 1, .contrast = 1}.map(map_of(plane));
  const float ratio = shown.values[0] / plane.values[0];
  for (std::size_t i = 0; i < plane.values.size(); ++i) {
    // The few below the floor go in proportion from there.
    ASSERT_NEAR(shown.values[i] / plane.values[i], ratio, 2e-2f * ratio);
  }
}

TEST(Fattal, AttenuatesLargeGradientsMore) {
  const Plane plane = decades(128, 128);
  const Plane factors = Fattal{}.attenuation(plane);
  EXPECT_LT(factors.at(64 + 32, 64), 0.7f * factors.at(20, 64)) << "on the edge and away from it";
  const LuminanceMap map = map_of(plane);
  EXPECT_EQ(map.luminance.width, 128);
}

TEST(Pyramid, KeepsConstantsAndSizes) {
  for (const auto& [w, h] : std::vector<std::pair<int, int>>{{13, 8}, {1, 5}, {2, 1}, {1, 1}}) {
    const Plane half = halved(Plane(w, h, 0.7f));
    EXPECT_EQ(half.width, (w + 1) / 2);
    EXPECT_EQ(half.height, (h + 1) / 2);
    const Plane back = doubled(half, w, h);
    for (const float v : back.values) EXPECT_NEAR(v, 0.7f, 1e-6f);
  }
}

TEST(Blur, KeepsConstantsAndTheVarianceOfAPoint) {
  const Plane flat = gaussian_blurred(Plane(9, 5, 2), 3);
  for (const float v : flat.values) EXPECT_NEAR(v, 2, 1e-5f);
  Plane point(61, 61);
  point.at(30, 30) = 1;
  const Plane spread = gaussian_blurred(point, 4);
  double variance = 0, sum = 0;
  for (int x = 0; x < 61; ++x)
    for (int y = 0; y < 61; ++y) {
      variance += (x - 30) * (x - 30) * static_cast<double>(spread.at(x, y));
      sum += static_cast<double>(spread.at(x, y));
    }
  EXPECT_NEAR(sum, 1, 1e-5);
  EXPECT_NEAR(std::sqrt(variance), 4, 0.06) << "cut at three deviations";
}

TEST(PhotographicLocal, IsTheGlobalCurveWhereNothingChanges) {
  const Plane shown = PhotographicLocal{}.map(map_of(Plane(40, 30, 7)));
  for (const float v : shown.values) EXPECT_NEAR(v, 0.18f / 1.18f, 1e-5f);
}

TEST(PhotographicLocal, DodgesDarkDetailBesideLight) {
  // A darker spot on a bright field: the local curve keeps it further from its surroundings than the global one.
  Plane plane(120, 120, 10);
  for (int y = 55; y < 65; ++y)
    for (int x = 55; x < 65; ++x) plane.at(x, y) = 9;
  for (int x = 0; x < 120; ++x) plane.at(x, 0) = 0.001f;
  const LuminanceMap map = map_of(plane);
  const float scale = 0.18f / map.statistics.log_average;
  const Plane shown = PhotographicLocal{}.map(map);
  const float global = (9 * scale / (1 + 9 * scale)) / (10 * scale / (1 + 10 * scale));
  EXPECT_LT(shown.at(60, 60) / shown.at(20, 60), global - 0.005f);
}

Image coloured(int width, int height, unsigned seed) {
  const Plane noise = random_plane(3 * width, height, seed);
  Image image(width, height, rgb_channels());
  std::copy(noise.values.begin(), noise.values.end(), image.pixels().begin());
  return image;
}

TEST(Mertens, OfEqualImagesIsThatImage) {
  const Image image = coloured(37, 22, 9);
  const std::vector<Image> stack(3, image);
  const Image fused = fuse_exposures(stack);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) ASSERT_NEAR(fused.pixels()[i], image.pixels()[i], 1e-5f);
}

TEST(Mertens, TakesTheWellExposed) {
  const auto flat = [](Rgb c) {
    Image image(24, 17, rgb_channels());
    for (int y = 0; y < 17; ++y)
      for (int x = 0; x < 24; ++x) image.set_rgb(x, y, c);
    return image;
  };
  const std::vector<Image> stack{flat({0.001f, 0.0011f, 0.0012f}), flat({0.2f, 0.22f, 0.24f}), flat({1, 1, 0.99f})};
  const Image fused = fuse_exposures(stack);
  for (const int x : {0, 11, 23}) EXPECT_NEAR(fused.rgb(x, 8).g, 0.22f, 0.01f);
  // Asked for nothing, it takes the mean of the codes.
  const Image mean = fuse_exposures(stack, {.contrast = 0, .saturation = 0, .exposedness = 0});
  EXPECT_NEAR(srgb_encode(mean.rgb(3, 3).g), (srgb_encode(0.0011f) + srgb_encode(0.22f) + 1) / 3, 1e-4f);
}

TEST(Mertens, RefusesStacksThatAreNone) {
  const std::vector<Image> stack{coloured(4, 4, 1), coloured(4, 5, 1)};
  EXPECT_NE(error_of([&] { fuse_exposures(stack); }).find("the first is 4x4, another 4x5"), std::string::npos);
  EXPECT_NE(error_of([&] { fuse_exposures({}); }).find("at least one"), std::string::npos);
}

}  // namespace
}  // namespace lambert::tone
