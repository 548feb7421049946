#include "lambert/base/ray.h"

#include "lambert/base/hash.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

float number(int i, int k) { return 2 * hash_to_float(hash_values(i, k)) - 1; }
Vec3 vector(int i, int k) { return {number(i, k), number(i, k + 1), number(i, k + 2)}; }

struct Facet {
  Vec3 a, b, c;
  Vec3d normal() const { return glm::normalize(glm::cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a))); }
  double height(Vec3 p) const { return glm::dot(Vec3d(p) - Vec3d(a), normal()); }
};

/// A triangle of about the size of its distance from the origin.
Facet facet(int i, float scale) { return {scale * vector(i, 0), scale * vector(i, 3), scale * vector(i, 6)}; }

/// Points of triangles, with the rounding of their interpolation, end up on the side they were moved to: so a ray from
/// there cannot meet its triangle again.
TEST(OffsetRayOrigin, LeavesThePlaneToTheRightSide) {
  for (const float scale : {1e-3f, 1e-2f, 1.0f, 30.0f, 1e4f})
    for (int i = 0; i < 5000; ++i) {
      const Facet f = facet(i, scale);
      const float u = hash_to_float(hash_values(i, 20)), v = (1 - u) * hash_to_float(hash_values(i, 21));
      const Vec3 p = f.a + u * (f.b - f.a) + v * (f.c - f.a), n(f.normal());
      ASSERT_GT(f.height(offset_ray_origin(p, n)), 0) << "scale " << scale << ", triangle " << i;
      ASSERT_LT(f.height(offset_ray_origin(p, -n)), 0) << "scale " << scale << ", triangle " << i;
    }
}

TEST(OffsetRayOrigin, StepsAreSmall) {
  for (const float scale : {1e-2f, 1.0f, 30.0f, 1e4f})
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = scale * vector(i, 0), n = normalize(vector(i, 3));
      EXPECT_LT(length(offset_ray_origin(p, n) - p), 3e-5f * std::max(1.0f, 2 * length(p)));
    }
}

TEST(OffsetRayOrigin, WorksOnBothSidesOfZero) {
  for (const float x : {0.0f, 1e-30f, 0.03f, 0.04f, 1.0f, 1e4f})
    for (const float sign : {-1.0f, 1.0f}) {
      EXPECT_GT(offset_ray_origin({sign * x, 0, 0}, {1, 0, 0}).x, sign * x);
      EXPECT_LT(offset_ray_origin({sign * x, 0, 0}, {-1, 0, 0}).x, sign * x);
      EXPECT_EQ(offset_ray_origin({sign * x, 0, 0}, {0, 1, 0}).x, sign * x);
    }
}

TEST(Ray, PointAtT) { EXPECT_EQ((Ray{.origin = {1, 0, 0}, .direction = {0, 2, 0}}.at(3)), Vec3(1, 6, 0)); }

TEST(RayCone, WidensWithDistance) { EXPECT_EQ((RayCone{.width = 1, .spread = 0.5f}.at(4)), 3); }

}  // namespace
}  // namespace lambert
