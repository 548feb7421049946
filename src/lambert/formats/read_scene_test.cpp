#include "lambert/formats/read_scene.h"
#include "lambert/formats/format_test_tools.h"

namespace lambert {
namespace {

const std::string triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2\n";

SceneGraph read(const std::filesystem::path& path) {
  Notes notes;
  return read_scene(path, {}, notes);
}

TEST(ReadScene, ChoosesByExtension) {
  const TemporaryFolder folder;
  EXPECT_EQ(shown(read(folder.write("a.PLY", triangle_ply))).size(), 1u);
  EXPECT_EQ(shown(read(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"))).size(), 1u);
  EXPECT_EQ(shown(read(folder.write("a.pbrt", "WorldBegin Shape \"plymesh\" \"string filename\" \"a.PLY\""))).size(),
            1u);
}

TEST(ReadScene, PlyIsGreyAndNamed) {
  const TemporaryFolder folder;
  const SceneGraph graph = read(folder.write("a.ply", triangle_ply));
  EXPECT_EQ(graph.name, "a.ply");
  EXPECT_EQ(std::get<DiffuseMaterial>(first_material(graph).model).reflectance.value, Rgb(0.5f));
}

TEST(ReadScene, Errors) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] {
              read(folder.write("a.blend", "x"));
            }).find("a.blend: unknown kind of scene '.blend' (known: .gltf"),
            std::string::npos);
  EXPECT_NE(error_of([&] { read(folder.path() / "none.obj"); }).find("none.obj: cannot open"), std::string::npos);
  EXPECT_NE(error_of([&] { read(folder.write("empty.obj", "")); }).find("empty.obj: has no faces"), std::string::npos);
  EXPECT_NE(error_of([&] { read(folder.write("empty.ply", "")); }).find("empty.ply:1:1: "), std::string::npos);
  std::filesystem::create_directory(folder.path() / "folder.ply");
  EXPECT_NE(error_of([&] { read(folder.path() / "folder.ply"); }).find("not a regular file"), std::string::npos);
}

TEST(ReadScene, VariantsAreOfGltfOnly) {
  const TemporaryFolder folder;
  Notes notes;
  read_scene(folder.write("a.ply", triangle_ply), {0, "gold"}, notes);
  EXPECT_TRUE(has_note(notes, "--variant is ignored"));
  Notes none;
  read_scene(folder.write("a.ply", triangle_ply), {}, none);
  EXPECT_FALSE(has_note(none, "--variant"));
}

TEST(ReadScene, ErrorsOfTheSceneGraphNameTheFile) {
  const TemporaryFolder folder;
  const auto path = folder.write("far.pbrt", "WorldBegin\nScale 1e30 1 1\nScale 1e30 1 1\nShape \"sphere\"");
  EXPECT_NE(error_of([&] { read(path); }).find("far.pbrt"), std::string::npos);
}

}  // namespace
}  // namespace lambert
