#include "lambert/formats/pbrt/pbrt_test_tools.h"

namespace lambert {
namespace {

/// Where a shape's origin or another point goes.
Vec3 moved(const std::string& transform, Vec3 p = Vec3(0)) {
  const SceneGraph graph = read_whole_world(transform + " Shape \"sphere\"");
  return graph.world_transform(shown(graph).at(0).node).point(p);
}

TEST(PbrtTransform, Composition) {
  expect_near(moved("Translate 1 2 3"), {1, 2, 3});
  expect_near(moved("Translate 1 0 0 Scale 2 2 2", {1, 1, 1}), {3, 2, 2});
  expect_near(moved("Rotate 90 0 0 1", {1, 0, 0}), {0, 1, 0});
  expect_near(moved("Rotate 90 0 2 0", {1, 0, 0}), {0, 0, -1});
  expect_near(moved("Translate 5 5 5 Identity", {1, 2, 3}), {1, 2, 3});
}

TEST(PbrtTransform, MatricesGoByColumns) {
  const std::string m = "[ 1 0 0 0  0 1 0 0  0 0 1 0  7 8 9 1 ]";
  expect_near(moved("Transform " + m), {7, 8, 9});
  expect_near(moved("Translate 1 1 1 Transform " + m), {7, 8, 9});
  expect_near(moved("Translate 1 1 1 ConcatTransform " + m), {8, 9, 10});
  expect_near(moved("Transform 0 1 0 0  -1 0 0 0  0 0 1 0  0 0 0 1", {1, 0, 0}), {0, 1, 0});
}

TEST(PbrtTransform, LookAtMapsTheEyeToTheOriginAndTheTargetToPlusZ) {
  const std::string look = "LookAt 1 2 3  1 2 8  0 1 0";
  expect_near(moved(look, {1, 2, 3}), {0, 0, 0});
  expect_near(moved(look, {1, 2, 8}), {0, 0, 5});
  expect_near(moved(look, {1, 3, 3}), {0, 1, 0});
  expect_near(moved(look, {2, 2, 3}), {1, 0, 0});  // left-handed: x right, y up, z forward
}

TEST(PbrtTransform, AttributesRestore) {
  expect_near(moved("AttributeBegin Translate 1 1 1 AttributeBegin Scale 2 2 2 AttributeEnd AttributeEnd", {1, 2, 3}),
              {1, 2, 3});
}

TEST(PbrtTransform, NamedCoordinateSystems) {
  expect_near(moved("Translate 1 2 3 CoordinateSystem \"here\" Identity CoordSysTransform \"here\""), {1, 2, 3});
  Notes notes;
  const SceneGraph graph = read_world("CoordSysTransform \"camera\" Shape \"sphere\"", notes,
                                      "LookAt 0 0 -4  0 0 0  0 1 0 Camera \"perspective\"");
  expect_near(graph.world_transform(shown(graph).at(0).node).point(Vec3(0, 0, 1)), {0, 0, -3});
  EXPECT_EQ(error_of([] { read_world("\n CoordSysTransform \"camrea\""); }),
            "s.pbrt:3:2: unknown coordinate system 'camrea' (known: world)");
}

TEST(PbrtTransform, MotionIsNotedAndTheStartIsShown) {
  Notes notes;
  const SceneGraph graph = read_world(
      "ActiveTransform EndTime Translate 9 0 0 ActiveTransform StartTime Translate 1 0 0 ActiveTransform All "
      "Translate 0 1 0 Shape \"sphere\"",
      notes, "TransformTimes 0 1");
  expect_near(graph.world_transform(shown(graph).at(0).node).point(Vec3(0)), {1, 1, 0});
  EXPECT_TRUE(has_note(notes, "motion of shapes"));
}

TEST(PbrtTransform, Errors) {
  EXPECT_EQ(error_of([] { read_world("Translate 1 2 \"x\""); }),
            "s.pbrt:2:15: expected the translation, a finite number, found \"x\"");
  EXPECT_EQ(error_of([] { read_world("Scale 1 1e999 1"); }),
            "s.pbrt:2:9: expected the scale, a finite number, found '1e999'");
  EXPECT_EQ(error_of([] { read_world("Rotate 40 0 0 0"); }), "s.pbrt:2:1: Rotate: the axis is zero");
  EXPECT_EQ(error_of([] { read_world("LookAt 0 0 0 0 1 0 0 1 0"); }),
            "s.pbrt:2:1: LookAt: the up vector is zero or points along the view");
  EXPECT_EQ(error_of([] { read_world("Scale 0 1 1 Shape \"sphere\""); }),
            "s.pbrt:2:13: Shape \"sphere\": its transformation is singular");
  EXPECT_EQ(error_of([] { read_world("ActiveTransform Middle"); }),
            "s.pbrt:2:17: unknown transformation 'Middle' (known: All, StartTime, EndTime)");
}

}  // namespace
}  // namespace lambert
