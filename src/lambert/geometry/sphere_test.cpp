#include "lambert/geometry/shape_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

using Long = long double;

/// The roots of |o + t d|² = r² by the plain formula, in extended precision.
std::vector<double> roots(const Ray& ray, float radius) {
  Long a = 0, b = 0, c = -static_cast<Long>(radius) * radius;
  for (int i = 0; i < 3; ++i) {
    const Long o = ray.origin[i], d = ray.direction[i];
    a += d * d, b += o * d, c += o * o;
  }
  const Long discriminant = b * b - a * c;
  if (discriminant < 0) return {};
  const Long root = std::sqrt(discriminant);
  return {static_cast<double>((-b - root) / a), static_cast<double>((-b + root) / a)};
}

std::vector<float> distances(const Sphere& s, const Ray& ray) {
  std::vector<float> t;
  for (const ShapeHit& h : all_hits(s, ray)) t.push_back(h.t);
  return t;
}

// rows: PG-69
TEST(Sphere, WorkedExample) {  // V-PG-49, its centre (0, 0, 1) moved to the origin
  constexpr float everywhere = -std::numeric_limits<float>::infinity();
  const Sphere s{.radius = 2, .z_min = -2, .z_max = 2};
  const Vec3 z(0, 0, 1), y(0, 1, 0);
  const auto line = [&](Vec3 origin, Vec3 d) { return Ray{.origin = origin - z, .direction = d, .t_min = everywhere}; };
  EXPECT_EQ(distances(s, line({0, 0, -5}, z)), (std::vector<float>{4, 8}));
  EXPECT_EQ(distances(s, line({2, 0, -5}, z)), (std::vector<float>{6}));
  EXPECT_EQ(distances(s, line({3, 0, -5}, z)), (std::vector<float>{}));
  EXPECT_EQ(distances(s, line({0, 0, 1}, y)), (std::vector<float>{-2, 2}));
  EXPECT_EQ(s.intersect({.origin = {0, 0, 0}, .direction = y})->t, 2);
  // E-PG-24: with a direction of length 2 everything is met in half the time.
  EXPECT_EQ(distances(s, line({0, 0, -5}, 2.0f * z)), (std::vector<float>{2, 4}));
}

// rows: PG-69
TEST(Sphere, AgreesWithTheQuadraticInExtendedPrecision) {
  Random random(1);
  for (const float distance : {0.5f, 3.0f, 1e2f, 1e4f})
    for (const float radius : {1e-3f, 1.0f, 1e3f}) {
      const Sphere s{.radius = radius, .z_min = -radius, .z_max = radius};
      for (int i = 0; i < 1000; ++i) {
        const Vec3 origin = distance * radius * random.direction();
        const Ray ray{.origin = origin, .direction = 1.2f * radius * random.direction() - origin};
        std::vector<double> expected;
        for (const double t : roots(ray, radius))
          if (t >= 0) expected.push_back(t);
        const std::vector<float> found = distances(s, ray);
        if (found.size() == 1 && expected.size() == 2 &&
            static_cast<float>(expected[0]) == static_cast<float>(expected[1]))
          continue;
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k)
          EXPECT_NEAR(static_cast<double>(found[k]), expected[k], 1e-7 * (1 + std::abs(expected[k])));
      }
    }
}

TEST(Sphere, TangentRaysTouchWhereTheyPass) {
  const Sphere s;
  for (const float distance : {2.0f, 1e4f}) {
    const Ray ray{.origin = {-distance, 1, 0}, .direction = {1, 0, 0}};
    const auto hit = s.intersect(ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, distance);
    EXPECT_LT(length(hit->position - Vec3(0, 1, 0)), 1e-6f);
    Ray beyond = ray;
    beyond.origin.y = std::nextafter(1.0f, 2.0f);
    EXPECT_FALSE(s.intersect(beyond));
  }
}

TEST(Sphere, UvRunsAsInPbrt) {
  const Sphere s;
  const auto uv = [&](Vec3 p) { return s.intersect({.origin = 2.0f * p, .direction = -p})->uv; };
  EXPECT_LT(length(uv({1, 0, 0}) - Vec2(0, 0.5f)), 1e-6f);
  EXPECT_LT(length(uv({0, 1, 0}) - Vec2(0.25f, 0.5f)), 1e-6f);
  EXPECT_LT(length(uv({-1, 0, 0}) - Vec2(0.5f, 0.5f)), 1e-6f);
  EXPECT_NEAR(uv({0, 0, -1}).y, 0, 1e-6);
  EXPECT_NEAR(uv({0, 0, 1}).y, 1, 1e-6);
  EXPECT_GT(length(s.intersect({.origin = {0, 0, 2}, .direction = {0, 0, -1}})->dpdu), 0);
}

TEST(Sphere, ClippedPartIsOpen) {
  const Sphere bowl{.radius = 1, .z_min = -1, .z_max = 0};
  const auto hit = bowl.intersect({.origin = {0, 0, 3}, .direction = {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 4);
  EXPECT_FLOAT_EQ(hit->normal.z, -1);
  EXPECT_FLOAT_EQ(bowl.area(), 2 * pi);
}

}  // namespace
}  // namespace lambert
