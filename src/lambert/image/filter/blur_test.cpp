#include "lambert/image/filter/blur.h"

#include "damage.h"
#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace lambert {
namespace {

constexpr std::array edges = {EdgeMode::repeat, EdgeMode::mirror, EdgeMode::clamp, EdgeMode::black};

/// Σ w(k) in(i + k) along both axes in double precision, without any cleverness.
std::vector<double> brute_force(const Image& image, Vec2i radius, const std::function<double(int)>& wx,
                                const std::function<double(int)>& wy, EdgeMode edge) {
  const auto norm = [](int r, const auto& w) {
    double sum = 0;
    for (int k = -r; k <= r; ++k) sum += w(k);
    return sum;
  };
  const double norm_x = norm(radius.x, wx), norm_y = norm(radius.y, wy);
  const int w = image.width(), h = image.height();
  const std::size_t channels = image.channel_count();
  std::vector<double> down(image.pixels().size()), out(down.size());
  const auto at = [&](int x, int y, std::size_t c) { return static_cast<std::size_t>(y * w + x) * channels + c; };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      for (std::size_t c = 0; c < channels; ++c)
        for (int k = -radius.y; k <= radius.y; ++k)
          if (const int j = edge_index(y + k, h, edge); j >= 0)
            down[at(x, y, c)] += wy(k) / norm_y * static_cast<double>(image.at(x, j, c));
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      for (std::size_t c = 0; c < channels; ++c)
        for (int k = -radius.x; k <= radius.x; ++k)
          if (const int j = edge_index(x + k, w, edge); j >= 0) out[at(x, y, c)] += wx(k) / norm_x * down[at(j, y, c)];
  return out;
}

double largest_difference(const Image& image, const std::vector<double>& expected) {
  double largest = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(image.pixels()[i]) - expected[i]));
  return largest;
}

std::function<double(int)> gaussian(double sigma) {
  return [sigma](int k) { return std::exp(-k * k / (2 * sigma * sigma)); };
}

TEST(Blur, GaussianIsTheGaussian) {
  for (const EdgeMode edge : edges) {
    const Image image = noise(43, 29, {"R", "G", "B", "A", "Z"});
    const auto expected = brute_force(image, {20, 20}, gaussian(1.3), gaussian(2.7), edge);
    EXPECT_LT(largest_difference(gaussian_blurred(image, {1.3f, 2.7f}, edge), expected), 2e-6)
        << edge_mode_names()[static_cast<std::size_t>(edge)];
  }
}

// The stated bound holds against the true Gaussian, from the smallest deviation it serves to one above the image.
TEST(Blur, DecimatedGaussianKeepsItsBound) {
  for (const EdgeMode edge : edges)
    for (const double sigma : {2.0, 5.3, 31.0}) {
      const Image image = noise(61, 37, {"Y"});
      const int radius = static_cast<int>(8 * sigma);
      const auto expected = brute_force(image, Vec2i(radius), gaussian(sigma), gaussian(sigma), edge);
      const Image out = gaussian_blurred(image, Vec2(static_cast<float>(sigma)), edge, GaussianMethod::decimated);
      EXPECT_LT(largest_difference(out, expected), 3e-6) << sigma << " " << static_cast<int>(edge);
    }
}

TEST(Blur, GaussiansAddTheirVariances) {
  const Image image = noise(64, 48, {"Y"});
  const Image twice = gaussian_blurred(gaussian_blurred(image, Vec2(3), EdgeMode::repeat), Vec2(4), EdgeMode::repeat);
  const Image once = gaussian_blurred(image, Vec2(5), EdgeMode::repeat);
  for (std::size_t i = 0; i < once.pixels().size(); ++i) EXPECT_NEAR(twice.pixels()[i], once.pixels()[i], 1e-5f);
}

TEST(Blur, BoxAndBartlettAreTheirWeights) {
  for (const EdgeMode edge : edges)
    for (const Vec2i radius : {Vec2i(0, 3), Vec2i(1, 1), Vec2i(4, 0), Vec2i(50, 7)}) {
      const Image image = noise(21, 18, {"R", "G", "B"});
      const auto flat = [](int) { return 1.0; };
      EXPECT_LT(largest_difference(box_blurred(image, radius, edge), brute_force(image, radius, flat, flat, edge)),
                3e-6);
      const auto tent = [](int r) { return [r](int k) { return r + 1.0 - std::abs(k); }; };
      EXPECT_LT(largest_difference(bartlett_blurred(image, radius, edge),
                                   brute_force(image, radius, tent(radius.x), tent(radius.y), edge)),
                3e-6);
    }
}

TEST(Blur, ConstantsStayAndWindowsToo) {
  Image image(17, 11, {"R", "Z"});
  for (float& v : image.pixels()) v = 0.7f;
  image.place({-3, 4}, {0, 0, 100, 50});
  for (const EdgeMode edge : {EdgeMode::repeat, EdgeMode::mirror, EdgeMode::clamp})
    for (const Image& out :
         {gaussian_blurred(image, {0.5f, 9}, edge), gaussian_blurred(image, Vec2(300), edge),
          box_blurred(image, {2, 40}, edge), bartlett_blurred(image, {3, 1}, edge), gaussian_blurred(image, Vec2(0))}) {
      for (const float v : out.pixels()) EXPECT_NEAR(v, 0.7f, 2e-6f);
      EXPECT_EQ(out.data_window(), image.data_window());
      EXPECT_EQ(out.display_window(), image.display_window());
      EXPECT_EQ(out.channels(), image.channels());
    }
}

TEST(Blur, OnePixel) {
  Image image(1, 1, {"Y"});
  image.at(0, 0, 0) = 3;
  EXPECT_NEAR(gaussian_blurred(image, Vec2(70)).at(0, 0, 0), 3, 1e-5f);
  EXPECT_NEAR(box_blurred(image, Vec2i(7), EdgeMode::black).at(0, 0, 0), 3 / 225.0f, 1e-6f);
}

TEST(Blur, NanStaysInItsWindow) {
  Image image = noise(40, 3, {"Y"});
  image.at(20, 1, 0) = NAN;
  const Image out = box_blurred(image, {2, 0});
  for (int x = 0; x < 40; ++x) EXPECT_EQ(std::isnan(out.at(x, 1, 0)), x >= 18 && x <= 22) << x;
}

TEST(Blur, RefusesWhatIsNoSize) {
  const Image image(2, 2, {"Y"});
  EXPECT_NE(error_of([&] { gaussian_blurred(image, {-1, 0}); }).find("deviation"), std::string::npos);
  EXPECT_NE(error_of([&] { gaussian_blurred(image, {NAN, 0}); }).find("deviation"), std::string::npos);
  EXPECT_NE(error_of([&] { box_blurred(image, {0, -1}); }).find("radius"), std::string::npos);
  EXPECT_NE(error_of([&] { bartlett_blurred(image, {0, 5000}); }).find("radius"), std::string::npos);
}

}  // namespace
}  // namespace lambert
