#include "lambert/sampling/sampler.h"
#include "lambert/sampling/sampling_test_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lambert {
namespace {

std::vector<Vec2> points(const SamplerSettings& settings, Vec2i pixel, std::uint32_t dimension, std::uint32_t first,
                         std::uint32_t count) {
  std::vector<Vec2> all;
  for (std::uint32_t i = first; i < first + count; ++i) {
    Sampler s(settings, pixel, i);
    s.set_dimension(dimension);
    all.push_back(s.next2());
  }
  return all;
}

/// The largest number of points in one of columns x rows equal boxes.
int fullest_box(const std::vector<Vec2>& points, std::uint32_t columns, std::uint32_t rows) {
  std::vector<int> count(std::size_t{columns} * rows);
  int most = 0;
  for (const Vec2 p : points) {
    const auto x = static_cast<std::size_t>(static_cast<double>(p.x) * columns),
               y = static_cast<std::size_t>(static_cast<double>(p.y) * rows);
    most = std::max(most, ++count[y * columns + x]);
  }
  return most;
}

/// A (0,m,2)-net in base 2 has one point in every box of 2^-a by 2^-(m-a).
void expect_net(const std::vector<Vec2>& points, const char* what) {
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t columns = 1; columns <= n; columns *= 2)
    EXPECT_EQ(fullest_box(points, columns, n / columns), 1) << what << ": " << columns << " columns of " << n;
}

TEST(SobolSampler, EveryPrefixAndBlockIsANet) {
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    for (const std::uint32_t dimension : {0u, 1u, 17u}) {
      const SamplerSettings settings{.kind = SamplerKind::sobol, .seed = seed};
      for (std::uint32_t n = 1; n <= 1024; n *= 2) {
        expect_net(points(settings, {5, 11}, dimension, 0, n), "first");
        expect_net(points(settings, {200, 3}, dimension, 3 * n, n), "fourth");
      }
    }
}

TEST(SobolSampler, ScramblingAndOrderDifferByPixelAndDimension) {
  const SamplerSettings settings{.kind = SamplerKind::sobol};
  const auto a = points(settings, {5, 11}, 0, 0, 16), b = points(settings, {6, 11}, 0, 0, 16),
             c = points(settings, {5, 11}, 1, 0, 16);
  int equal = 0;
  for (std::size_t i = 0; i < 16; ++i) equal += (a[i] == b[i]) + (a[i] == c[i]);
  EXPECT_EQ(equal, 0);
}

TEST(StratifiedSampler, OneSamplePerStratum) {
  struct Grid {
    std::uint32_t planned, columns, rows;
  };
  for (const Grid g : {Grid{1, 1, 1}, {2, 2, 1}, {12, 4, 3}, {16, 4, 4}, {30, 6, 5}, {64, 8, 8}, {7, 3, 3}}) {
    const SamplerSettings settings{SamplerKind::stratified, g.planned, 9};
    const std::uint32_t cells = g.columns * g.rows;
    for (const std::uint32_t dimension : {0u, 3u})
      for (const std::uint32_t round : {0u, 1u, 5u})
        EXPECT_EQ(fullest_box(points(settings, {4, 4}, dimension, round * cells, cells), g.columns, g.rows), 1)
            << g.planned << " planned, round " << round;
    EXPECT_EQ(fullest_box(points(settings, {4, 4}, 0, 0, g.planned), g.columns, g.rows), 1);
  }
}

// If dimensions visited their strata in the same order, x of one would tell x of the next.
TEST(StratifiedSampler, StrataAreShuffledPerDimension) {
  Mean product;
  for (int p = 0; p < 2000; ++p) {
    const SamplerSettings settings{SamplerKind::stratified, 16, 1};
    for (std::uint32_t i = 0; i < 16; ++i) {
      Sampler s(settings, {p, 0}, i);
      const float a = s.next2().x - 0.5f, b = s.next2().x - 0.5f;
      product.add(static_cast<double>(12 * a * b));  // the correlation
    }
  }
  EXPECT_NEAR(product.value(), 0, 3 * product.standard_error());
}

TEST(HaltonSampler, BlocksFillTheBoxesOfTheirBases) {
  const SamplerSettings settings{.kind = SamplerKind::halton, .seed = 2};
  for (const Vec2i pixel : {Vec2i(0, 0), Vec2i(9, 40)})
    for (std::uint32_t block = 0; block < 4; ++block) {
      EXPECT_EQ(fullest_box(points(settings, pixel, 0, 6 * block, 6), 2, 3), 1);
      EXPECT_EQ(fullest_box(points(settings, pixel, 0, 72 * block, 72), 8, 9), 1);
      EXPECT_EQ(fullest_box(points(settings, pixel, 0, 432 * block, 432), 16, 27), 1);
      EXPECT_EQ(fullest_box(points(settings, pixel, 1, 35 * block, 35), 5, 7), 1);
      EXPECT_EQ(fullest_box(points(settings, pixel, 2, 143 * block, 143), 11, 13), 1);
      EXPECT_EQ(fullest_box(points(settings, pixel, 32, 72 * block, 72), 8, 9), 1) << "the bases begin again";
    }
}

TEST(BlueNoiseSampler, PixelsAndSquaresOfPixelsAreNets) {
  for (const std::uint32_t planned : {1u, 4u, 16u, 64u}) {
    const SamplerSettings settings{SamplerKind::blue_noise, planned, 5, {64, 48}};
    for (const std::uint32_t dimension : {0u, 1u, 6u})
      for (const Vec2i corner : {Vec2i(0, 0), Vec2i(8, 4), Vec2i(60, 44)}) {
        std::vector<Vec2> square;
        for (int y = 0; y < 4; ++y)
          for (int x = 0; x < 4; ++x) {
            const auto own = points(settings, corner + Vec2i(x, y), dimension, 0, planned);
            expect_net(own, "pixel");
            square.insert(square.end(), own.begin(), own.end());
          }
        expect_net(square, "square of pixels");
      }
  }
}

double root_mean_square_error(SamplerKind kind) {
  double sum = 0;
  for (int p = 0; p < 500; ++p) {
    double mean = 0;
    for (const Vec2 v : points({kind, 64, 3, {512, 512}}, {p, 7}, 0, 0, 64))
      mean += 4 * static_cast<double>(v.x * v.y) / 64;
    sum += (mean - 1) * (mean - 1);
  }
  return std::sqrt(sum / 500);
}

// rows: PT-22
TEST(Sampler, StratificationLowersTheError) {
  const double independent = root_mean_square_error(SamplerKind::independent);
  EXPECT_NEAR(independent, std::sqrt(7.0 / 9 / 64), 0.01);  // Var(4xy) = 16/9 - 1
  EXPECT_LT(root_mean_square_error(SamplerKind::stratified), 0.25 * independent);
  for (const SamplerKind kind : {SamplerKind::halton, SamplerKind::sobol, SamplerKind::blue_noise})
    EXPECT_LT(root_mean_square_error(kind), 0.2 * independent) << static_cast<int>(kind);
}

/// The root mean square error of the mean of |x - y| over 256 samples, over many pixels.
double error_along_the_diagonal(SamplerKind kind, std::uint32_t dimension) {
  double sum = 0;
  for (int p = 0; p < 100; ++p) {
    double mean = 0;
    for (const Vec2 v : points({kind, 256, 4, {512, 512}}, {p, 9}, dimension, 0, 256))
      mean += std::abs(static_cast<double>(v.x - v.y)) / 256;
    sum += (mean - 1.0 / 3) * (mean - 1.0 / 3);
  }
  return std::sqrt(sum / 100);
}

// Unscrambled Halton points of large bases lie on few lines until there are base² of them, and shifting their digits
// leaves them there: the error would be several times that of random points.
TEST(Sampler, NoDimensionIsWorseThanRandom) {
  const double random = std::sqrt(1.0 / 18 / 256);  // Var |x - y| = 1/18
  for (const SamplerKind kind : {SamplerKind::halton, SamplerKind::sobol, SamplerKind::stratified})
    for (std::uint32_t dimension = 0; dimension < 40; ++dimension)
      EXPECT_LT(error_along_the_diagonal(kind, dimension), 1.3 * random)
          << static_cast<int>(kind) << ", dimension " << dimension;
}

}  // namespace
}  // namespace lambert
