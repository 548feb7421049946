#include "lambert/base/file.h"
#include "lambert/formats/pbrt/camera.h"
#include "lambert/formats/pbrt/directives.h"
#include "lambert/formats/pbrt/lights.h"
#include "lambert/formats/pbrt/materials.h"
#include "lambert/formats/pbrt/pbrt_test_tools.h"
#include "lambert/formats/pbrt/shapes.h"
#include "lambert/formats/pbrt/textures.h"

namespace lambert {
namespace {

std::string guide() {
  return std::string(MappedFile(std::filesystem::path(LAMBERT_SOURCE_DIR) / "docs/guide/scene-format.md").text());
}

TEST(Guide, TheExampleWorks) {
  const std::string text = guide(), fence = "```\n";
  const std::size_t first = text.find(fence) + fence.size();
  const std::string example = text.substr(first, text.find(fence, first) - first);
  Notes notes;
  const SceneGraph graph = read_pbrt(example, "example.pbrt", {}, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(shown(graph).size(), 3u);
  EXPECT_EQ(graph.lights().size(), 1u);
  EXPECT_EQ(graph.cameras().at(0).resolution, Vec2i(320, 240));
}

TEST(Guide, NamesEverythingThatTheReaderKnows) {
  const std::string text = guide();
  std::vector<std::string> words;
  for (const auto& known : {pbrt::shape_types(), pbrt::material_types(), pbrt::light_types(), pbrt::camera_types(),
                            pbrt::texture_classes(), pbrt::ColourSpace::names(), pbrt::parameter_type_names()}) {
    words.insert(words.end(), known.begin(), known.end());
  }
  for (const auto table : {pbrt::transform_directives(), pbrt::setting_directives(), pbrt::world_directives()}) {
    for (const pbrt::Directive& d : table) words.emplace_back(d.name);
  }
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace lambert
