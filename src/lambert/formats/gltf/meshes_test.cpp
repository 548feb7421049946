#include "lambert/formats/gltf/meshes.h"

#include "lambert/formats/gltf/gltf_test_tools.h"
#include "lambert/scene/scene.h"

namespace lambert::gltf {
namespace {

/// A document of one primitive with 5 vertices on a zigzag, in the given mode.
TestDocument zigzag(int mode) {
  TestDocument d = triangle_document();
  primitive(d)["mode"] = mode;
  primitive(d)["attributes"]["POSITION"] = d.accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
  return d;
}
std::vector<Triangle> triangles(const TestDocument& d) { return mesh_of(read(d)).triangles; }

TEST(GltfMeshes, Topologies) {  // glTF 2.0, 3.7.2.1
  EXPECT_EQ(triangles(zigzag(4)), (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(triangles(zigzag(5)), (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
  EXPECT_EQ(triangles(zigzag(6)), (std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
  EXPECT_EQ(refusal(zigzag(7)), "t.gltf: /meshes/0/primitives/0/mode: unknown mode 7 (known: 0 to 6)");
}

TEST(GltfMeshes, PointsAndLinesAreNoted) {
  for (int mode = 0; mode < 4; ++mode) {
    EXPECT_TRUE(shown(read(zigzag(mode))).empty());
    EXPECT_TRUE(has_note(notes_of(zigzag(mode)), mode == 0 ? "points are ignored" : "lines are ignored"));
  }
  TestDocument nowhere = triangle_document();
  primitive(nowhere)["attributes"].erase("POSITION");
  EXPECT_TRUE(has_note(notes_of(nowhere), "without positions"));
}

TEST(GltfMeshes, IndicesOfEverySize) {
  const auto with = [](auto zero) {
    TestDocument d = zigzag(4);
    primitive(d)["indices"] = d.accessor<decltype(zero)>("SCALAR", {4, 2, 3, 0, 1, 2});
    return triangles(d);
  };
  const std::vector<Triangle> expected{{4, 2, 3}, {0, 1, 2}};
  EXPECT_EQ(with(std::uint8_t{}), expected);
  EXPECT_EQ(with(std::uint16_t{}), expected);
  EXPECT_EQ(with(std::uint32_t{}), expected);
}

TEST(GltfMeshes, OnlyUsedVerticesAreRead) {
  TestDocument d = triangle_document();
  std::vector<float> many(300);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = static_cast<float>(i * i % 97);
  primitive(d)["attributes"]["POSITION"] = d.accessor<float>("VEC3", many);
  primitive(d)["indices"] = d.accessor<std::uint8_t>("SCALAR", {90, 7, 50});
  const SceneGraph graph = read(d);
  const TriangleMesh& mesh = mesh_of(graph);
  ASSERT_EQ(mesh.positions.size(), 3u);
  for (const auto& [corner, vertex] : {std::pair{0, 90}, {1, 7}, {2, 50}})
    EXPECT_EQ(mesh.positions[mesh.triangles[0][static_cast<std::size_t>(corner)]].x,
              many[static_cast<std::size_t>(3 * vertex)]);
}

TEST(GltfMeshes, AllAttributes) {
  TestDocument d = triangle_document();
  auto& a = primitive(d)["attributes"];
  a["NORMAL"] = d.accessor<float>("VEC3", {0, 0, 2, 0, 0, 0, 0, 3, 4});
  a["TANGENT"] = d.accessor<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 0});
  a["TEXCOORD_0"] = d.accessor<std::uint8_t>("VEC2", {0, 255, 255, 0, 51, 102}, true);
  a["TEXCOORD_1"] = d.accessor<float>("VEC2", {1, 2, 3, 4, 5, 6});
  a["COLOR_0"] = d.accessor<std::uint16_t>("VEC3", {65535, 0, 0, 0, 0, 0, 0, 0, 0}, true);
  a["_SPECIAL"] = d.accessor<float>("SCALAR", {1, 2, 3});
  Notes notes;
  const SceneGraph graph = read(d.text(), notes);
  const TriangleMesh& m = mesh_of(graph);
  expect_near(m.normals[0], {0, 0, 1});
  expect_near(m.normals[1], {0, 0, 1});  // of length zero: the shape's
  expect_near(m.normals[2], {0, 0.6f, 0.8f});
  EXPECT_EQ(m.tangents[1].w, -1);
  EXPECT_EQ(m.tangents[2].w, 1);
  EXPECT_NEAR(m.uvs[2].y, 0.4f, 1e-6f);
  EXPECT_EQ(m.uvs1[2], Vec2(5, 6));
  EXPECT_EQ(m.colours[0], Vec4(1, 0, 0, 1));
  EXPECT_TRUE(has_note(notes, "_SPECIAL is ignored"));
  EXPECT_TRUE(has_note(notes, "normals of length zero"));
}

TEST(GltfMeshes, QuantizedPositions) {  // KHR_mesh_quantization
  TestDocument d = triangle_document();
  d.set("extensionsRequired", R"(["KHR_mesh_quantization"])");
  primitive(d)["attributes"]["POSITION"] = d.accessor<std::int16_t>("VEC3", {0, 0, 0, -300, 0, 0, 0, 5, 0});
  primitive(d)["attributes"]["NORMAL"] = d.accessor<std::int8_t>("VEC3", {0, 0, 127, 0, 0, 127, 0, 0, 127}, true);
  const SceneGraph graph = read(d);
  expect_near(mesh_of(graph).positions[1], {-300, 0, 0});
  expect_near(mesh_of(graph).normals[0], {0, 0, 1});
}

TEST(GltfMeshes, MorphTargetsMoveNormalsAndTangentsToo) {
  TestDocument d = triangle_document();
  auto& a = primitive(d)["attributes"];
  a["NORMAL"] = d.accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  a["TANGENT"] = d.accessor<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  const std::size_t up = d.accessor<float>("VEC3", {0, 2, 0, 0, 0, 0, 0, 0, 0});
  for (const char* name : {"POSITION", "NORMAL", "TANGENT"}) primitive(d)["targets"][0][name] = up;
  d["meshes"][0]["weights"] = {0.5f};
  const SceneGraph graph = read(d);
  expect_near(mesh_of(graph).positions[0], {0, 1, 0});
  expect_near(mesh_of(graph).normals[0], Vec3(0, 1, 1) / std::sqrt(2.0f));
  expect_near(Vec3(mesh_of(graph).tangents[0]), {1, 1, 0});
  d["nodes"][0]["weights"] = {0.0f};
  expect_near(mesh_of(read(d)).positions[0], {0, 0, 0});
}

TEST(GltfMeshes, NodesShareGeometryUnlessTheirWeightsDiffer) {
  TestDocument d = triangle_document();
  d.set("nodes", R"([{"mesh": 0}, {"mesh": 0}, {"mesh": 0, "weights": [1]}])");
  primitive(d)["targets"][0]["POSITION"] = d.accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  const SceneGraph graph = read(d);
  const auto all = shown(graph);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].surface.geometry, all[1].surface.geometry);
  EXPECT_NE(all[0].surface.geometry, all[2].surface.geometry);
}

TEST(GltfMeshes, MirroredNodesKeepTheirOutwardSide) {
  for (const char* node :
       {R"([{"mesh": 0}])", R"([{"mesh": 0, "scale": [-1, 1, 1]}])", R"([{"mesh": 0, "scale": [-1, -1, 1]}])",
        R"([{"scale": [1, -1, 1], "children": [1]}, {"mesh": 0}])"}) {
    TestDocument d = triangle_document().set("nodes", node);
    SceneGraph graph = read(d);
    const Vec3 inside = graph.world_transform(shown(graph)[0].node).point({0.25f, 0.25f, 0});
    const Scene scene = compile(std::move(graph));
    const Ray ray{inside + Vec3(0, 0, 1), {0, 0, -1}};
    Hit hit;
    ASSERT_TRUE(scene.intersect(ray, hit)) << node;
    expect_near(scene.surface_point(ray, hit).ng, {0, 0, 1});
  }
}

TEST(GltfMeshes, NodesThatAreFlatAreLeftOut) {
  TestDocument d = triangle_document();
  d.set("nodes", R"([{"mesh": 0, "scale": [1, 0, 1]}, {"mesh": 0, "scale": [0, 0, 0]}, {"mesh": 0}])");
  Notes notes;
  SceneGraph graph = read(d.text(), notes);
  EXPECT_EQ(shown(graph).size(), 1u);
  EXPECT_TRUE(has_note(notes, "a scale of 0 flattens"));
  EXPECT_NO_THROW(compile(std::move(graph)));
}

TEST(GltfMeshes, WhatDoesNotFitIsRefused) {
  TestDocument index = triangle_document();
  primitive(index)["indices"] = index.accessor<std::uint8_t>("SCALAR", {0, 1, 3});
  EXPECT_EQ(refusal(index),
            "t.gltf: /meshes/0/primitives/0/indices: index 3 at element 2 is out of range: there are 3 vertices");
  TestDocument length = triangle_document();
  primitive(length)["attributes"]["NORMAL"] = length.accessor<float>("VEC3", {0, 0, 1});
  EXPECT_EQ(refusal(length),
            "t.gltf: /meshes/0/primitives/0/attributes/NORMAL: has 1 elements, but there are 3 vertices");
  TestDocument width = triangle_document();
  primitive(width)["attributes"]["POSITION"] = width.accessor<float>("VEC2", {0, 0, 1, 0, 1, 1});
  EXPECT_NE(refusal(width).find("/attributes/POSITION: expected 3 components, found 2"), std::string::npos);
  TestDocument target = triangle_document();
  primitive(target)["targets"][0]["POSITION"] = target.accessor<float>("VEC3", {0, 0, 1});
  target["meshes"][0]["weights"] = {1};
  EXPECT_NE(refusal(target).find("/targets/0/POSITION: has 1 elements"), std::string::npos);
  TestDocument mesh = triangle_document().set("nodes", R"([{"mesh": 3}])");
  EXPECT_EQ(refusal(mesh), "t.gltf: /nodes/0/mesh: refers to 3 of meshes, but there are 1");
}

}  // namespace
}  // namespace lambert::gltf
