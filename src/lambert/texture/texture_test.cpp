#include "lambert/texture/texture.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambert {
namespace {

/// 4x1 texels 0, 1, 2, 3 in red, with alpha 1/2.
std::shared_ptr<const MipMap> ramp(TextureFilter filter = TextureFilter::nearest) {
  Texels t{.width = 4, .height = 1, .channels = 4, .linear = true};
  for (int i = 0; i < 4; ++i) t.floats.insert(t.floats.end(), {static_cast<float>(i), 0.25f, 0, 0.5f});
  return std::make_shared<const MipMap>(std::move(t), MipMap::Settings{.filter = filter});
}
TextureCoordinates at(float u, float v = 0.5f, float footprint = 0) { return {.uv = {u, v}, .footprint = footprint}; }
TextureCoordinates at(Vec3 position) { return {.position = position}; }

struct Checks {
  TextureSet set;
  TextureId id;
  explicit Checks(CheckerboardTexture c) {
    c.even = set.add(ConstantTexture{Texel(0, 0, 0, 1)});
    c.odd = set.add(ConstantTexture{Texel(1, 1, 1, 0)});
    id = set.add(c);
  }
  float operator()(const TextureCoordinates& where) const { return set.eval(id, where).x; }
};

TEST(Texture, ConstantIsTheSameEverywhere) {
  TextureSet set;
  const TextureId id = set.add(ConstantTexture{Texel(1, 2, 3, 0.5f)});
  EXPECT_EQ(set.eval(id, at(0)), Texel(1, 2, 3, 0.5f));
  EXPECT_EQ(set.eval(id, at(-7, 3, 1)), Texel(1, 2, 3, 0.5f));
}

TEST(Texture, ImagesAreLookedUpThroughTheTransform) {
  TextureSet set;
  // u' = 2 u + 1/4 on the second set of coordinates.
  const UvTransform uv{.matrix = {2, 0, 0, 1, 0.25f, 0}, .set = 1};
  const TextureId id = set.add(ImageTexture{.image = ramp(), .uv = uv});
  for (const auto& [u, red] : {std::pair{0.05f, 1.0f}, {0.2f, 2.0f}, {0.3f, 3.0f}, {0.45f, 0.0f}, {-0.1f, 0.0f}}) {
    EXPECT_EQ(set.eval(id, {.uv = {0.9f, 0}, .uv1 = {u, 0.5f}}), Texel(red, 0.25f, 0, 0.5f)) << u;
  }
}

TEST(Texture, ATurnedTransformSwapsAxesAndKeepsTheScale) {
  const UvTransform quarter{.matrix = {0, 3, -3, 0, 0, 0}};
  EXPECT_EQ(quarter.apply(at(1, 0)), Vec2(0, 3));
  EXPECT_EQ(quarter.apply(at(0, 1)), Vec2(-3, 0));
  EXPECT_FLOAT_EQ(quarter.scale(), 3);
}

TEST(Texture, TheTransformWidensTheFootprint) {
  TextureSet set;
  const auto image = ramp(TextureFilter::trilinear);
  const TextureId id = set.add(ImageTexture{.image = image, .uv = {.matrix = {4, 0, 0, 4, 0, 0}}});
  EXPECT_EQ(set.eval(id, at(0.02f, 0.1f, 0.1f)), image->lookup({0.08f, 0.4f}, 0.4f));
  EXPECT_NE(set.eval(id, at(0.02f, 0.1f, 0.1f)), image->lookup({0.08f, 0.4f}, 0.1f));
}

TEST(Texture, ImagesAreInvertedThenScaled) {
  TextureSet set;
  const TextureId id = set.add(ImageTexture{.image = ramp(), .scale = {2, 2, 2, 0.5f}, .invert = true});
  EXPECT_EQ(set.eval(id, at(0.875f)), Texel(-4, 1.5f, 2, 0.25f)) << "alpha is not inverted";
}

TEST(Texture, ScaleMultiplies) {
  TextureSet set;
  const TextureId image = set.add(ImageTexture{.image = ramp()});
  const TextureId factor = set.add(ConstantTexture{Texel(2, 4, 1, 0.5f)});
  EXPECT_EQ(set.eval(set.add(ScaleTexture{image, factor}), at(0.6f)), Texel(4, 1, 0, 0.25f));
}

TEST(Texture, MixBlendsByTheAmountsRed) {
  TextureSet set;
  const TextureId a = set.add(ConstantTexture{Texel(0, 1, 2, 1)}), b = set.add(ConstantTexture{Texel(4, 1, 0, 0)});
  for (const auto& [amount, expected] : {std::pair{0.0f, Texel(0, 1, 2, 1)},
                                         {0.25f, Texel(1, 1, 1.5f, 0.75f)},
                                         {1.0f, Texel(4, 1, 0, 0)},
                                         {-2.0f, Texel(0, 1, 2, 1)},
                                         {3.0f, Texel(4, 1, 0, 0)}}) {
    const TextureId t = set.add(ConstantTexture{Texel(amount, 0.5f, 0.5f, 0.5f)});
    EXPECT_EQ(set.eval(set.add(MixTexture{a, b, t}), at(0)), expected) << amount;
  }
}

TEST(Texture, CheckersAlternateAlsoBelowZero) {
  const Checks checks({});
  for (int y = -4; y < 4; ++y) {
    for (int x = -4; x < 4; ++x) {
      const float expected = (x + y) % 2 == 0 ? 0 : 1;
      for (const float within : {0.01f, 0.5f, 0.99f}) {
        EXPECT_EQ(checks(at(static_cast<float>(x) + within, static_cast<float>(y) + within)), expected)
            << x << " " << y;
      }
    }
  }
  EXPECT_EQ(checks.set.eval(checks.id, at(1.5f, 0.5f)), Texel(1, 1, 1, 0)) << "with its alpha";
  EXPECT_EQ(Checks({.uv = {.matrix = {8, 0, 0, 8, 0, 0}}})(at(0.2f, 0.3f)), 1) << "scaled to squares 1 and 2";
}

// rows: MP-40
// A procedure over space: any point has a value, also inside of what was cut.
TEST(Texture, SolidCheckersFillSpace) {
  const Checks checks({.dimensions = 3});
  for (int z = -2; z < 2; ++z) {
    for (int y = -2; y < 2; ++y) {
      for (int x = -2; x < 2; ++x) {
        const Vec3 corner(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        const float expected = (x + y + z) % 2 == 0 ? 0 : 1;
        for (const Vec3 within : {Vec3(0.5f), Vec3(0.1f, 0.9f, 0.4f), Vec3(0.99f, 0.02f, 0.7f)}) {
          EXPECT_EQ(checks(at(corner + within)), expected) << x << " " << y << " " << z;
        }
      }
    }
  }
}

// The mean over the footprint's square, by brute force.
TEST(Texture, CheckersAreFilteredByArea) {
  const Checks checks({});
  for (const float footprint : {0.01f, 0.3f, 1.0f, 1.7f, 5.3f}) {
    for (const Vec2 uv : {Vec2(0.3f, 0.4f), Vec2(-1.95f, 0.6f), Vec2(2.02f, -3.01f)}) {
      constexpr int n = 200;
      double sum = 0;
      for (int i = 0; i < n * n; ++i) {
        const Vec2 offset((static_cast<float>(i % n) + 0.5f) / n - 0.5f, (static_cast<float>(i / n) + 0.5f) / n - 0.5f);
        const Vec2 p = uv + footprint * offset;
        sum += static_cast<double>(checks(at(p.x, p.y)));
      }
      EXPECT_NEAR(checks(at(uv.x, uv.y, footprint)), sum / (n * n), 1.5e-2) << footprint << " " << uv.x;
    }
  }
  EXPECT_NEAR(checks(at(0.3f, 0.4f, 1000)), 0.5f, 1e-3f) << "grey from afar";
}

TEST(Texture, CheckersStaySharpFarFromTheOrigin) {
  const Checks checks({});
  for (const float far : {1000.0f, -30000.0f}) {
    EXPECT_NEAR(checks(at(far + 0.5f, 0.5f, 2e-4f)), 0, 1e-3f) << far;
    EXPECT_NEAR(checks(at(far + 1.5f, 0.5f, 2e-4f)), 1, 1e-3f) << far;
  }
}

TEST(Texture, WildCoordinatesGiveFiniteValues) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const int dimensions : {2, 3}) {
    const Checks checks({.dimensions = dimensions});
    for (const float v : {inf, -inf, nan, 1e30f}) {
      const float value = checks({.uv = Vec2(v), .footprint = v, .position = Vec3(v)});
      EXPECT_TRUE(value >= 0 && value <= 1) << v << ": " << value;
    }
  }
}

TEST(Texture, IdsMustExist) {
  TextureSet set;
  const TextureId a = set.add(ConstantTexture{});
  EXPECT_EQ(error_of([&] {
              set.add(ScaleTexture{a, 1});
            }),
            "texture 1 refers to texture 1, which does not come before it");
  EXPECT_NE(error_of([&] { set.add(MixTexture{a, a, no_texture}); }), "");
  EXPECT_NE(error_of([&] { set.add(CheckerboardTexture{.even = 7, .odd = a}); }), "");
  EXPECT_EQ(set.size(), 1u);
}

TEST(Texture, ParametersMultiplyTheirTexture) {
  TextureSet set;
  const TextureId id = set.add(ConstantTexture{Texel(0.5f, 0.25f, 1, 0.125f)});
  EXPECT_EQ((RgbParameter{Rgb(2, 4, 1), id}.eval(set, at(0))), Rgb(1));
  EXPECT_EQ((RgbParameter{Rgb(2, 4, 1)}.eval(set, at(0))), Rgb(2, 4, 1));
  EXPECT_EQ((FloatParameter{4, id, 1}.eval(set, at(0))), 1);
  EXPECT_EQ((FloatParameter{4, id, 3}.eval(set, at(0))), 0.5f);
  EXPECT_EQ((FloatParameter{4}.eval(set, at(0))), 4);
}

}  // namespace
}  // namespace lambert
