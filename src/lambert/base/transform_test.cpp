#include "lambert/base/transform.h"

#include "lambert/base/hash.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-5f) {
  EXPECT_LT(length(a - b), tolerance) << a.x << " " << a.y << " " << a.z << ", expected " << b.x << " " << b.y << " "
                                      << b.z;
}

float number(int i, int k) { return 2 * hash_to_float(hash_values(i, k)) - 1; }

/// An affine map at random, rows linearly independent in all likelihood.
Transform random_transform(int i) {
  Mat4 m(1);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) m[column][row] = number(i, 10 * column + row) + (column == row ? 2.0f : 0.0f);
  return Transform(m);
}

// rows: IS-55 IS-57
TEST(Transform, RayToObjectSpaceAndBack) {  // V-IS-24, the cube's half side 1 (E-IS-16)
  const Transform to_world = Transform::scale(Vec3(2));
  const Ray world{.origin = {4, 0, 0}, .direction = {-1, 0, 0}};
  Ray object = to_world.inverse().ray(world);
  EXPECT_EQ(object.origin, Vec3(2, 0, 0));
  EXPECT_EQ(length(object.direction), 0.5f);
  // Not made unit, the direction keeps t: the face x = 1 is met at t = 2 on both sides.
  const float t = (1 - object.origin.x) / object.direction.x;
  EXPECT_EQ(t, 2);
  EXPECT_EQ(world.at(t), Vec3(2, 0, 0));
}

// rows: IS-56
TEST(Transform, DistanceAlongAUnitDirectionIsDividedByItsLength) {  // V-IS-24, E-IS-17
  for (int i = 0; i < 100; ++i) {
    const Transform to_world = random_transform(i);
    const Ray world{.origin = {number(i, 1), number(i, 2), 5}, .direction = normalize(Vec3(number(i, 3), 1, -2))};
    const Ray object = to_world.inverse().ray(world);
    const float l = length(object.direction), t_object = 3;
    const Vec3 hit = object.origin + t_object * object.direction / l;
    expect_near(to_world.point(hit), world.at(t_object / l), 1e-4f);
  }
}

// rows: IS-58
TEST(Transform, NormalGoesByTheInverseTranspose) {  // V-IS-25, E-IS-18
  Mat4 m(1);
  m[0][0] = 2, m[0][2] = 0.5f;  // rows (2, 0, 0), (0, 1, 0), (0.5, 0, 1)
  const Transform c(m);
  const float h = std::sqrt(0.5f);
  expect_near(normalize(c.normal({h, h, 0})), {0.4472135955f, 0.894427191f, 0}, 1e-6f);
  EXPECT_NEAR(dot(c.normal({h, h, 0}), c.vector({h, -h, 0})), 0, 1e-6);
}

TEST(Transform, NormalsStayAcrossTheirTangents) {
  for (int i = 0; i < 100; ++i) {
    const Transform t = random_transform(i);
    const Vec3 a(number(i, 1), number(i, 2), 1), b(number(i, 3), 1, number(i, 4)), n = normalize(cross(a, b));
    EXPECT_NEAR(dot(normalize(t.normal(n)), normalize(t.vector(a))), 0, 1e-4);
    EXPECT_NEAR(dot(normalize(t.normal(n)), normalize(t.vector(b))), 0, 1e-4);
  }
}

TEST(Transform, PointsMoveAndVectorsDoNot) {
  const Transform t = Transform::translate({1, 2, 3});
  EXPECT_EQ(t.point({1, 1, 1}), Vec3(2, 3, 4));
  EXPECT_EQ(t.vector({1, 1, 1}), Vec3(1, 1, 1));
  EXPECT_EQ(t.normal({1, 1, 1}), Vec3(1, 1, 1));
}

TEST(Transform, ProductAppliesTheRightOneFirst) {
  const Transform t = Transform::translate({1, 0, 0}) * Transform::scale(Vec3(2));
  EXPECT_EQ(t.point({1, 1, 1}), Vec3(3, 2, 2));
  expect_near(t.inverse().point(t.point({4, 5, 6})), {4, 5, 6});
}

TEST(Transform, InverseUndoes) {
  for (int i = 0; i < 100; ++i) {
    const Transform t = random_transform(i);
    const Vec3 p(number(i, 1), number(i, 2), number(i, 3));
    expect_near(t.inverse().point(t.point(p)), p, 1e-4f);
  }
  expect_near(Transform::scale(Vec3(1e-6f)).inverse().point({1e-6f, 0, 0}), {1, 0, 0});
}

TEST(Transform, RotationIsCounterClockwiseAboutTheAxis) {
  expect_near(Transform::rotate(degrees(90), {0, 0, 5}).point({1, 0, 0}), {0, 1, 0});
}

TEST(Transform, LookAtPlacesTheCamera) {
  const Transform t = Transform::look_at({1, 2, 3}, {1, 2, -5}, {0, 1, 0});
  expect_near(t.point({0, 0, 0}), {1, 2, 3});
  expect_near(t.vector({0, 0, -1}), {0, 0, -1});
  expect_near(t.vector({1, 0, 0}), {1, 0, 0});
  expect_near(Transform::look_at({0, 0, 0}, {5, 0, 0}, {0, 1, 0}).vector({0, 0, -1}), {1, 0, 0});
}

TEST(Transform, KnowsSingularAndMirroredMaps) {
  EXPECT_TRUE(Transform::scale({1, 0, 1}).is_singular());
  EXPECT_FALSE(Transform::scale({1, 1e-6f, 1}).is_singular());
  EXPECT_TRUE(Transform::scale({1, 1e-39f, 1}).is_singular()) << "its inverse overflows";
  EXPECT_TRUE(Transform::scale({1, -1, 1}).swaps_handedness());
  EXPECT_FALSE(Transform::scale({-1, -1, 1}).swaps_handedness());
  EXPECT_TRUE(Transform().is_identity());
}

TEST(Transform, BoundsHoldTheMovedBox) {
  const Bounds3 box{{-1, -1, -1}, {1, 1, 1}};
  const Bounds3 turned = Transform::rotate(degrees(45), {0, 0, 1}).bounds(box);
  EXPECT_NEAR(turned.max.x, std::sqrt(2.0f), 1e-6);
  EXPECT_NEAR(turned.max.z, 1, 1e-6);
  EXPECT_TRUE(Transform::translate({1, 2, 3}).bounds({}).empty());
}

}  // namespace
}  // namespace lambert
