#include "lambert/formats/gltf/hierarchy.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

/// Where the triangle's corner (1, 0, 0) is in the world.
Vec3 corner(const TestDocument& d) {
  const SceneGraph graph = read(d);
  const Shown s = shown(graph).at(0);
  return graph.world_transform(s.node).point(mesh_of(graph).positions[1]);
}
TestDocument with_nodes(std::string_view nodes) { return triangle_document().set("nodes", nodes); }

TEST(GltfHierarchy, TranslationRotationScaleInThatOrder) {
  // Scaled by 2, then a quarter turn about z, then moved.
  expect_near(corner(with_nodes(R"([{"mesh": 0, "scale": [2, 1, 1], "rotation": [0, 0, 0.70710678, 0.70710678],
      "translation": [10, 20, 30]}])")),
              {10, 22, 30});
}

TEST(GltfHierarchy, MatricesAreByColumns) {
  expect_near(corner(with_nodes(R"([{"mesh": 0, "matrix": [0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]}])")), {5, 7, 7});
}

TEST(GltfHierarchy, ChildrenMoveWithTheirParents) {
  expect_near(corner(with_nodes(R"([{"mesh": 0, "translation": [0, 0, 1]}, {"children": [0], "scale": [3, 3, 3]},
      {"children": [1], "translation": [1, 0, 0]}])")),
              {4, 0, 3});
}

TEST(GltfHierarchy, RotationsAreMadeUnitAndZeroIsNone) {
  expect_near(corner(with_nodes(R"([{"mesh": 0, "rotation": [0, 0, 5, 5]}])")), {0, 1, 0});
  expect_near(corner(with_nodes(R"([{"mesh": 0, "rotation": [0, 0, 0, 0]}])")), {1, 0, 0});
}

TEST(GltfHierarchy, OnlyTheDefaultSceneIsShown) {
  TestDocument d = with_nodes(R"([{"mesh": 0, "name": "a"}, {"mesh": 0, "name": "b"}])");
  EXPECT_EQ(shown(read(d)).size(), 2u) << "no scenes: all roots";
  d.set("scenes", R"([{"nodes": [0]}, {"nodes": [1]}])")["scene"] = 1;
  const SceneGraph graph = read(d);
  ASSERT_EQ(shown(graph).size(), 1u);
  EXPECT_EQ(graph.node_name(shown(graph)[0].node), "b");
  EXPECT_TRUE(has_note(notes_of(d), "only one of 2 glTF scenes"));
}

TEST(GltfHierarchy, ImpossibleTreesAreRefused) {
  EXPECT_EQ(refusal(with_nodes(R"([{"children": [1]}, {"children": [0]}])")), "t.gltf: /nodes/0: is its own ancestor");
  EXPECT_EQ(refusal(with_nodes(R"([{"children": [0]}])")), "t.gltf: /nodes/0: is its own ancestor");
  EXPECT_EQ(refusal(with_nodes(R"([{"children": [2]}, {"children": [2]}, {}])")),
            "t.gltf: /nodes/1/children/0: node 2 has a parent already");
  EXPECT_EQ(refusal(with_nodes(R"([{"children": [9]}])")),
            "t.gltf: /nodes/0/children/0: refers to node 9, but there are 1");
  EXPECT_NE(refusal(with_nodes(R"([{}, {"children": [0]}])").set("scenes", R"([{"nodes": [0]}])"))
                .find("/scenes/0/nodes/0: node 0 is a child of another node"),
            std::string::npos);
  EXPECT_NE(refusal(with_nodes("[{}]").set("scenes", R"([{"nodes": [0, 0]}])"))
                .find("/scenes/0/nodes/1: node 0 is listed twice"),
            std::string::npos);
}

TEST(GltfHierarchy, ImpossibleNumbersAreRefused) {
  EXPECT_NE(refusal(with_nodes(R"([{"matrix": [1, 0]}])")).find("/nodes/0/matrix: expected 16 numbers, found 2"),
            std::string::npos);
  EXPECT_NE(refusal(with_nodes(R"([{"scale": [1e30, 1, 1], "children": [1]}, {"scale": [1e30, 1, 1]}])"))
                .find("/nodes/1: a number of its transform is not finite"),
            std::string::npos);
}

TEST(GltfHierarchy, DeepTreesNeedNoRecursion) {
  TestDocument d = triangle_document();
  constexpr std::size_t depth = 20'000;
  for (std::size_t i = 0; i < depth; ++i) d["nodes"][i]["children"] = {i + 1};
  d["nodes"][0].erase("mesh");
  d["nodes"][depth]["mesh"] = 0;
  EXPECT_EQ(shown(read(d)).size(), 1u);
}

}  // namespace
}  // namespace lambert::gltf
