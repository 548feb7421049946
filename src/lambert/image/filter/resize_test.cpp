#include "lambert/image/filter/resize.h"

#include "damage.h"
#include "lambert/base/parallel.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert {
namespace {

constexpr std::array edges = {EdgeMode::repeat, EdgeMode::mirror, EdgeMode::clamp, EdgeMode::black};

double default_radius(FilterKind kind) { return Kernel({.kind = kind}, Kernel::Axis::x).radius(); }

/// The definition in double precision: both sums at once, every pixel by itself.
double expected_at(const Image& image, int width, int height, int x, int y, std::size_t c, const ResizeSettings& s) {
  const Kernel kx(s.filter, Kernel::Axis::x), ky(s.filter, Kernel::Axis::y);
  const double sx = static_cast<double>(image.width()) / width, sy = static_cast<double>(image.height()) / height;
  const double wide = std::max(1.0, sx), high = std::max(1.0, sy);
  const double u = (x + 0.5) * sx - 0.5, v = (y + 0.5) * sy - 0.5;
  double sum = 0, weights = 0;
  for (int j = static_cast<int>(v - ky.radius() * high) - 2; j <= v + ky.radius() * high + 2; ++j)
    for (int i = static_cast<int>(u - kx.radius() * wide) - 2; i <= u + kx.radius() * wide + 2; ++i) {
      const double w = kx((i - u) / wide) * ky((j - v) / high);
      weights += w;
      const int ii = edge_index(i, image.width(), s.edge), jj = edge_index(j, image.height(), s.edge);
      if (ii >= 0 && jj >= 0) sum += w * static_cast<double>(image.at(ii, jj, c));
    }
  return sum / weights;
}

// Every kernel, ratios that enlarge, shrink and mix, from one channel to eleven, against the definition.
TEST(Resize, IsTheWeightedMean) {
  const std::pair<Vec2i, Vec2i> sizes[] = {{{37, 23}, {53, 61}}, {{41, 30}, {11, 7}}, {{20, 45}, {47, 16}},
                                           {{1, 1}, {5, 3}},     {{90, 4}, {1, 1}},   {{8, 8}, {8, 8}}};
  std::size_t channels = 1;
  for (const std::string& name : filter_names())
    for (const auto& [from, to] : sizes) {
      channels = channels % 11 + 1;
      const Image image = noise(from.x, from.y, std::vector<std::string>(channels, "X"));
      const ResizeSettings s{.filter = {.kind = filter_kind(name)}, .edge = edges[channels % 4]};
      const Image out = resized(image, to.x, to.y, s);
      ASSERT_EQ(Vec2i(out.width(), out.height()), to);
      double largest = 0;
      for (int y = 0; y < to.y; ++y)
        for (int x = 0; x < to.x; ++x)
          for (std::size_t c = 0; c < channels; c += 2)
            largest = std::max(
                largest, std::abs(static_cast<double>(out.at(x, y, c)) - expected_at(image, to.x, to.y, x, y, c, s)));
      EXPECT_LT(largest, 2e-6) << name << " " << from.x << " to " << to.x << " edge " << static_cast<int>(s.edge);
    }
}

// 53 to 40 and 37 to 28 put centres of pixels on the very ends of the box.
TEST(Resize, MirroredImagesGiveMirroredResults) {
  const Image image = noise(53, 37, {"Y"});
  Image mirrored = image;
  for (int y = 0; y < 37; ++y)
    for (int x = 0; x < 53; ++x) mirrored.at(x, y, 0) = image.at(52 - x, 36 - y, 0);
  for (const Vec2i size : {Vec2i(40, 28), Vec2i(22, 16), Vec2i(25, 18), Vec2i(70, 50)})
    for (const FilterKind kind : {FilterKind::box, FilterKind::triangle, FilterKind::lanczos}) {
      const ResizeSettings settings{.filter = {.kind = kind}};
      const Image a = resized(image, size.x, size.y, settings), b = resized(mirrored, size.x, size.y, settings);
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
          ASSERT_NEAR(a.at(x, y, 0), b.at(size.x - 1 - x, size.y - 1 - y, 0), 2e-6f) << x << ' ' << y;
    }
}

TEST(Resize, ConstantsStay) {
  for (const std::string& name : filter_names())
    for (const EdgeMode edge : {EdgeMode::repeat, EdgeMode::mirror, EdgeMode::clamp})
      for (const int width : {1, 7, 100, 333}) {
        Image image(100, 9, {"R", "G", "B", "A"});
        std::ranges::fill(image.pixels(), 0.3f);
        const Image out = resized(image, width, 5, {.filter = {.kind = filter_kind(name)}, .edge = edge});
        for (const float v : out.pixels()) ASSERT_NEAR(v, 0.3f, 4e-7f) << name << " " << width;
      }
}

TEST(Resize, SameSizeChangesNothingWhereTheKernelInterpolates) {
  const Image image = noise(33, 14, {"R", "G", "B"});
  for (const char* name : {"box", "triangle", "catmull-rom", "lanczos"}) {
    const Image out = resized(image, 33, 14, {.filter = {.kind = filter_kind(name)}});
    for (std::size_t i = 0; i < out.pixels().size(); ++i)
      EXPECT_NEAR(out.pixels()[i], image.pixels()[i], 1e-7f) << name;
  }
}

TEST(Resize, RampsStayRampsAwayFromTheEdges) {
  Image ramp(60, 1, {"Y"});
  for (int x = 0; x < 60; ++x) ramp.at(x, 0, 0) = static_cast<float>(x) + 0.5f;
  for (const char* name : {"triangle", "mitchell", "catmull-rom"}) {
    const Image out = resized(ramp, 90, 1, {.filter = {.kind = filter_kind(name)}});
    for (int x = 6; x < 84; ++x) EXPECT_NEAR(out.at(x, 0, 0), (static_cast<float>(x) + 0.5f) / 1.5f, 2e-5f) << name;
  }
}

// The alpha of a cut-out and its colour are filtered alike: where colour is alpha times white, it stays so.
TEST(Resize, PremultipliedPixelsStayPremultiplied) {
  Image image(40, 40, rgba_channels());
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      for (std::size_t c = 0; c < 4; ++c) image.at(x, y, c) = (x - 20) * (x - 20) + (y - 20) * (y - 20) < 200;
  const Image out = resized(image, 17, 23, {.filter = {.kind = FilterKind::lanczos}});
  for (int y = 0; y < 23; ++y)
    for (int x = 0; x < 17; ++x) EXPECT_EQ(out.at(x, y, 0), out.at(x, y, 3));
}

TEST(Resize, WindowsScaleTogether) {
  Image image = noise(20, 10, {"Y"});
  image.place({-4, 2}, {0, 0, 16, 12});
  const Image twice = resized(image, 32, 24, {.filter = {.kind = FilterKind::box}});
  EXPECT_EQ(twice.display_window(), (Window{0, 0, 32, 24}));
  EXPECT_EQ(twice.data_window(), (Window{-8, 4, 40, 20}));
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) EXPECT_EQ(twice.at(x, y, 0), image.at(x / 2, y / 2, 0));
  // Outwards to whole pixels: -4/3 .. 16/3 and 2/3 .. 4.
  EXPECT_EQ(resized(image, 16 / 3 + 0, 4).display_window(), (Window{0, 0, 5, 4}));
  EXPECT_EQ(resized(image, 8, 6).data_window(), (Window{-2, 1, 10, 5}));
  EXPECT_EQ(resized(image, 12, 9).data_window(), (Window{-3, 1, 15, 8}));
}

TEST(Resize, TheThreadCountDoesNotMatter) {
  const Image image = noise(301, 217, {"R", "G", "B"});
  const Image several = resized(image, 150, 400);
  set_thread_count(1);
  const Image one = resized(image, 150, 400);
  set_thread_count(0);
  EXPECT_TRUE(std::ranges::equal(one.pixels(), several.pixels()));
}

TEST(Resize, InfinityAndNanStayWithinTheKernel) {
  Image image = noise(64, 1, {"Y"});
  image.at(32, 0, 0) = NAN;
  const Image out = resized(image, 16, 1, {.filter = {.kind = FilterKind::triangle}});
  for (int x = 0; x < 16; ++x)
    EXPECT_EQ(std::isnan(out.at(x, 0, 0)), x == 7 || x == 8) << x << ": centres 4x + 1.5, reach 4";
}

TEST(Resize, NarrowKernelsReadTheNearestPixel) {
  const Image image = noise(5, 1, {"Y"});
  const Image out = resized(image, 50, 1, {.filter = {.kind = FilterKind::box, .radius = Vec2(0.01f)}});
  for (int x = 0; x < 50; ++x) EXPECT_EQ(out.at(x, 0, 0), image.at(x / 10, 0, 0)) << x;
}

TEST(Resize, RefusesWhatIsNoSize) {
  const Image image(4, 4, {"Y"});
  EXPECT_NE(error_of([&] { resized(image, 0, 3); }).find("0x3"), std::string::npos);
  EXPECT_NE(error_of([&] { resized(image, 1 << 20, 1 << 20); }).find("large"), std::string::npos);
  EXPECT_NE(error_of([&] { resized(image, 3, 3, {.filter = {.radius = Vec2(100)}}); }).find("64"), std::string::npos);
  EXPECT_EQ(default_radius(FilterKind::lanczos), 3);
}

}  // namespace
}  // namespace lambert
