#include "lambert/texture/mip_map.h"

#include "lambert/base/hash.h"
#include "lambert/image/colour.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace lambert {
namespace {

Texels floats(int width, int height, int channels, std::vector<float> values) {
  return {.width = width, .height = height, .channels = channels, .floats = std::move(values), .linear = true};
}
Texels noise(int width, int height, int channels) {
  std::vector<float> values(static_cast<std::size_t>(width * height * channels));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = hash_to_float(hash_values(i));
  return floats(width, height, channels, std::move(values));
}
Vec2 centre(int x, int y, const MipMap& m) {
  return (Vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) /
         Vec2(static_cast<float>(m.width()), static_cast<float>(m.height()));
}
Vec4 mean(const MipMap& m, int level, int width, int height) {
  glm::dvec4 sum(0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) sum += glm::dvec4(m.texel(level, x, y));
  }
  return Vec4(sum / static_cast<double>(width * height));
}
void expect_near(Vec4 a, Vec4 b, float tolerance, const char* what = "") {
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << what << " channel " << c;
}

TEST(MipMap, LevelsHalveDownToOneTexel) {
  // 512 x 512: 10 levels, 4/3 of the memory.
  const MipMap m(Texels{.width = 512, .height = 512, .channels = 3, .bytes = std::vector<std::uint8_t>(786432, 1)}, {});
  EXPECT_EQ(m.level_count(), 10);
  EXPECT_EQ(MipMap(noise(13, 7, 1), {}).level_count(), 4) << "13x7 6x3 3x1 1x1";
  EXPECT_EQ(MipMap(noise(1, 9, 1), {}).level_count(), 4);
  EXPECT_EQ(MipMap(noise(1, 1, 1), {}).level_count(), 1);
  EXPECT_EQ(MipMap(noise(13, 7, 1), {.filter = TextureFilter::bilinear}).level_count(), 1);
}

TEST(MipMap, TwoByTwoTexelsAreAveraged) {
  const MipMap m(noise(8, 4, 3), {});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) {
      const Vec4 average = 0.25f * (m.texel(0, 2 * x, 2 * y) + m.texel(0, 2 * x + 1, 2 * y) +
                                    m.texel(0, 2 * x, 2 * y + 1) + m.texel(0, 2 * x + 1, 2 * y + 1));
      expect_near(m.texel(1, x, y), average, 1e-6f);
    }
  }
}

TEST(MipMap, OddSizesKeepTheMean) {
  for (const auto& [width, height] : {std::pair{13, 7}, {5, 5}, {1, 9}, {31, 2}, {3, 3}}) {
    for (const int channels : {1, 2, 3, 4}) {
      const MipMap m(noise(width, height, channels), {});
      const Vec4 whole = mean(m, 0, width, height);
      int w = width, h = height;
      for (int level = 1; level < m.level_count(); ++level) {
        w = std::max(1, w / 2), h = std::max(1, h / 2);
        expect_near(mean(m, level, w, h), whole, 1e-5f);
      }
    }
  }
}

TEST(MipMap, EightBitsKeepTheMeanUpToTheirCodes) {
  Texels texels{.width = 9, .height = 6, .channels = 4};
  for (std::uint64_t i = 0; i < 9 * 6 * 4; ++i) texels.bytes.push_back(static_cast<std::uint8_t>(hash_values(i)));
  for (const bool srgb : {false, true}) {
    const MipMap m(texels, {.srgb = srgb});
    // Half a code per level; a code of sRGB is worth at most 2.3 codes of light.
    expect_near(m.texel(m.level_count() - 1, 0, 0), mean(m, 0, 9, 6), (srgb ? 3.0f : 1.5f) / 255);
  }
}

// Black and white average to half the light, which sRGB stores as 188; alpha is never encoded.
TEST(MipMap, SrgbIsAveragedInLinearLight) {
  const Texels texels{.width = 2, .height = 1, .channels = 4, .bytes = {0, 0, 0, 0, 255, 255, 255, 255}};
  const MipMap m(texels, {.wrap_u = EdgeMode::clamp, .wrap_v = EdgeMode::clamp, .srgb = true});
  expect_near(m.texel(1, 0, 0), {srgb_decode8(188), srgb_decode8(188), srgb_decode8(188), 128 / 255.0f}, 1e-6f);
  expect_near(m.lookup({0.5f, 0.5f}), Vec4(0.5f), 1e-5f, "bilinear");
  expect_near(MipMap(texels, {}).texel(1, 0, 0), Vec4(128 / 255.0f), 1e-6f, "not decoded unless asked");
}

TEST(MipMap, SixteenBitsAreDecodedAndLinearFloatsAreNot) {
  Texels t = floats(1, 1, 2, {0.5f, 0.5f});
  expect_near(MipMap(t, {.srgb = true}).texel(0, 0, 0), Vec4(0.5f), 0);
  t.linear = false;
  const float linear = srgb_decode(0.5f);
  expect_near(MipMap(t, {.srgb = true}).texel(0, 0, 0), {linear, linear, linear, 0.5f}, 1e-7f);
}

TEST(MipMap, ChannelsAreSpreadToRgba) {
  expect_near(MipMap(floats(1, 1, 1, {0.25f}), {}).lookup(Vec2(0)), {0.25f, 0.25f, 0.25f, 1}, 0);
  expect_near(MipMap(floats(1, 1, 2, {0.25f, 0.5f}), {}).lookup(Vec2(0)), {0.25f, 0.25f, 0.25f, 0.5f}, 0);
  expect_near(MipMap(floats(1, 1, 3, {0.25f, 0.5f, 2}), {}).lookup(Vec2(0)), {0.25f, 0.5f, 2, 1}, 0);
  expect_near(MipMap(floats(1, 1, 4, {0.25f, 0.5f, 2, 0}), {}).lookup(Vec2(0)), {0.25f, 0.5f, 2, 0}, 0);
}

TEST(MipMap, TexelCentresAreExact) {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    const MipMap m(noise(8, 4, 3), {.filter = filter});
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 8; ++x) EXPECT_EQ(m.lookup(centre(x, y, m)), m.texel(0, x, y)) << x << " " << y;
    }
  }
}

// rows: AA-22
// Four texels of a level, weighted by the fractions; two levels, blended by the fraction of log2 of the width.
TEST(MipMap, BilinearAndTrilinear) {
  const MipMap m(floats(2, 2, 1, {10, 20, 30, 40}), {.wrap_u = EdgeMode::clamp, .wrap_v = EdgeMode::clamp});
  const Vec2 uv(0.25f + 0.25f * 0.5f, 0.25f + 0.5f * 0.5f);  // fractions .25 and .5
  EXPECT_NEAR(m.lookup(uv).x, 22.5f, 1e-5f);
  const float width = std::exp2(0.3f) / 2;  // 2^.3 texels
  EXPECT_NEAR(m.lookup(uv, width).x, 22.5f + 0.3f * (25 - 22.5f), 1e-4f);
  EXPECT_NEAR(m.lookup(uv, 10).x, 25, 1e-5f) << "the top";

  // Five texels wide: log2 5 = 2.321928, between levels 2 and 3.
  const MipMap wide(noise(16, 16, 1), {.wrap_u = EdgeMode::clamp, .wrap_v = EdgeMode::clamp});
  const Vec4 fine = wide.lookup(Vec2(0.4f), 4.0f / 16), coarse = wide.lookup(Vec2(0.4f), 8.0f / 16);
  expect_near(wide.lookup(Vec2(0.4f), 5.0f / 16), fine + 0.321928f * (coarse - fine), 1e-6f);
}

TEST(MipMap, LookupsAreContinuous) {
  const MipMap m(noise(13, 7, 3), {.wrap_u = EdgeMode::repeat, .wrap_v = EdgeMode::mirror});
  for (float width = 0.02f; width < 2; width *= 1.003f) {
    expect_near(m.lookup({0.3f, 0.6f}, width), m.lookup({0.3f, 0.6f}, width * 1.003f), 8e-3f, "in width");
  }
  for (float u = -1.5f; u < 1.5f; u += 1e-3f) {
    for (const float width : {0.0f, 0.2f}) {
      expect_near(m.lookup({u, 0.6f}, width), m.lookup({u + 1e-3f, 0.6f}, width), 1.5e-2f, "in u");
      expect_near(m.lookup({0.3f, u}, width), m.lookup({0.3f, u + 1e-3f}, width), 1.5e-2f, "in v");
    }
  }
}

// rows: AA-24
TEST(MipMap, EdgeModes) {
  const std::array<int, 6> index = {-1, 0, 3, 4, 5, 8};
  const std::pair<EdgeMode, std::array<float, 6>> modes[] = {{EdgeMode::clamp, {0, 0, 3, 3, 3, 3}},
                                                             {EdgeMode::repeat, {3, 0, 3, 0, 1, 0}},
                                                             {EdgeMode::mirror, {0, 0, 3, 3, 2, 0}},
                                                             {EdgeMode::black, {0, 0, 3, 0, 0, 0}}};
  for (const auto& [mode, expected] : modes) {
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
      const MipMap u(floats(4, 1, 1, {0, 1, 2, 3}), {.wrap_u = mode, .filter = filter});
      const MipMap v(floats(1, 4, 1, {0, 1, 2, 3}), {.wrap_v = mode, .filter = filter});
      for (std::size_t i = 0; i < index.size(); ++i) {
        EXPECT_EQ(u.lookup(centre(index[i], 0, u)).x, expected[i]) << static_cast<int>(mode) << " " << index[i];
        EXPECT_EQ(v.lookup(centre(0, index[i], v)).x, expected[i]) << static_cast<int>(mode) << " " << index[i];
      }
    }
  }
}

TEST(MipMap, WildCoordinatesGiveATexel) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    const MipMap m(noise(5, 3, 3), {.filter = filter});
    const Vec4 origin = m.lookup(Vec2(0));
    EXPECT_EQ(m.lookup({inf, 0}), origin);
    EXPECT_EQ(m.lookup({0, nan}), origin);
    EXPECT_EQ(m.lookup(Vec2(0), nan), origin);
    for (const Vec2 uv : {Vec2(1e30f), Vec2(-1e30f, 1e9f)}) {
      const Vec4 v = m.lookup(uv, inf);
      EXPECT_TRUE(v.x >= 0 && v.x <= 1) << v.x;
    }
  }
}

}  // namespace
}  // namespace lambert
