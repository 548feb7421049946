/// What holds for every sampler.

#include "lambert/sampling/sampler.h"

#include "lambert/base/error.h"
#include "lambert/sampling/sampling_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lambert {
namespace {

class EverySampler : public testing::TestWithParam<std::string> {
 protected:
  SamplerSettings settings(std::uint32_t samples = 16, std::uint64_t seed = 0) const {
    return {sampler_kind(GetParam()), samples, seed, {256, 256}};
  }
  /// The pair in dimension `dimension` of one sample.
  Vec2 at(Vec2i pixel, std::uint32_t sample, std::uint32_t dimension, std::uint64_t seed = 0) const {
    Sampler s(settings(16, seed), pixel, sample);
    s.set_dimension(dimension);
    return s.next2();
  }
};
std::string test_name(const testing::TestParamInfo<std::string>& test) {
  std::string name = test.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(, EverySampler, testing::ValuesIn(sampler_names()), test_name);

constexpr int all_samplers = 5;

TEST_P(EverySampler, NumbersLieInZeroToOne) {
  for (int p = 0; p < 200; ++p)
    for (const std::uint32_t sample : {0u, 1u, 15u, 16u, 63u, 1000u, 0xffffffffu}) {
      Sampler s(settings(), {p * 7 % 256, p}, sample);
      for (int d = 0; d < 40; ++d) {
        const float x = s.next();
        const Vec2 v = s.next2();
        ASSERT_TRUE(x >= 0 && x < 1 && v.x >= 0 && v.x < 1 && v.y >= 0 && v.y < 1) << x << " " << v.x << " " << v.y;
      }
    }
}

TEST_P(EverySampler, TheSameKeyGivesTheSameNumbers) {
  Sampler a(settings(16, 7), {3, 4}, 5), b(settings(16, 7), {3, 4}, 5);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(a.next2(), b.next2());
}

TEST_P(EverySampler, SetDimensionComesBackToTheSameNumbers) {
  Sampler s(settings(), {9, 2}, 3);
  std::vector<Vec2> pairs;
  for (std::uint32_t d = 0; d < 10; ++d) {
    EXPECT_EQ(s.dimension(), d);
    pairs.push_back(s.next2());
  }
  for (const std::uint32_t d : {7u, 0u, 4u, 4u}) {
    s.set_dimension(d);
    EXPECT_EQ(s.next2(), pairs[d]);
    EXPECT_EQ(s.dimension(), d + 1);
    s.set_dimension(d);
    EXPECT_EQ(s.next(), pairs[d].x) << "one number takes a dimension too";
    EXPECT_EQ(s.dimension(), d + 1);
  }
}

using Draw = std::function<std::pair<float, float>(int)>;

/// Chi-square of 65536 pairs over a grid of 16 by 16 cells: whether they are independent and uniform. What is better
/// spread than random passes.
statistics::TestResult joint_test(const Draw& draw, int tests) {
  constexpr int side = 16, n = 1 << 16;
  std::vector<double> observed(side * side), expected(side * side, static_cast<double>(n) / (side * side));
  for (int i = 0; i < n; ++i) {
    const auto [x, y] = draw(i);
    ++observed[static_cast<std::size_t>(y * side) * side + static_cast<std::size_t>(x * side)];
  }
  return statistics::chi_square(observed, expected, tests);
}
Vec2i pixel_of(int i) { return {i % 256, i / 256}; }

// Over the pixels of an image every dimension of every sample is uniform.
TEST_P(EverySampler, PairsAreUniformOverPixels) {
  for (const std::uint32_t sample : {0u, 1u, 13u})
    for (const std::uint32_t dimension : {0u, 5u, 40u}) {
      const auto result = joint_test(
          [&](int i) {
            const Vec2 v = at(pixel_of(i), sample, dimension);
            return std::pair(v.x, v.y);
          },
          9 * all_samplers);
      EXPECT_TRUE(result) << "sample " << sample << ", dimension " << dimension << ": " << result.message;
    }
}

TEST_P(EverySampler, DimensionsAreIndependentOfEachOther) {
  for (const auto& [a, b] : {std::pair(0u, 1u), std::pair(0u, 2u), std::pair(3u, 4u), std::pair(2u, 34u)}) {
    const auto result =
        joint_test([&, a = a, b = b](int i) { return std::pair(at(pixel_of(i), 3, a).x, at(pixel_of(i), 3, b).x); },
                   4 * all_samplers);
    EXPECT_TRUE(result) << "dimensions " << a << " and " << b << ": " << result.message;
  }
}

TEST_P(EverySampler, SeedsAreIndependentOfEachOther) {
  for (const std::uint64_t seed : {1ull, 2ull, 1ull << 40}) {
    const auto result = joint_test(
        [&](int i) { return std::pair(at(pixel_of(i), 3, 0, 0).x, at(pixel_of(i), 3, 0, seed).x); }, 3 * all_samplers);
    EXPECT_TRUE(result) << "seed " << seed << ": " << result.message;
  }
}

/// All but the blue-noise sampler, whose neighbouring pixels differ on purpose.
class PixelwiseSampler : public EverySampler {};
INSTANTIATE_TEST_SUITE_P(, PixelwiseSampler, testing::Values("independent", "stratified", "halton", "sobol"),
                         test_name);

TEST_P(PixelwiseSampler, PixelsAreIndependentOfEachOther) {
  for (const Vec2i step : {Vec2i(1, 0), Vec2i(0, 1), Vec2i(16, 0), Vec2i(1, 1)}) {
    const auto result = joint_test(
        [&](int i) { return std::pair(at(pixel_of(i), 3, 0).x, at(pixel_of(i) + step, 3, 0).x); }, 4 * all_samplers);
    EXPECT_TRUE(result) << "step " << step.x << " " << step.y << ": " << result.message;
  }
}

/// The mean over a pixel's first `samples` samples of a function of two pairs, in exact mean 1.
double pixel_mean(const SamplerSettings& settings, Vec2i pixel, std::uint32_t samples) {
  double sum = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    Sampler s(settings, pixel, i);
    const Vec2 a = s.next2(), b = s.next2();
    sum += 16 * static_cast<double>(a.x * a.y * b.x * b.y);
  }
  return sum / samples;
}

// rows: PT-11 PT-22
TEST_P(EverySampler, EstimatesWithoutBias) {
  Mean mean;
  for (int i = 0; i < 2000; ++i) mean.add(pixel_mean(settings(16), pixel_of(i * 31 + i / 8), 16));
  // Neighbouring pixels of the blue-noise sampler compensate each other: its standard error is even smaller.
  const auto result = statistics::z_test(mean.value(), mean.standard_error(), 1, all_samplers);
  EXPECT_TRUE(result) << mean.value() << ": " << result.message;
}

TEST_P(EverySampler, SamplesOfAPixelAreDistinct) {
  std::set<std::pair<float, float>> seen;
  for (std::uint32_t i = 0; i < 64; ++i) {  // four times as many as planned
    Sampler s(settings(16), {1, 1}, i);
    const Vec2 v = s.next2();
    EXPECT_TRUE(seen.emplace(v.x, v.y).second) << "sample " << i;
  }
}

TEST(Sampler, NamesAreThoseOfTheCommandLine) {
  EXPECT_EQ(sampler_names(), (std::vector<std::string>{"independent", "stratified", "halton", "sobol", "blue-noise"}));
  EXPECT_EQ(sampler_kind("blue-noise"), SamplerKind::blue_noise);
  try {
    sampler_kind("sobel");
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("sobol"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace lambert
