#include "lambert/sampling/sampler.h"
#include "lambert/sampling/sampling_test_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lambert {
namespace {

constexpr int width = 128;

/// Errors of the pixels' estimates of an integral that varies slowly over the image.
std::vector<double> error_image(SamplerKind kind, std::uint32_t samples, std::uint32_t dimension) {
  std::vector<double> errors;
  for (int y = 0; y < width; ++y)
    for (int x = 0; x < width; ++x) {
      const double edge = 0.8 + 0.4 * x / width;  // the area below u + v = edge
      const double exact = edge < 1 ? 0.5 * edge * edge : 1 - 0.5 * (2 - edge) * (2 - edge);
      double mean = 0;
      for (std::uint32_t i = 0; i < samples; ++i) {
        Sampler s({kind, samples, 11, {width, width}}, {x, y}, i);
        s.set_dimension(dimension);
        const Vec2 u = s.next2();
        mean += static_cast<double>(u.x + u.y) < edge ? 1.0 / samples : 0.0;
      }
      errors.push_back(mean - exact);
    }
  return errors;
}

double mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return sum / static_cast<double>(values.size());
}

/// The mean square of the means of size x size blocks, which starts at `offset` so that no block of Morton's curve is
/// favoured; times size², so that white noise keeps its mean square.
double low_frequencies(const std::vector<double>& errors, int size, int offset) {
  std::vector<double> means;
  for (int by = offset; by + size <= width; by += size)
    for (int bx = offset; bx + size <= width; bx += size) {
      double sum = 0;
      for (int y = by; y < by + size; ++y)
        for (int x = bx; x < bx + size; ++x) sum += errors[static_cast<std::size_t>(y * width + x)];
      means.push_back(sum / size);
    }
  return mean_square(means);
}

// The error of n points of a net at a jump falls as n^(-3/4), so a block of 16 pixels keeps 16^(-1/2) of the mean
// square that white noise would have, one of 64 pixels 64^(-1/2). Blocks across the curve's squares keep more.
TEST(BlueNoiseSampler, ErrorsCompensateAmongNeighbours) {
  for (const std::uint32_t samples : {1u, 4u})
    for (const std::uint32_t dimension : {0u, 3u}) {
      const auto blue = error_image(SamplerKind::blue_noise, samples, dimension);
      const double white = mean_square(blue);
      EXPECT_LT(low_frequencies(blue, 4, 0), 0.3 * white) << samples << " samples, dimension " << dimension;
      EXPECT_LT(low_frequencies(blue, 8, 0), 0.2 * white) << samples << " samples, dimension " << dimension;
      EXPECT_LT(low_frequencies(blue, 4, 3), 0.75 * white) << samples << " samples, dimension " << dimension;
      EXPECT_LT(low_frequencies(blue, 8, 3), 0.5 * white) << samples << " samples, dimension " << dimension;
    }
}

// The order of the points makes the difference: these errors are white.
TEST(BlueNoiseSampler, ErrorsOfTheOthersDoNot) {
  for (const SamplerKind kind : {SamplerKind::independent, SamplerKind::sobol})
    for (const std::uint32_t samples : {1u, 4u}) {
      const auto errors = error_image(kind, samples, 0);
      EXPECT_NEAR(low_frequencies(errors, 4, 3) / mean_square(errors), 1, 0.15) << static_cast<int>(kind);
    }
}

// Nothing is paid for it: pixel by pixel the errors are those of Sobol' points. All pixels share one scramble of each
// dimension, so that takes the mean over several.
TEST(BlueNoiseSampler, ErrorsOfAPixelAreThoseOfSobolPoints) {
  double blue = 0, sobol = 0;
  for (std::uint32_t dimension = 0; dimension < 32; ++dimension) {
    blue += mean_square(error_image(SamplerKind::blue_noise, 4, dimension));
    sobol += mean_square(error_image(SamplerKind::sobol, 4, dimension));
  }
  EXPECT_NEAR(blue / sobol, 1, 0.1);
}

}  // namespace
}  // namespace lambert
