#include "lambert/light/light_test_tools.h"
#include "lambert/light/many_lights.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

ShapeLight light_of(Shape shape, const Transform& to_world, bool two_sided = false) {
  return {std::make_shared<const Shape>(std::move(shape)), to_world, false, {{Rgb(1)}, two_sided}};
}
Sphere sphere(float radius) { return {radius, -radius, radius}; }

// rows: PT-27
// A sphere all above the horizon: E = π (r / d)² cos θ.
TEST(ShapeLight, ASphereActsAsItsCrossSection) {
  const ShapeLight light = light_of(sphere(0.5f), Transform::translate({0, 2, 1}) * Transform::scale(Vec3(2)));
  const double d2 = 5, cos = 2 / std::sqrt(d2);
  EXPECT_NEAR(irradiance(light, {}, Vec3(0), {0, 1, 0}), static_cast<double>(pi) / d2 * cos, 3e-3);
}

// The same sphere as an ellipsoid's image: an affine map and its inverse in one, so that area sampling is used.
TEST(ShapeLight, AnEllipsoidIsSampledByArea) {
  const ShapeLight light = light_of(sphere(1), Transform::translate({0, 3, 0}) * Transform::scale({2, 0.5f, 1}));
  // By the polygon formula over a fine silhouette is not exact; so by its solid angle measure, from rays.
  const JitteredSquare square(700);
  double sum = 0;
  for (int i = 0; i < square.count(); ++i) {
    // cosine-distributed directions: E = π · the part of them that hits
    const float r = std::sqrt(square[i].x), phi = 2 * pi * square[i].y;
    const Ray ray{{}, {r * std::cos(phi), std::sqrt(1 - r * r), r * std::sin(phi)}};
    if (std::get<Sphere>(*light.shape).intersect(light.to_world.inverse().ray(ray))) sum += 1;
  }
  const double exact = static_cast<double>(pi) * sum / square.count();
  EXPECT_NEAR(irradiance(light, {}, Vec3(0), {0, 1, 0}, 500), exact, 0.01 * exact);
}

// rows: PT-27
// A coaxial disk: E = π r² / (r² + h²).
TEST(ShapeLight, ADiskAboveAPoint) {
  const Transform facing_down = Transform::translate({0, 2, 0}) * Transform::rotate(degrees(90), {1, 0, 0});
  const ShapeLight light = light_of(Disk{0, 1.5f}, facing_down);
  const double exact = static_cast<double>(pi) * 2.25 / (2.25 + 4);
  EXPECT_NEAR(irradiance(light, {}, Vec3(0), {0, 1, 0}, 400), exact, 5e-3);
  EXPECT_FALSE(light.sample({}, {0, 3, 0}, Vec2(0.4f))) << "behind it";
}

TEST(ShapeLight, ReverseOrientationTurnsTheFront) {
  ShapeLight light = light_of(Disk{0, 1}, Transform::translate({0, 0, 2}));
  EXPECT_FALSE(light.sample({}, Vec3(0), Vec2(0.4f)));
  light.reverse_orientation = true;
  EXPECT_TRUE(light.sample({}, Vec3(0), Vec2(0.4f)));
  EXPECT_NEAR(light.bounds({}).axis.z, -1, 1e-6f);

  ShapeLight ball = light_of(sphere(1), {});
  EXPECT_TRUE(ball.sample({}, {0, 0, 3}, Vec2(0.4f)));
  EXPECT_FALSE(ball.sample({}, {0, 0, 0.3f}, Vec2(0.4f))) << "a sphere that emits outwards is dark inside";
  ball.reverse_orientation = true;
  EXPECT_FALSE(ball.sample({}, {0, 0, 3}, Vec2(0.4f)));
  EXPECT_TRUE(ball.sample({}, {0, 0, 0.3f}, Vec2(0.4f)));
}

// From inside, a sphere of radiance 1 fills every direction: E = π.
TEST(ShapeLight, InsideASphere) {
  const ShapeLight light = light_of(sphere(2), Transform::translate({1, 0, 0}), true);
  EXPECT_NEAR(irradiance(light, {}, {1.5f, 0.7f, 0}, normalize(Vec3(1, 1, 1)), 400), static_cast<double>(pi), 0.02);
}

TEST(ShapeLight, SamplesHaveTheDensityThatItReports) {
  const Transform skewed = Transform::rotate(degrees(30), {1, 1, 0}) * Transform::scale({1, 2, -0.5f});
  TestNumbers r(1);
  for (const ShapeLight& light :
       {light_of(sphere(0.5f), Transform::translate({0, 1, 0})), light_of(sphere(0.5f), skewed),
        light_of(Disk{0.2f, 1}, skewed), light_of(Cylinder{0.5f, -1, 1}, skewed)}) {
    int checked = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 from = 3.0f * r.next_in_cube();
      const auto s = light.sample({}, from, {r.next(), r.next()});
      if (!s || std::abs(dot(s->normal, s->wi)) < 0.05f) continue;
      ++checked;
      const Vec3 hit = from + s->distance * s->wi;
      EXPECT_NEAR(light.pdf_omega(from, hit, s->normal) / s->pdf_omega, 1, 2e-2f);
      EXPECT_LT(dot(s->normal, s->wi), 0) << "the side that is seen";
    }
    EXPECT_GT(checked, 300);
  }
}

// rows: PT-27
TEST(ShapeLight, DirectionsFollowTheDensity) {
  const Transform skewed = Transform::rotate(degrees(30), {1, 1, 0}) * Transform::scale({1, 2, -0.7f});
  // From outside, area sampling has an unbounded density at a silhouette, which no bins can judge; so from inside.
  const std::array lights = {std::pair{light_of(sphere(1), Transform::scale(Vec3(1.5f))), Vec3(0.4f, 0.5f, 2.2f)},
                             std::pair{light_of(sphere(1), skewed, true), Vec3(0.1f, 0.3f, -0.1f)},
                             std::pair{light_of(Disk{0.2f, 1}, skewed, true), Vec3(0.2f, 0.3f, 0.9f)}};
  for (const auto& [light, from] : lights) {
    const auto pdf = [&light = light, from = from](Vec3 w) {
      const Ray ray = light.to_world.inverse().ray({from, w});
      const auto hit = std::visit([&](const auto& s) { return s.intersect(ray); }, *light.shape);
      return hit ? light.pdf_omega(from, from + hit->t * w, normalize(light.to_world.normal(hit->normal))) : 0.0f;
    };
    const auto result = chi_square_of_light(light, from, pdf, lights.size());
    EXPECT_TRUE(result) << result.message;
  }
}

TEST(ShapeLight, ATexturedSphereStaysUnbiased) {
  const TextureSet textures = checkerboard(Rgb(4), Rgb(1));
  const LightContext context{&textures, {}};
  ShapeLight light = light_of(sphere(1), Transform::translate({0.5f, 2, 0.3f}));
  light.emission.radiance.texture = static_cast<TextureId>(textures.size() - 1);
  const JitteredSquare square(700);
  double sum = 0;
  for (int i = 0; i < square.count(); ++i) {
    const float r = std::sqrt(square[i].x), phi = 2 * pi * square[i].y;
    const Ray ray{{}, {r * std::cos(phi), std::sqrt(1 - r * r), r * std::sin(phi)}};
    const auto hit = std::get<Sphere>(*light.shape).intersect(light.to_world.inverse().ray(ray));
    if (!hit) continue;
    TextureCoordinates at;
    at.uv = hit->uv;
    sum += static_cast<double>(luminance(light.emission.radiance.eval(textures, at)));
  }
  const double exact = static_cast<double>(pi) * sum / square.count();
  EXPECT_NEAR(irradiance(light, context, Vec3(0), {0, 1, 0}, 400), exact, 0.01 * exact);
}

TEST(ShapeLight, PowerIsThatOfTheMappedSurface) {
  // π · area: of a disk under a map that doubles one of its axes, and of an ellipsoid (oblate, semi-axes 2, 2, 1).
  EXPECT_NEAR(light_of(Disk{0, 1}, Transform::scale({2, 1, 1})).bounds({}).power, pi * 2 * pi, 1e-3f);
  const double e = std::sqrt(0.75), oblate = 2 * static_cast<double>(pi) * 4 * (1 + (1 - e * e) / e * std::atanh(e));
  EXPECT_NEAR(static_cast<double>(light_of(sphere(1), Transform::scale({2, 2, 1})).bounds({}).power),
              static_cast<double>(pi) * oblate, 0.5);
}

}  // namespace
}  // namespace lambert
