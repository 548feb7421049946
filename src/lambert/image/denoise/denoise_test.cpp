#include "lambert/image/denoise/denoise.h"

#include "lambert/base/error.h"
#include "lambert/base/hash.h"
#include "lambert/base/parallel.h"
#include "lambert/image/denoise/exp_of_minus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace lambert {
namespace {

float normal_number(int x, int y, int key) {
  const std::uint64_t h = hash_values(x, y, key);
  const float u = hash_to_float(h), v = hash_to_float(mix_bits(h));
  return std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * std::numbers::pi_v<float> * v);
}

const std::vector<std::string> layers{"R",
                                      "G",
                                      "B",
                                      "A",
                                      "denoising.a.R",
                                      "denoising.a.G",
                                      "denoising.a.B",
                                      "denoising.b.R",
                                      "denoising.b.G",
                                      "denoising.b.B",
                                      "denoising.variance.R",
                                      "denoising.variance.G",
                                      "denoising.variance.B",
                                      "albedo.R",
                                      "albedo.G",
                                      "albedo.B"};

/// light(x, y) times albedo(x, y), with independent Gaussian noise of `sigma` in each half, relative to the albedo.
template <class Light, class Albedo>
Image noisy(int width, int height, float sigma, Light light, Albedo albedo) {
  Image image(width, height, layers);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float a = albedo(x, y), truth = light(x, y) * a;
        const float na = sigma * a * normal_number(x, y, static_cast<int>(c)),
                    nb = sigma * a * normal_number(x, y, static_cast<int>(c) + 3);
        image.at(x, y, c) = truth + 0.5f * (na + nb);
        image.at(x, y, 4 + c) = truth + na;
        image.at(x, y, 7 + c) = truth + nb;
        image.at(x, y, 10 + c) = 0.5f * sigma * sigma * a * a;
        image.at(x, y, 13 + c) = a;
        image.at(x, y, 3) = 1;
      }
  return image;
}
float one(int, int) { return 1; }

template <class Truth>
double mean_squared_error(const Image& image, Truth truth) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (std::size_t c = 0; c < 3; ++c) sum += std::pow(static_cast<double>(image.at(x, y, c) - truth(x, y)), 2);
  return sum / (3.0 * image.width() * image.height());
}

class EveryMethod : public testing::TestWithParam<DenoiseMethod> {
 protected:
  Image run(const Image& image) const { return denoise_image(image, {.method = GetParam()}); }
};
INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         testing::Values(DenoiseMethod::nfor, DenoiseMethod::nlm, DenoiseMethod::bilateral));

// The variance of a mean of n equals is 1/n: flat places must come near the size of the window, here at least 25.
TEST_P(EveryMethod, FlatNoiseShrinks) {
  const Image image = noisy(64, 48, 0.2f, one, one);
  const Image out = run(image);
  EXPECT_LT(mean_squared_error(out, one), mean_squared_error(image, one) / 25);
  double mean = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) mean += static_cast<double>(out.at(x, y, 1)) / (64 * 48);
  EXPECT_NEAR(mean, 1, 0.01) << "no light is lost";
}

TEST_P(EveryMethod, AnEdgeOfTheAlbedoStays) {
  const auto albedo = [](int x, int) { return x < 20 ? 0.2f : 0.8f; };
  const Image image = noisy(40, 40, 0.2f, one, albedo);
  const Image out = run(image);
  for (int y = 10; y < 30; ++y) {
    EXPECT_NEAR(out.at(19, y, 1), 0.2f, 0.04f);
    EXPECT_NEAR(out.at(20, y, 1), 0.8f, 0.16f);
  }
  EXPECT_LT(mean_squared_error(out, albedo), mean_squared_error(image, albedo) / 15);
}

TEST_P(EveryMethod, TheBitsDoNotDependOnThreads) {
  const Image image = noisy(
      70, 45, 0.3f, [](int x, int y) { return 1 + 0.01f * static_cast<float>(x * y % 37); }, one);
  set_thread_count(1);
  const Image a = run(image);
  set_thread_count(2);
  const Image b = run(image);
  set_thread_count(0);
  EXPECT_TRUE(std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin()));
}

TEST_P(EveryMethod, AnySizeWorks) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {2, 2}, {33, 3}, {65, 1}}) {
    const Image out = run(noisy(width, height, 0.1f, one, one));
    for (const float v : out.pixels()) EXPECT_TRUE(std::isfinite(v)) << width << "x" << height;
  }
}

TEST_P(EveryMethod, WhatIsNotANumberIsFilledFromItsNeighbours) {
  Image image = noisy(40, 40, 0.1f, one, one);
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (std::size_t c = 0; c < image.channel_count(); ++c) image.at(20, 20, c) = nan, image.at(0, 39, c) = infinity;
  for (std::size_t c = 4; c < 7; ++c) image.at(8, 9, c) = -infinity;
  const Image out = run(image);
  for (const auto& [x, y] : {std::pair{20, 20}, {21, 20}, {0, 39}, {8, 9}}) EXPECT_NEAR(out.at(x, y, 0), 1, 0.2f);
}

TEST_P(EveryMethod, DoesNotDependOnTheUnitOfRadiance) {
  const Image image = noisy(
      40, 33, 0.3f, [](int x, int y) { return x > 17 ? 1.0f : 0.1f * static_cast<float>(y); }, one);
  const Image out = run(image);
  for (const float factor : {0x1p-30f, 0x1p36f}) {
    Image scaled = image;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        for (std::size_t c = 0; c < 13; ++c)
          if (c != 3) scaled.at(x, y, c) *= c < 10 ? factor : factor * factor;
    const Image scaled_out = run(scaled);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) EXPECT_EQ(scaled_out.at(x, y, 0), factor * out.at(x, y, 0));
  }
}

TEST_P(EveryMethod, ExtremesStayFinite) {
  Image image = noisy(40, 40, 0.3f, one, one);
  for (std::size_t c = 0; c < image.channel_count(); ++c) {
    image.at(3, 3, c) = 1e38f, image.at(9, 9, c) = -1e38f, image.at(20, 20, c) = 9e14f, image.at(30, 30, c) = -9e14f;
    image.at(5, 30, c) = 1e-40f;
  }
  for (const Image& out : {run(image), run(Image(33, 40, layers))})
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < out.width(); ++x) EXPECT_TRUE(std::isfinite(out.at(x, y, 1))) << x << " " << y;
}

// A caustic: one sample in eight is bright. Its patches are so noisy that they look like the dark ones beside it.
TEST(Nfor, KeepsTheEdgeOfACaustic) {
  const auto truth = [](int x, int y) { return std::abs(x - 32) < 12 && std::abs(y - 24) < 8 ? 8.0f : 0.25f; };
  Image image = noisy(64, 48, 0.05f, truth, one);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      if (truth(x, y) < 1) continue;
      std::array<float, 2> half{};
      for (int sample = 0; sample < 16; ++sample)
        half[static_cast<std::size_t>(sample % 2)] += hash_values(x, y, 100 + sample) % 8 == 0 ? 8.0f : 0.0f;
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y, c) = 0.5f * (half[0] + half[1]);
        image.at(x, y, 4 + c) = half[0], image.at(x, y, 7 + c) = half[1];
        image.at(x, y, 10 + c) = 28;
      }
    }
  const auto error = [&](DenoiseMethod method) {
    return mean_squared_error(denoise_image(image, {.method = method}), truth);
  };
  const double nfor = error(DenoiseMethod::nfor);
  EXPECT_LT(nfor, mean_squared_error(image, truth) / 5);
  EXPECT_LT(nfor, error(DenoiseMethod::nlm));
  EXPECT_LT(nfor, error(DenoiseMethod::bilateral));
}

TEST(Nfor, LeavesAPictureWithoutNoiseAsItIs) {
  const auto light = [](int x, int y) {
    return 0.5f + 0.3f * std::sin(0.9f * static_cast<float>(x)) + (x > 13 && y > 20 ? 4.0f : 0.0f) +
           (x == 30 && y == 7 ? 50.0f : 0.0f);
  };
  const auto albedo = [](int x, int y) { return (x / 3 + y / 3) % 2 == 0 ? 0.7f : 0.1f; };
  const Image image = noisy(50, 40, 0, light, albedo);
  const Image out = denoise_image(image, {.method = DenoiseMethod::nfor});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 50; ++x) EXPECT_NEAR(out.at(x, y, 0), image.at(x, y, 0), 2e-3f * image.at(x, y, 0));
}

TEST(Nfor, FollowsASlope) {
  const auto slope = [](int x, int y) { return 1 + 0.05f * static_cast<float>(x) + 0.02f * static_cast<float>(y); };
  const Image image = noisy(64, 64, 0.2f, slope, one);
  const Image out = denoise_image(image, {.method = DenoiseMethod::nfor});
  EXPECT_LT(mean_squared_error(out, slope), mean_squared_error(image, slope) / 20);
}

TEST(Denoise, TakesAFireflyAway) {
  Image image = noisy(40, 40, 0.05f, one, one);
  for (std::size_t c = 0; c < 3; ++c) {
    image.at(20, 20, 4 + c) = 500;
    image.at(20, 20, c) = 250;
    image.at(20, 20, 10 + c) = 250 * 250;
  }
  EXPECT_LT(denoise_image(image, {.method = DenoiseMethod::nfor}).at(20, 20, 0), 1.5f);
}

TEST(Denoise, TakesAFireflyOfBothHalvesAway) {
  Image image = noisy(40, 40, 0.05f, one, one);
  for (std::size_t c = 0; c < 3; ++c) {
    image.at(20, 20, c) = 10;
    image.at(20, 20, 4 + c) = 10.02f, image.at(20, 20, 7 + c) = 9.98f;
    image.at(20, 20, 10 + c) = 40;
  }
  const Image out = denoise_image(image, {.method = DenoiseMethod::nfor});
  for (int y = 18; y < 23; ++y)
    for (int x = 18; x < 23; ++x) EXPECT_LT(out.at(x, y, 0), 2) << x << " " << y;
}

TEST(Denoise, NeedsNoMoreThanColour) {
  const Image full = noisy(64, 64, 0.3f, one, one);
  Image bare(64, 64, rgb_channels());
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) bare.set_rgb(x, y, full.rgb(x, y));
  const Image out = denoise_image(bare, {.method = DenoiseMethod::nfor});
  EXPECT_LT(mean_squared_error(out, one), mean_squared_error(bare, one) / 8);
}

TEST(Denoise, KnowsOtherNames) {
  const Image full = noisy(32, 32, 0.3f, one, one);
  Image image(32, 32,
              {"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.Combined.A",
               "ViewLayer.Denoising Albedo.R", "ViewLayer.Denoising Albedo.G", "ViewLayer.Denoising Albedo.B"});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = full.at(x, y, c), image.at(x, y, 4 + c) = 0.5f;
      image.at(x, y, 3) = 0.25f;
    }
  ASSERT_NE(denoise::gather(image).guide(denoise::GuideKind::albedo), nullptr);
  const Image out = denoise_image(image, {.method = DenoiseMethod::nfor});
  EXPECT_EQ(out.channels()[0], "R");
  EXPECT_EQ(out.at(3, 3, *out.channel("ViewLayer.Combined.A")), 0.25f);
  EXPECT_THROW(denoise_image(Image(2, 2, {"Z"}), {.method = DenoiseMethod::nfor}), Error);
}

TEST(Denoise, ANormalIsNoDepth) {
  const denoise::NoisyImage seen = denoise::gather(Image(4, 4, {"R", "G", "B", "normal.X", "normal.Y", "normal.Z"}));
  EXPECT_NE(seen.guide(denoise::GuideKind::normal), nullptr);
  EXPECT_EQ(seen.guide(denoise::GuideKind::depth), nullptr);
  EXPECT_NE(denoise::gather(Image(4, 4, {"R", "G", "B", "Z"})).guide(denoise::GuideKind::depth), nullptr);
}

TEST(Denoise, KeepsTheLayersWhenAsked) {
  const Image image = noisy(8, 8, 0.1f, one, one);
  EXPECT_EQ(denoise_image(image, {.method = DenoiseMethod::nfor, .keep_layers = true}).channels(), layers);
}

TEST(Denoise, KeepsWindowsGreyAndOtherChannels) {
  Image image(8, 6, {"Y", "A", "Z", "denoising.extra"});
  for (float& v : image.pixels()) v = 0.5f;
  image.place({3, -2}, {0, 0, 20, 20});
  const Image out = denoise_image(image, {.method = DenoiseMethod::nfor});
  EXPECT_EQ(out.channels(), (std::vector<std::string>{"Y", "A", "Z"}));
  EXPECT_EQ(out.data_window(), image.data_window());
  EXPECT_EQ(out.display_window(), image.display_window());
  EXPECT_NEAR(out.at(4, 4, 0), 0.5f, 1e-3f);
  EXPECT_EQ(out.at(4, 4, 2), 0.5f);
}

TEST(ExpOfMinus, IsThatOfTheLibrary) {
  for (float x = 0; x < 87; x += 0.37f) EXPECT_NEAR(denoise::exp_of_minus(x) / std::exp(-x), 1, 5e-5f) << x;
  EXPECT_LT(denoise::exp_of_minus(std::numeric_limits<float>::infinity()), 1e-37f);
}

}  // namespace
}  // namespace lambert
