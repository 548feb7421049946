#include "lambert/formats/gltf/animation.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

/// Node 0's `path` moved by keys at `times`.
TestDocument animated(const char* path, const char* interpolation, const std::vector<float>& times, const char* type,
                      const std::vector<float>& values) {
  TestDocument d = triangle_document();
  d.set("animations", R"([{"channels": [{"sampler": 0, "target": {"node": 0}}], "samplers": [{}]}])");
  d["animations"][0]["channels"][0]["target"]["path"] = path;
  d["animations"][0]["samplers"][0]["interpolation"] = interpolation;
  d["animations"][0]["samplers"][0]["input"] = d.accessor<float>("SCALAR", times);
  d["animations"][0]["samplers"][0]["output"] = d.accessor<float>(type, values);
  return d;
}
Vec3 moved(const TestDocument& d, float time, Vec3 point = Vec3(0)) {
  const SceneGraph graph = read(d, {time, ""});
  return graph.world_transform(shown(graph).at(0).node).point(point);
}

TEST(GltfAnimation, LinearAndStepAndOutsideOfTheKeys) {
  const std::vector<float> times{1, 3}, values{0, 0, 0, 10, 20, 30};
  const TestDocument linear = animated("translation", "LINEAR", times, "VEC3", values);
  expect_near(moved(linear, 0), {0, 0, 0});
  expect_near(moved(linear, 1.5f), {2.5f, 5, 7.5f});
  expect_near(moved(linear, 3), {10, 20, 30});
  expect_near(moved(linear, 99), {10, 20, 30});
  const TestDocument step = animated("translation", "STEP", times, "VEC3", values);
  expect_near(moved(step, 2.99f), {0, 0, 0});
  expect_near(moved(step, 3), {10, 20, 30});
}

TEST(GltfAnimation, CubicSplinesTakeTheirTangents) {  // glTF 2.0, appendix C.5
  // From 0 with slope 3 to 8 with slope 0 in 2 seconds; in-tangent, value, out-tangent of each key.
  const TestDocument d =
      animated("translation", "CUBICSPLINE", {0, 2}, "VEC3", {99, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 8, 0, 0, 99, 0, 0});
  // At the middle: (1/8) 2 * 3 + (1/2) 8 = 4.75.
  expect_near(moved(d, 1), {4.75f, 0, 0});
  expect_near(moved(d, 2), {8, 0, 0});
  EXPECT_NEAR((moved(d, 1e-3f).x - moved(d, 0).x) / 1e-3f, 3, 0.02f);
}

TEST(GltfAnimation, RotationsFollowTheShorterArc) {
  const float h = 0.70710678f;
  // A quarter turn about z, its quaternion negated: half of the time must be an eighth turn.
  const TestDocument d = animated("rotation", "LINEAR", {0, 1}, "VEC4", {0, 0, 0, 1, 0, 0, -h, -h});
  expect_near(moved(d, 0.5f, {1, 0, 0}), {h, h, 0});
}

TEST(GltfAnimation, ScaleReplacesAMatrix) {
  TestDocument d = animated("scale", "LINEAR", {0, 1}, "VEC3", {1, 1, 1, 3, 1, 1});
  expect_near(moved(d, 0.5f, {1, 1, 1}), {2, 1, 1});
}

TEST(GltfAnimation, AnimatedWeightsMorph) {
  TestDocument d = animated("weights", "LINEAR", {0, 1}, "SCALAR", {0, 0, 1, 0.5f});
  primitive(d)["targets"][0]["POSITION"] = d.accessor<float>("VEC3", {1, 0, 0, 1, 0, 0, 1, 0, 0});
  primitive(d)["targets"][1]["POSITION"] = d.accessor<float>("VEC3", {0, 8, 0, 0, 0, 0, 0, 0, 0});
  const SceneGraph graph = read(d, {0.5f, ""});
  expect_near(mesh_of(graph).positions[0], {0.5f, 2, 0});
  expect_near(mesh_of(graph).positions[1], {1.5f, 0, 0});
  expect_near(mesh_of(read(d)).positions[0], {0, 0, 0});
}

TEST(GltfAnimation, NormalizedIntegersAnimateToo) {
  TestDocument d = animated("rotation", "STEP", {0}, "VEC4", {0, 0, 0, 1});
  d["animations"][0]["samplers"][0]["output"] = d.accessor<std::int16_t>("VEC4", {0, 0, 32767, 0}, true);
  expect_near(moved(d, 0, {1, 0, 0}), {-1, 0, 0});
}

TEST(GltfAnimation, ImpossibleKeysAreRefused) {
  const auto refused = [](const TestDocument& d) { return refusal(d); };
  EXPECT_NE(refused(animated("translation", "LINEAR", {2, 1}, "VEC3", {0, 0, 0, 1, 1, 1})).find("must increase"),
            std::string::npos);
  EXPECT_NE(refused(animated("translation", "LINEAR", {0, 1}, "VEC3", {0, 0, 0})).find("has 1 elements for 2 keys"),
            std::string::npos);
  EXPECT_NE(refused(animated("rotation", "LINEAR", {0}, "VEC3", {0, 0, 0})).find("a rotation needs 4 numbers"),
            std::string::npos);
  EXPECT_NE(refused(animated("scale", "LINER", {0}, "VEC3", {0, 0, 0})).find("did you mean 'LINEAR'"),
            std::string::npos);
  TestDocument d = animated("scale", "LINEAR", {0}, "VEC3", {1, 1, 1});
  d["animations"][0]["channels"][0]["sampler"] = 5;
  EXPECT_NE(refused(d).find("/animations/0/channels/0/sampler: there is no such sampler"), std::string::npos);
  d["animations"][0]["channels"][0]["sampler"] = 0;
  d["animations"][0]["channels"][0]["target"]["node"] = 5;
  EXPECT_NE(refused(d).find("refers to 5 of nodes"), std::string::npos);
}

TEST(GltfAnimation, WhatIsNotPlayedIsNoted) {
  TestDocument d = animated("pointer", "LINEAR", {0}, "VEC3", {1, 1, 1});
  d["animations"].push_back(d["animations"][0]);
  EXPECT_TRUE(has_note(notes_of(d), "'pointer' is ignored"));
  EXPECT_TRUE(has_note(notes_of(d), "only the first of 2 glTF animations"));
}

}  // namespace
}  // namespace lambert::gltf
