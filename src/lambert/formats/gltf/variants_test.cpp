#include "lambert/formats/gltf/variants.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

TestDocument document() {
  TestDocument d = triangle_document();
  d.set("materials", R"([{"name": "plain"}, {"name": "gold"}])");
  d.set("extensions",
        R"({"KHR_materials_variants": {"variants": [{"name": "dawn"}, {"name": "dusk"}, {"name": "noon"}]}})");
  primitive(d)["material"] = 0;
  primitive(d)["extensions"] =
      nlohmann::json::parse(R"({"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [1, 2]}]}})");
  return d;
}
std::string shown_material(const std::string& variant) {
  const SceneGraph graph = read(document(), {0, variant});
  return first_material(graph).name;
}

TEST(GltfVariants, ChooseMaterials) {
  EXPECT_EQ(shown_material(""), "plain");
  EXPECT_EQ(shown_material("dawn"), "plain");
  EXPECT_EQ(shown_material("dusk"), "gold");
  EXPECT_EQ(shown_material("noon"), "gold");
}

TEST(GltfVariants, UnknownOnesNameTheKnown) {
  const std::string error = refusal(document(), {0, "dask"});
  for (const char* word : {"t.gltf", "'dask'", "dusk", "dawn", "noon"})
    EXPECT_NE(error.find(word), std::string::npos) << error;
  EXPECT_EQ(refusal(triangle_document(), {0, "x"}), "t.gltf: has no material variants, so there is no 'x'");
}

}  // namespace
}  // namespace lambert::gltf
