#include "lambert/camera/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-5f) {
  EXPECT_LT(length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

Camera example(Projection p) {
  return {.name = "c",
          .to_world = Transform::look_at({1, 2, 3}, {1, 2, -7}, {0, 1, 0}),
          .projection = p,
          .resolution = {200, 100}};
}

TEST(Camera, CentreRayRunsAlongTheAxis) {
  for (const Projection& p : {Projection(perspective(degrees(60), FovAxis::shorter, {200, 100})),
                              Projection(Orthographic{}), Projection(Panoramic{})}) {
    const CameraRay r = example(p).ray({100, 50});
    expect_near(r.ray.origin, {1, 2, 3});
    expect_near(r.ray.direction, {0, 0, -1});
  }
}

TEST(Camera, CornersOfAPerspectiveImage) {
  const Camera c = example(perspective(degrees(90), FovAxis::vertical, {200, 100}));
  expect_near(c.ray({0, 0}).ray.direction, normalize(Vec3(-2, 1, -1)));
  expect_near(c.ray({200, 100}).ray.direction, normalize(Vec3(2, -1, -1)));
}

TEST(Camera, FovAxes) {
  const Perspective vertical = perspective(degrees(90), FovAxis::vertical, {200, 100}),
                    horizontal = perspective(degrees(90), FovAxis::horizontal, {200, 100});
  EXPECT_FLOAT_EQ(vertical.half_height, 1);
  EXPECT_FLOAT_EQ(vertical.half_width, 2);
  EXPECT_FLOAT_EQ(horizontal.half_width, 1);
  EXPECT_FLOAT_EQ(horizontal.half_height, 0.5f);
  EXPECT_FLOAT_EQ(perspective(degrees(90), FovAxis::shorter, {100, 200}).half_width, 1);
}

// rows: PT-33
TEST(Camera, ThinLensRaysMeetInThePlaneOfFocus) {
  Perspective p = perspective(degrees(50), FovAxis::vertical, {200, 100});
  const Camera pinhole = example(p);
  p.lens_radius = 0.3f, p.focal_distance = 4;
  const Camera lens = example(p);
  const Vec2 film(37, 81);
  const Ray chief = pinhole.ray(film).ray;
  const Vec3 focus = chief.at(4 / -chief.direction.z);
  float widest = 0;
  for (const Vec2 u : {Vec2(0.1f, 0.2f), Vec2(0.9f, 0.3f), Vec2(0.5f, 0.99f), Vec2(0.02f, 0.97f)}) {
    const Ray r = lens.ray(film, u).ray;
    expect_near(r.at((focus.z - r.origin.z) / r.direction.z), focus, 1e-4f);
    widest = std::max(widest, length(r.origin - chief.origin));
  }
  EXPECT_GT(widest, 0.2f);
  EXPECT_LE(widest, 0.3f + 1e-5f);
}

TEST(Camera, PanoramaCoversTheSphere) {
  const Camera c = example(Panoramic{});
  expect_near(c.ray({100, 0}).ray.direction, {0, 1, 0});
  expect_near(c.ray({150, 50}).ray.direction, {1, 0, 0});
  expect_near(c.ray({0, 50}).ray.direction, {0, 0, 1});
}

TEST(Camera, ConeIsAsWideAsTheStepToTheNextPixel) {
  const Camera c = example(perspective(degrees(40), FovAxis::vertical, {200, 100}));
  const CameraRay a = c.ray({100, 50}), b = c.ray({101, 50});
  const float distance = 7;
  EXPECT_NEAR(a.cone.at(distance), length(a.ray.at(distance) - b.ray.at(distance)), 0.01f * a.cone.at(distance));
}

TEST(Camera, OtherResolutionKeepsTheVerticalExtent) {
  const Camera wide = example(perspective(degrees(90), FovAxis::vertical, {200, 100})).with_resolution({100, 100});
  expect_near(wide.ray({50, 0}).ray.direction, normalize(Vec3(0, 1, -1)));
  expect_near(wide.ray({0, 50}).ray.direction, normalize(Vec3(-1, 0, -1)));
}

TEST(Camera, ShutterIsSwept) {
  Camera c = example(Panoramic{});
  c.shutter_open = 1, c.shutter_close = 3;
  EXPECT_FLOAT_EQ(c.ray({0, 0}, Vec2(0.5f), 0.25f).ray.time, 1.5f);
}

TEST(Camera, AxisDepthIsTheDistanceOfThePlane) {
  const Camera c = example(perspective(degrees(90), FovAxis::vertical, {200, 100}));
  const Ray r = c.ray({0, 0}).ray;
  EXPECT_NEAR(c.axis_depth(r, 5 / -r.direction.z), 5, 1e-5);
}

TEST(FramingCamera, SeesAllCorners) {
  const Bounds3 box{{-1, 2, 3}, {4, 5, 9}};
  const Camera c = framing_camera(box, {320, 200});
  const Transform to_camera = c.to_world.inverse();
  const auto& p = std::get<Perspective>(c.projection);
  for (int i = 0; i < 8; ++i) {
    const Vec3 q = to_camera.point(box.corner(i));
    ASSERT_LT(q.z, 0);
    EXPECT_LT(std::abs(q.x / q.z), p.half_width);
    EXPECT_LT(std::abs(q.y / q.z), p.half_height);
  }
}

}  // namespace
}  // namespace lambert
