#include "lambert/formats/gltf/instancing.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

nlohmann::json& instance_attributes(TestDocument& d) {
  return d["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
}

TEST(GltfInstancing, CopiesStandInTheirNodeAndShareGeometry) {
  TestDocument d = triangle_document();
  d["nodes"][0]["translation"] = {100, 0, 0};
  instance_attributes(d)["TRANSLATION"] = d.accessor<float>("VEC3", {0, 0, 0, 0, 5, 0});
  instance_attributes(d)["SCALE"] = d.accessor<float>("VEC3", {1, 1, 1, 2, 2, 2});
  instance_attributes(d)["ROTATION"] = d.accessor<std::int8_t>("VEC4", {0, 0, 0, 127, 0, 0, 127, 0}, true);
  instance_attributes(d)["_COLOR"] = d.accessor<float>("SCALAR", {0, 1});
  Notes notes;
  const SceneGraph graph = read(d.text(), notes);
  const auto all = shown(graph);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].surface.geometry, all[1].surface.geometry);
  expect_near(graph.world_transform(all[0].node).point({1, 0, 0}), {101, 0, 0});
  expect_near(graph.world_transform(all[1].node).point({1, 0, 0}), {98, 5, 0});
  EXPECT_TRUE(has_note(notes, "instance attribute _COLOR is ignored"));
}

TEST(GltfInstancing, AttributesOfDifferentLengthsAreRefused) {
  TestDocument d = triangle_document();
  instance_attributes(d)["TRANSLATION"] = d.accessor<float>("VEC3", {0, 0, 0, 0, 5, 0});
  instance_attributes(d)["SCALE"] = d.accessor<float>("VEC3", {1, 1, 1});
  // Objects are in alphabetical order here.
  EXPECT_NE(refusal(d).find("attributes/TRANSLATION: has 2 elements, but other attributes have 1"), std::string::npos);
}

TEST(GltfInstancing, MoreCopiesThanTheFileCanMeanAreRefused) {
  TestDocument d = triangle_document();
  d["accessors"].push_back(nlohmann::json::parse(R"({"componentType": 5126, "type": "VEC3", "count": 300000000})"));
  instance_attributes(d)["TRANSLATION"] = 1;
  EXPECT_NE(refusal(d).find("out of proportion to the size of the file"), std::string::npos);
}

}  // namespace
}  // namespace lambert::gltf
