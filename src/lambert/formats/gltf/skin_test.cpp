#include "lambert/formats/gltf/skin.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

/// The triangle with two joints: nodes 1 and 2. Vertex 0 hangs on the first, 1 on the second, 2 on both.
TestDocument skinned() {
  TestDocument d = triangle_document();
  d.set("nodes", R"([{"mesh": 0, "skin": 0, "translation": [100, 0, 0]}, {}, {}])");
  d.set("skins", R"([{"joints": [1, 2]}])");
  auto& attributes = primitive(d)["attributes"];
  attributes["NORMAL"] = d.accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  attributes["JOINTS_0"] = d.accessor<std::uint8_t>("VEC4", {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
  attributes["WEIGHTS_0"] = d.accessor<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0});
  return d;
}
std::vector<Vec3> world_positions(const SceneGraph& graph) {
  std::vector<Vec3> positions;
  for (const Vec3 p : mesh_of(graph).positions)
    positions.push_back(graph.world_transform(shown(graph).at(0).node).point(p));
  return positions;
}

TEST(GltfSkin, JointsMoveVerticesAndTheNodeDoesNot) {
  TestDocument d = skinned();
  d["nodes"][2]["translation"] = {0, 0, 4};
  const auto p = world_positions(read(d));
  expect_near(p[0], {0, 0, 0});
  expect_near(p[1], {1, 0, 4});
  expect_near(p[2], {0, 1, 2});
}

TEST(GltfSkin, InverseBindMatricesComeFirst) {
  TestDocument d = skinned();
  d["nodes"][1]["scale"] = {2, 2, 2};
  std::vector<float> matrices(32, 0.0f);
  for (const std::size_t m : {0u, 16u})
    for (std::size_t i = 0; i < 16; i += 5) matrices[m + i] = 1;
  matrices[12] = 7;  // moves before the joint scales
  d["skins"][0]["inverseBindMatrices"] = d.accessor<float>("MAT4", matrices);
  expect_near(world_positions(read(d))[0], {14, 0, 0});
}

TEST(GltfSkin, WeightsNeedNotSumToOneAndNoneMeansStill) {
  TestDocument d = skinned();
  d["nodes"][1]["translation"] = {0, 0, 6};
  primitive(d)["attributes"]["WEIGHTS_0"] =
      d.accessor<std::uint8_t>("VEC4", {9, 0, 0, 0, 0, 0, 0, 0, 10, 20, 0, 0}, true);
  const auto p = world_positions(read(d));
  expect_near(p[0], {0, 0, 6});
  expect_near(p[1], {1, 0, 0});
  expect_near(p[2], {0, 1, 2});
}

TEST(GltfSkin, NormalsTurnByTheInverseTransposeAndMirrorsTurnTriangles) {
  TestDocument d = skinned();
  d["nodes"][1]["scale"] = d["nodes"][2]["scale"] = {-1, 1, 1};
  const SceneGraph graph = read(d);
  const TriangleMesh& m = mesh_of(graph);
  const Triangle t = m.triangles[0];
  const Vec3 n = cross(m.positions[t[1]] - m.positions[t[0]], m.positions[t[2]] - m.positions[t[0]]);
  expect_near(n, {0, 0, 1});
  expect_near(m.normals[0], {0, 0, 1});
  d["nodes"][1]["scale"] = d["nodes"][2]["scale"] = {1, 1, 0.25f};
  primitive(d)["attributes"]["NORMAL"] = d.accessor<float>("VEC3", {0, 3, 4, 0, 3, 4, 0, 3, 4});
  // (0, 3, 4 / 0.25), made unit.
  expect_near(mesh_of(read(d)).normals[0], Vec3(0, 3, 16) / std::sqrt(265.0f));
}

TEST(GltfSkin, ASecondSetOfJointsCounts) {
  TestDocument d = skinned();
  d["nodes"][2]["translation"] = {0, 0, 4};
  primitive(d)["attributes"]["JOINTS_1"] = d.accessor<std::uint16_t>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  primitive(d)["attributes"]["WEIGHTS_1"] = d.accessor<float>("VEC4", {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  expect_near(world_positions(read(d))[0], {0, 0, 2});
}

TEST(GltfSkin, ImpossibleSkinsAreRefused) {
  TestDocument joint = skinned();
  primitive(joint)["attributes"]["JOINTS_0"] =
      joint.accessor<std::uint8_t>("VEC4", {9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_NE(refusal(joint).find("/meshes/0/primitives/0: vertex 0 refers to joint 9"), std::string::npos);
  TestDocument node = skinned();
  node["skins"][0]["joints"] = {1, 7};
  EXPECT_NE(refusal(node).find("/skins/0/joints/1: refers to 7 of nodes"), std::string::npos);
  TestDocument matrices = skinned();
  matrices["skins"][0]["inverseBindMatrices"] = matrices.accessor<float>("MAT4", std::vector<float>(16));
  EXPECT_NE(refusal(matrices).find("has 1 matrices for 2 joints"), std::string::npos);
  TestDocument skin = skinned();
  skin["nodes"][0]["skin"] = 4;
  EXPECT_NE(refusal(skin).find("/nodes/0/skin: refers to 4 of skins"), std::string::npos);
}

}  // namespace
}  // namespace lambert::gltf
