#include "lambert/formats/gltf/gltf_test_tools.h"
#include "lambert/scene/scene.h"

#include <algorithm>

namespace lambert::gltf {
namespace {

/// A document with most of what the reader knows.
TestDocument rich_document() {
  TestDocument d = triangle_document();
  d.set("nodes", R"([{"mesh": 0, "skin": 0, "weights": [0.5]}, {"camera": 0, "children": [2]},
      {"rotation": [0, 0, 1, 1], "extensions": {"KHR_lights_punctual": {"light": 0}}}, {"mesh": 0}])");
  d.set("cameras", R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}])");
  d.set("extensions", R"({"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {"outerConeAngle": 0.5}}]}})");
  d.set("materials", R"([{"alphaMode": "MASK", "emissiveFactor": [1, 1, 1], "extensions": {
      "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 2}, "KHR_materials_ior": {"ior": 1.4},
      "KHR_materials_clearcoat": {"clearcoatFactor": 1}}}])");
  d.set("skins", R"([{"joints": [1, 2]}])").set("scenes", R"([{"nodes": [0, 1, 3]}])");
  auto& p = primitive(d);
  p["material"] = 0;
  p["indices"] = d.accessor<std::uint8_t>("SCALAR", {0, 1, 2});
  p["targets"][0]["POSITION"] = d.accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  p["attributes"]["NORMAL"] = d.accessor<std::int8_t>("VEC3", {0, 0, 127, 0, 0, 127, 0, 0, 127}, true);
  p["attributes"]["JOINTS_0"] = d.accessor<std::uint8_t>("VEC4", std::vector<std::uint8_t>(12, 1));
  p["attributes"]["WEIGHTS_0"] = d.accessor<float>("VEC4", std::vector<float>(12, 0.25f));
  d.set("animations",
        R"([{"channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}], "samplers": [{}]}])");
  d["animations"][0]["samplers"][0]["input"] = d.accessor<float>("SCALAR", {0, 1});
  d["animations"][0]["samplers"][0]["output"] = d.accessor<float>("VEC3", {0, 0, 0, 1, 1, 1});
  return d;
}

TEST(Gltf, ARichDocumentCompiles) {
  SceneGraph graph = read(rich_document(), {0.5f, ""});
  EXPECT_EQ(shown(graph).size(), 2u);
  EXPECT_EQ(graph.cameras().size(), 1u);
  EXPECT_EQ(graph.lights().size(), 1u);
  EXPECT_EQ(compile(std::move(graph)).triangle_count(), 2u);
}

TEST(Gltf, SurvivesDamage) {
  const auto read_and_compile = [](const std::string& text) {
    Notes notes;
    compile(read(text, notes, {0.5f, ""}));
  };
  expect_survives_damage(rich_document().text(), 3000, read_and_compile);
  expect_survives_damage(rich_document().glb(), 1000, read_and_compile);
}

std::vector<std::filesystem::path> documents_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(Gltf, SharedDocumentsLoadOrAreRefusedWithAReason) {
  const std::filesystem::path folder = std::filesystem::path(LAMBERT_SHARED_DATA) / "gltf";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: " << folder << " is absent";
  int loaded = 0;
  for (const auto& path : documents_in(folder)) {
    const bool wrong = path.parent_path().filename() == "wrongTypes";
    try {
      Notes notes;
      compile(read_scene(path, {}, notes));
      ++loaded;
    } catch (const Error& e) {
      const std::string why = e.what();
      EXPECT_TRUE(why.starts_with(path.string())) << why;
      EXPECT_TRUE(wrong) << "refused: " << why;
    }
  }
  EXPECT_GT(loaded, 10);
}

}  // namespace
}  // namespace lambert::gltf
