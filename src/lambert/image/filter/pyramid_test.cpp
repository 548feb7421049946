#include "lambert/image/filter/pyramid.h"

#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambert {
namespace {

double mean(const Image& image, std::size_t c) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += static_cast<double>(image.at(x, y, c));
  return sum / image.width() / image.height();
}

// rows: AA-20
TEST(Pyramid, FourThirdsOfTheMemory) {
  const Pyramid p(noise(512, 512, rgb_channels()));
  EXPECT_EQ(p.level_count(), 10);
  EXPECT_EQ(p.value_count(), 1048575u);
  for (int y = 0; y < 256; y += 7)
    for (int x = 0; x < 256; x += 7) {
      const Image& b = p.level(0);
      EXPECT_NEAR(p.level(1).at(x, y, 1),
                  (b.at(2 * x, 2 * y, 1) + b.at(2 * x + 1, 2 * y, 1) + b.at(2 * x, 2 * y + 1, 1) +
                   b.at(2 * x + 1, 2 * y + 1, 1)) /
                      4,
                  1e-6f);
    }
}

TEST(Pyramid, OddSizesKeepTheMean) {
  for (const auto& [width, height] : {std::pair{13, 7}, {5, 5}, {1, 9}, {31, 2}, {3, 3}, {1, 1}}) {
    const Pyramid p(noise(width, height, {"R", "G", "B", "A", "Z"}));
    for (int i = 1; i < p.level_count(); ++i)
      for (std::size_t c = 0; c < 5; ++c) EXPECT_NEAR(mean(p.level(i), c), mean(p.level(0), c), 1e-6) << width;
    EXPECT_EQ(p.level(p.level_count() - 1).pixels().size(), 5u);
  }
}

// rows: AA-20
TEST(Pyramid, PacksIntoOneSquareAndBack) {
  const Pyramid p(noise(16, 16, rgba_channels()));
  const Image square = packed(p);
  ASSERT_EQ(Vec2i(square.width(), square.height()), Vec2i(32));
  EXPECT_EQ(square.at(3, 5, 0), p.level(0).at(3, 5, 0));
  EXPECT_EQ(square.at(16 + 3, 5, 0), p.level(0).at(3, 5, 1));
  EXPECT_EQ(square.at(3, 16 + 5, 0), p.level(0).at(3, 5, 2));
  EXPECT_EQ(square.at(16 + 3, 16 + 5, 0), p.level(1).at(3, 5, 0)) << "the last quarter is the next level";
  EXPECT_EQ(square.at(31, 31, 0), 0) << "the one texel that is left";
  const Pyramid again = unpacked(square);
  ASSERT_EQ(again.level_count(), p.level_count());
  for (int i = 0; i < p.level_count(); ++i)
    for (int y = 0; y < p.level(i).height(); ++y)
      for (int x = 0; x < p.level(i).width(); ++x)
        for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(again.level(i).at(x, y, c), p.level(i).at(x, y, c));
}

TEST(Pyramid, RefusesWhatIsNone) {
  EXPECT_NE(error_of([] { packed(Pyramid(Image(12, 12, rgb_channels()))); }).find("12x12"), std::string::npos);
  EXPECT_NE(error_of([] { packed(Pyramid(Image(8, 8, {"Y"}))); }).find("R, G"), std::string::npos);
  EXPECT_NE(error_of([] { unpacked(Image(1, 1, {"Y"})); }).find("1x1"), std::string::npos);
  EXPECT_NE(error_of([] { unpacked(Image(6, 6, {"Y"})); }).find("6x6"), std::string::npos);
  EXPECT_NE(error_of([] { Pyramid(std::vector<Image>{Image(2, 2, {"Y"})}); }).find("halve"), std::string::npos);
}

// rows: AA-22
TEST(Pyramid, BilinearAndTrilinear) {
  Image two(2, 2, {"Y"});
  std::ranges::copy(std::vector<float>{10, 20, 30, 40}, two.pixels().begin());
  const Pyramid p(two);
  const LookupSettings clamped{.edges = {EdgeMode::clamp, EdgeMode::clamp}};
  const Vec2 uv(0.375f, 0.5f);  // fractions .25 and .5
  EXPECT_NEAR(p.lookup(uv, {}, clamped).x, 22.5f, 1e-5f);
  const float d = std::exp2(0.3f) / 2;  // 2^.3 texels
  for (const Footprint& f :
       {Footprint{{d, 0}, {0, d}}, Footprint{{0, d}, {0, 0}}, Footprint{{0, 0}, {0.6f * d, 0.8f * d}}})
    EXPECT_NEAR(p.lookup(uv, f, clamped).x, 22.5f + 0.3f * (25 - 22.5f), 1e-4f);
  EXPECT_NEAR(p.lookup(uv, {{9, 0}, {0, 9}}, clamped).x, 25, 1e-5f);
}

TEST(Pyramid, TexelCentresAndChannels) {
  const Image image = noise(8, 4, {"R", "G", "B", "Z", "A"});
  const Pyramid p(image);
  for (const std::string& name : lookup_method_names())
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 8; ++x) {
        const Vec2 uv((static_cast<float>(x) + 0.5f) / 8, (static_cast<float>(y) + 0.5f) / 4);
        EXPECT_EQ(p.lookup(uv, {}, {.method = lookup_method(name)}),
                  Vec4(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2), image.at(x, y, 4)));
      }
  EXPECT_EQ(Pyramid(noise(1, 1, {"Y"})).lookup(Vec2(0.5f)).w, 1);
  EXPECT_EQ(p.lookup({1.5f, 0.5f}, {}, {.edges = {EdgeMode::black, EdgeMode::black}}), Vec4(0));
}

/// The mean of cos(k x) over the unit disk by the weights exp(-2 r²) - exp(-2).
double characteristic(double k) {
  double sum = 0, weights = 0;
  for (double y = -0.995; y < 1; y += 0.01)
    for (double x = -0.995; x < 1; x += 0.01) {
      const double w = std::max(0.0, std::exp(-2 * (x * x + y * y)) - std::exp(-2.0));
      sum += w * std::cos(k * x);
      weights += w;
    }
  return sum / weights;
}

// On a texture that is a cosine wave k, an ellipse of matrix Q gives the weights' transform at √(k'Qk).
TEST(Pyramid, TheEllipseHasItsAxes) {
  constexpr int n = 256;
  for (const double angle : {0.0, 0.4, 1.2, 2.5})
    for (const double waves : {3.0, 6.0, 20.0}) {
      const double unit = 2 * std::numbers::pi / n;
      const Vec2d k(unit * std::round(waves * std::cos(angle)), unit * std::round(waves * std::sin(angle)));
      Image image(n, n, {"Y"});
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) image.at(x, y, 0) = static_cast<float>(std::cos(k.x * (x - 100) + k.y * (y - 90)));
      const Vec2 along(9, 4), across(-0.35f, 0.8f);  // in texels; the short axis is below one, so that level 0 serves
      const auto square = [&](Vec2 axis) { return std::pow(glm::dot(Vec2d(axis), k), 2); };
      const float seen =
          Pyramid(image)
              .lookup({100.5f / n, 90.5f / n}, {along / static_cast<float>(n), across / static_cast<float>(n)},
                      {.method = LookupMethod::anisotropic, .max_anisotropy = 64})
              .x;
      EXPECT_NEAR(seen, characteristic(std::sqrt(square(along) + square(across) + glm::dot(k, k))), 0.01)
          << angle << " " << waves;
    }
}

TEST(Pyramid, AnisotropicKeepsWhatTheRoundFilterLoses) {
  Image stripes(256, 256, {"Y"});
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) stripes.at(x, y, 0) = static_cast<float>(x / 4 % 2);
  const Pyramid p(stripes);
  const Footprint long_pixel{{1.0f / 256, 0}, {0, 12.0f / 256}};  // along the stripes
  const Vec2 on_white(6.0f / 256, 0.4f);
  EXPECT_NEAR(p.lookup(on_white, long_pixel, {.method = LookupMethod::trilinear}).x, 0.5f, 0.05f);
  EXPECT_GT(p.lookup(on_white, long_pixel, {.method = LookupMethod::anisotropic}).x, 0.9f);
}

TEST(Pyramid, ConstantsStayWhateverTheFootprint) {
  Image flat(30, 17, rgb_channels());
  std::ranges::fill(flat.pixels(), 0.4f);
  const Pyramid p(flat);
  for (const std::string& name : lookup_method_names())
    for (const float size : {0.0f, 0.01f, 0.3f, 5.0f, 1e6f, 1e30f, HUGE_VALF, NAN})
      for (const Footprint& f : {Footprint{{size, 0}, {0, 0.01f}}, Footprint{{size, size}, {size, size}}})
        for (const Vec2 uv : {Vec2(0.3f), Vec2(-7.2f, 1e9f), Vec2(NAN, HUGE_VALF)})
          EXPECT_NEAR(p.lookup(uv, f, {.method = lookup_method(name)}).y, 0.4f, 1e-5f) << name << " " << size;
}

}  // namespace
}  // namespace lambert
