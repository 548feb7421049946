#include "lambert/light/light_test_tools.h"
#include "lambert/light/many_lights.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

const std::array<Vec2, 3> uv = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};

/// Facing down.
TriangleLight lamp(float size, float height) {
  return {{Vec3(0, height, 0), Vec3(size, height, 0), Vec3(0, height, size)}, uv, {{Rgb(1)}}};
}

// rows: PT-27
TEST(TriangleLight, IrradianceIsLamberts) {
  // A large one is sampled by solid angle, a small one by area.
  for (const float size : {3.0f, 0.5f, 0.02f}) {
    const TriangleLight light = lamp(size, 1);
    for (const Vec3 p : {Vec3(0.1f, 0, 0.2f), Vec3(-2, 0, 1), Vec3(0.2f, 0.9f, 0.2f)}) {
      const double exact = lambert_polygon_irradiance(p, {0, 1, 0}, light.p);
      EXPECT_NEAR(irradiance(light, {}, p, {0, 1, 0}), exact, 3e-3 * exact) << size;
    }
  }
}

TEST(TriangleLight, SamplesHaveTheDensityThatItReports) {
  TestNumbers r(1);
  for (const float size : {3.0f, 0.5f, 0.02f}) {
    const TriangleLight light = lamp(size, 1);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 from = r.next_in_cube();
      const auto s = light.sample({}, from, {r.next(), r.next()});
      if (!s) continue;
      const Vec3 hit = from + s->distance * s->wi;
      EXPECT_NEAR(hit.y, 1, 1e-4f);
      EXPECT_NEAR(light.pdf_omega(from, hit) / s->pdf_omega, 1, 2e-2f);
    }
  }
}

// rows: PT-27
TEST(TriangleLight, DirectionsFollowTheDensity) {
  const TriangleLight light{{Vec3(-3, 1, -2), Vec3(4, 1, -1), Vec3(-1, 1, 5)}, uv, {{Rgb(1)}}};
  const Vec3 normal(0, -1, 0);
  const std::array places = {Vec3(0), Vec3(-1, 0.6f, 0.5f), Vec3(1, 0.2f, 1)};
  for (const Vec3 from : places) {
    const auto pdf = [&](Vec3 w) {
      const auto hit = meet_plane(from, w, light.p[0], normal);
      if (!hit) return 0.0f;
      const auto left_of = [&](Vec3 a, Vec3 b) { return dot(cross(b - a, *hit - a), normal) > 0; };
      const bool inside =
          left_of(light.p[0], light.p[1]) && left_of(light.p[1], light.p[2]) && left_of(light.p[2], light.p[0]);
      return inside ? light.pdf_omega(from, *hit) : 0.0f;
    };
    const auto result = chi_square_of_light(light, from, pdf, places.size());
    EXPECT_TRUE(result) << result.message;
  }
}

TEST(TriangleLight, EmitsOnItsFrontUnlessTwoSided) {
  TriangleLight light = lamp(1, 1);
  EXPECT_FALSE(light.sample({}, {0.1f, 2, 0.1f}, Vec2(0.3f)));
  light.emission.two_sided = true;
  EXPECT_NEAR(irradiance(light, {}, {0.1f, 2, 0.1f}, {0, -1, 0}),
              lambert_polygon_irradiance({0.1f, 2, 0.1f}, {0, -1, 0}, light.p), 3e-3);
}

TEST(TriangleLight, ATexturedOneStaysUnbiased) {
  const TextureSet textures = checkerboard(Rgb(4), Rgb(1));
  const LightContext context{&textures, {}};
  TriangleLight light = lamp(2, 1);
  light.emission.radiance.texture = static_cast<TextureId>(textures.size() - 1);
  const Vec3 p(0.3f, 0, 0.1f), n(0, 1, 0);

  // By area: E = ∫ L cos² / r² dA, over cells of the square that holds the triangle.
  constexpr int side = 800;
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const Vec2 t = (Vec2(i % side, i / side) + 0.5f) / static_cast<float>(side);
    if (t.x + t.y > 1) continue;
    TextureCoordinates at;
    at.uv = t;
    const Vec3 d = Vec3(2 * t.x, 1, 2 * t.y) - p;
    sum += static_cast<double>(luminance(light.emission.radiance.eval(textures, at)) / sqr(dot(d, d)));
  }
  sum *= 4.0 / (side * side);
  EXPECT_NEAR(irradiance(light, context, p, n, 400), sum, 5e-3 * sum);

  const LightBounds b = light.bounds(context);
  // One half of the square: three of the four checks, two of them only by half.
  EXPECT_NEAR(b.intensity, 2 * 2.5f, 0.6f);
}

TEST(TriangleLight, BoundsFaceItsWay) {
  const LightBounds b = lamp(2, 1).bounds({});
  EXPECT_NEAR(b.axis.y, -1, 1e-6f);
  EXPECT_FLOAT_EQ(b.power, 2 * pi);
  EXPECT_FLOAT_EQ(b.intensity, 2);
  EXPECT_EQ(b.box.max, Vec3(2, 1, 2));
}

}  // namespace
}  // namespace lambert
