#include "lambert/camera/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(Camera, MirroredCameraSwapsLeftAndRight) {
  Camera c = example(perspective(degrees(60), FovAxis::vertical, {200, 100}));
  const Vec3 d = c.ray({30, 20}).ray.direction;
  c.to_world = c.to_world * Transform::scale({-1, 1, 1});
  expect_near(c.ray({30, 20}).ray.direction, {-d.x, d.y, d.z});
  EXPECT_NEAR(length(c.ray({30, 20}).ray.direction), 1, 1e-6);
}

TEST(Camera, ScaledCameraHasTheSameUnitRays) {
  Camera c = example(perspective(degrees(60), FovAxis::vertical, {200, 100}));
  const CameraRay before = c.ray({30, 20});
  c.to_world = c.to_world * Transform::scale(Vec3(5));
  const CameraRay after = c.ray({30, 20});
  expect_near(after.ray.direction, before.ray.direction);
  EXPECT_FLOAT_EQ(after.cone.spread, before.cone.spread);
}

/// Where the rays of two neighbouring pixels, followed for `distance`, are apart as much as the cone is wide.
void expect_cone_as_wide_as_the_step(const Camera& c, Vec2 film, float distance) {
  const CameraRay a = c.ray(film - Vec2(0, 0.5f)), b = c.ray(film + Vec2(0, 0.5f)), middle = c.ray(film);
  const float width = middle.cone.at(distance);
  EXPECT_NEAR(length(a.ray.at(distance) - b.ray.at(distance)), width, 0.02f * width);
}

TEST(Camera, ConeIsAsWideAsTheStepToTheNextPixel) {
  for (const float scale : {1.0f, 3.0f})
    for (const Projection& p : {Projection(perspective(degrees(40), FovAxis::vertical, {200, 100})),
                                Projection(Orthographic{.half_width = 4, .half_height = 2}), Projection(Panoramic{})}) {
      Camera c = example(p);
      c.to_world = c.to_world * Transform::scale(Vec3(scale));
      expect_cone_as_wide_as_the_step(c, {100, 50}, 7);
    }
  // Off the axis: at the side of the image a pixel is as far apart from its upper neighbour as at its centre, at the
  // same depth.
  expect_cone_as_wide_as_the_step(example(perspective(degrees(70), FovAxis::vertical, {200, 100})), {10, 50}, 7);
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

// rows: PT-33
TEST(Camera, LensIsCoveredEvenly) {
  Camera c = example(Orthographic{.lens_radius = 2, .focal_distance = 5});
  Vec2 sum(0);
  float squares = 0;
  constexpr int side = 50;
  for (int i = 0; i < side * side; ++i) {
    const Vec2 u = (Vec2(i % side, i / side) + 0.5f) / static_cast<float>(side);
    const Vec3 on_lens = c.ray({100, 50}, u).ray.origin - Vec3(1, 2, 3);
    EXPECT_NEAR(on_lens.z, 0, 1e-6);
    sum += Vec2(on_lens), squares += dot(on_lens, on_lens);
  }
  EXPECT_NEAR(length(sum) / (side * side), 0, 1e-3);
  EXPECT_NEAR(squares / (side * side), 2, 0.02);  // the mean of r² over a disk of radius 2
}

TEST(FramingCamera, SeesAllCornersAndFillsTheImage) {
  for (const float scale : {1e-5f, 1.0f, 1e4f})
    for (const Vec2i resolution : {Vec2i(320, 200), Vec2i(100, 300)}) {
      const Bounds3 box{scale * Vec3(-1, 2, 3), scale * Vec3(4, 5, 9)};
      const Camera c = framing_camera(box, resolution);
      const Transform to_camera = c.to_world.inverse();
      const auto& p = std::get<Perspective>(c.projection);
      float widest = 0;
      for (int i = 0; i < 8; ++i) {
        const Vec3 q = to_camera.point(box.corner(i));
        ASSERT_LT(q.z, 0);
        widest = std::max({widest, std::abs(q.x / q.z) / p.half_width, std::abs(q.y / q.z) / p.half_height});
      }
      EXPECT_LT(widest, 1);
      EXPECT_GT(widest, 0.85f);
    }
}

TEST(FramingCamera, PointsAndNothingAreLookedAt) {
  for (const Bounds3& box : {Bounds3{}, Bounds3{Vec3(1, 2, 3), Vec3(1, 2, 3)}}) {
    const Ray r = framing_camera(box, {100, 100}).ray({50, 50}).ray;
    const Vec3 target = box.empty() ? Vec3(0) : box.min;
    EXPECT_NEAR(dot(normalize(target - r.origin), r.direction), 1, 1e-5);
  }
}

}  // namespace
}  // namespace lambert
