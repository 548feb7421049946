#include "lambert/light/light_test_tools.h"
#include "lambert/light/many_lights.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

const std::array<Vec2, 3> uv = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};

/// Facing down, centred above the origin.
QuadLight lamp(float width, float depth, float height, float shear = 0) {
  const Vec3 edge_u(width, 0, 0), edge_v(shear, 0, depth);
  return {Vec3(0, height, 0) - 0.5f * (edge_u + edge_v), edge_u, edge_v, uv, {{Rgb(1)}}};
}
std::array<Vec3, 4> corners(const QuadLight& q) {
  return {q.corner(), q.corner() + q.edge_u(), q.corner() + q.edge_u() + q.edge_v(), q.corner() + q.edge_v()};
}

// rows: PT-27 PT-28
// E-PT-10: a unit square lamp of radiance 1 at height 1 above a facing point.
TEST(QuadLight, TheUnitSquareLamp) { EXPECT_NEAR(irradiance(lamp(1, 1, 1), {}, Vec3(0), {0, 1, 0}), 0.752275, 1e-3); }

// rows: PT-27
TEST(QuadLight, IrradianceIsLamberts) {
  for (const QuadLight& light :
       {lamp(1, 1, 1), lamp(4, 3, 1), lamp(0.05f, 0.02f, 1), lamp(8, 0.01f, 1), lamp(40, 40, 1)}) {
    for (const Vec3 p : {Vec3(0), Vec3(0.3f, 0, 0.2f), Vec3(-2, 0, 1), Vec3(0.2f, 0.97f, 0.1f), Vec3(3, 0.9f, 0)}) {
      const double exact = lambert_polygon_irradiance(p, {0, 1, 0}, corners(light));
      EXPECT_NEAR(irradiance(light, {}, p, {0, 1, 0}), exact, 4e-3 * exact + 1e-6)
          << length(light.edge_u()) << " from " << p.x << " " << p.y << " " << p.z;
    }
  }
}

// rows: PT-27
TEST(QuadLight, AParallelogramIsSampledByArea) {
  const QuadLight light = lamp(1, 1, 1, 0.7f);
  for (const Vec3 p : {Vec3(0), Vec3(0.3f, 0.4f, 0.2f), Vec3(-2, 0, 1)}) {
    const double exact = lambert_polygon_irradiance(p, {0, 1, 0}, corners(light));
    EXPECT_NEAR(irradiance(light, {}, p, {0, 1, 0}), exact, 4e-3 * exact);
  }
}

TEST(QuadLight, SamplesHaveTheDensityThatItReports) {
  TestNumbers r(1);
  for (const QuadLight& light : {lamp(1, 1, 1), lamp(4, 3, 1), lamp(0.05f, 0.02f, 1), lamp(1, 1, 1, 0.7f)}) {
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
TEST(QuadLight, DirectionsFollowTheDensity) {
  const std::array lights = {lamp(4, 3, 1), lamp(1, 1, 0.5f), lamp(3, 3, 1, 1.5f)};
  for (const QuadLight& light : lights) {
    const Vec3 from(0.3f, 0, -0.4f), normal(0, -1, 0);
    const auto pdf = [&](Vec3 w) {
      const auto hit = meet_plane(from, w, light.corner(), normal);
      if (!hit) return 0.0f;
      const Vec3 d = *hit - light.corner();
      const float t = d.z / light.edge_v().z, s = (d.x - t * light.edge_v().x) / light.edge_u().x;
      return s > 0 && s < 1 && t > 0 && t < 1 ? light.pdf_omega(from, *hit) : 0.0f;
    };
    const auto result = chi_square_of_light(light, from, pdf, lights.size());
    EXPECT_TRUE(result) << result.message;
  }
}

// The rectangle's solid angle is cut into equal parts: what a direction hits is uniform in solid angle.
TEST(QuadLight, ARectangleIsSampledUniformlyBySolidAngle) {
  const QuadLight light = lamp(4, 3, 1);
  const auto first = light.sample({}, {0.5f, 0, 0.2f}, {0.1f, 0.9f});
  for (const Vec2 u : {Vec2(0.5f), Vec2(0.9f, 0.1f), Vec2(0, 0), Vec2(one_minus_epsilon)}) {
    EXPECT_FLOAT_EQ(light.sample({}, {0.5f, 0, 0.2f}, u)->pdf_omega, first->pdf_omega);
  }
  EXPECT_NEAR(1 / lamp(900, 900, 1).sample({}, Vec3(0), Vec2(0.5f))->pdf_omega, 2 * pi, 0.02f) << "nearly a hemisphere";
}

TEST(QuadLight, EmitsOnItsFrontUnlessTwoSided) {
  EXPECT_FALSE(lamp(1, 1, 1).sample({}, {0, 2, 0}, Vec2(0.3f)));
  EXPECT_FALSE(lamp(1, 1, 1).sample({}, {0, 1, 0}, Vec2(0.3f))) << "in its plane";
  const QuadLight one = lamp(1, 1, 1);
  const QuadLight both(one.corner(), one.edge_u(), one.edge_v(), uv, {{Rgb(1)}, true});
  EXPECT_NEAR(irradiance(both, {}, {0, 2, 0}, {0, -1, 0}), 0.752275, 1e-3);
  EXPECT_TRUE(both.bounds({}).two_sided);
  EXPECT_FLOAT_EQ(both.bounds({}).power, 2 * pi);
}

TEST(QuadLight, ATexturedOneStaysUnbiased) {
  const TextureSet textures = checkerboard(Rgb(4), Rgb(1));
  const LightContext context{&textures, {}};
  const Emission emission{{Rgb(1), static_cast<TextureId>(textures.size() - 1)}};
  const QuadLight light({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, uv, emission);
  const Vec3 p(0.3f, 0, 0.1f);

  // Each check is a polygon of its own.
  double exact = 0;
  for (int i = 0; i < 4; ++i) {
    const Vec3 a(-1 + i % 2, 1, -1 + i / 2);
    const std::array<Vec3, 4> check = {a, a + Vec3(1, 0, 0), a + Vec3(1, 0, 1), a + Vec3(0, 0, 1)};
    exact += (i == 0 || i == 3 ? 4 : 1) * lambert_polygon_irradiance(p, {0, 1, 0}, check);
  }
  EXPECT_NEAR(irradiance(light, context, p, {0, 1, 0}, 400), exact, 5e-3 * exact);
  EXPECT_NEAR(light.bounds(context).intensity, 4 * 2.5f, 0.1f);
}

}  // namespace
}  // namespace lambert
