#include "lambert/base/error.h"
#include "lambert/geometry/shape_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

using Planes = std::vector<ConvexPolyhedron::Plane>;

Planes box_planes(Vec3 centre, Vec3 half) {
  Planes planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      Vec3 n(0);
      n[axis] = side;
      planes.push_back({n, side * centre[axis] + half[axis]});
    }
  return planes;
}

// rows: PG-68
TEST(ConvexPolyhedron, WorkedExample) {  // V-PG-48
  const ConvexPolyhedron cube(box_planes(Vec3(0), Vec3(1)));
  const auto through = all_hits(cube, {.origin = {-5, 0.25f, 0.5f}, .direction = {1, 0, 0}});
  ASSERT_EQ(through.size(), 2u);
  EXPECT_EQ(through[0].t, 4);
  EXPECT_EQ(through[0].normal, Vec3(-1, 0, 0));
  EXPECT_EQ(through[1].t, 6);
  EXPECT_EQ(through[1].normal, Vec3(1, 0, 0));
  EXPECT_FALSE(cube.intersect({.origin = {-5, 1.5f, 0}, .direction = {1, 0, 0}}));
  const auto inside = all_hits(cube, {.origin = {0, 0, 0}, .direction = {1, 0, 0}, .t_min = -10});
  ASSERT_EQ(inside.size(), 2u);
  EXPECT_EQ(inside[0].t, -1);
  EXPECT_EQ(inside[1].t, 1);
}

// rows: PG-68
TEST(ConvexPolyhedron, RayInAFaceMeetsTheFacesAcross) {
  const ConvexPolyhedron cube(box_planes(Vec3(0), Vec3(1)));
  const auto hit = cube.intersect({.origin = {-5, 1, 0}, .direction = {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 4);
}

// rows: PG-68
TEST(ConvexPolyhedron, AgreesWithTheDefinitionAlongTheRay) {
  Random random(1);
  Planes planes = box_planes(Vec3(0), Vec3(1));
  for (int i = 0; i < 8; ++i) planes.push_back({random.direction(), 1.1f});
  const ConvexPolyhedron body(planes);
  const auto inside = [&](Vec3 p) {
    for (const auto& plane : planes)
      if (dot(plane.normal, p) > plane.offset) return false;
    return true;
  };
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = random_line(random, Vec3(0), 1.5f);
    const auto hits = all_hits(body, ray);
    for (float t = 0.01f; t < 6; t += 0.05f) {
      if (hits.size() == 2 && std::min(std::abs(t - hits[0].t), std::abs(t - hits[1].t)) < 1e-4f) continue;
      const bool between = hits.size() == 2 && t > hits[0].t && t < hits[1].t;
      ASSERT_EQ(inside(ray.at(t)), between) << "ray " << i << " at " << t;
    }
  }
}

TEST(ConvexPolyhedron, FacesOfATetrahedron) {
  const ConvexPolyhedron body({{{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}, {{1, 1, 1}, 1}});
  EXPECT_EQ(body.face_count(), 4u);
  EXPECT_NEAR(body.area(), 1.5 + std::sqrt(3.0) / 2, 1e-5);
  EXPECT_LT(length(body.bounds().max - Vec3(1)), 1e-5f);
}

TEST(ConvexPolyhedron, PlanesThatRepeatOrMerelyTouchHaveNoFace) {
  Planes planes = box_planes(Vec3(3, 4, 5), Vec3(1));
  planes.push_back({{2, 0, 0}, 8});    // the face x = 4 once more
  planes.push_back({{1, 1, 0}, 9});    // touches the edge x = 4, y = 5
  planes.push_back({{0, 0, 1}, 100});  // beyond
  const ConvexPolyhedron body(planes);
  EXPECT_EQ(body.face_count(), 6u);
  EXPECT_NEAR(body.area(), 24, 1e-4);
}

TEST(ConvexPolyhedron, RefusesTheUnboundedAndTheEmpty) {
  Planes open = box_planes(Vec3(0), Vec3(1));
  open.pop_back();
  EXPECT_THROW(ConvexPolyhedron{open}, Error);
  EXPECT_THROW(ConvexPolyhedron(Planes{}), Error);
  EXPECT_THROW(ConvexPolyhedron({{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}, {{1, 1, 1}, 1}}), Error);
  Planes empty = box_planes(Vec3(0), Vec3(1));
  empty.push_back({{1, 0, 0}, -2});
  EXPECT_THROW(ConvexPolyhedron{empty}, Error);
  Planes undirected = box_planes(Vec3(0), Vec3(1));
  undirected.push_back({Vec3(0), 1});
  EXPECT_THROW(ConvexPolyhedron{undirected}, Error);
  Planes flat = box_planes(Vec3(0), Vec3(1));
  flat.push_back({{1, 0, 0}, -1});
  EXPECT_THROW(ConvexPolyhedron{flat}, Error);
}

}  // namespace
}  // namespace lambert
