#include "lambert/formats/write_mesh.h"

#include "lambert/formats/format_test_tools.h"
#include "lambert/formats/read_scene.h"

namespace lambert {
namespace {

TriangleMesh pyramid(bool attributes) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0.1f}, {0, 1, 0}, {0.25f, 1.0f / 3, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  if (attributes) {
    mesh.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0.25f}};
  }
  return mesh;
}

TEST(WriteMesh, OurReadersReadEveryFormatBack) {
  const TemporaryFolder folder;
  for (const bool attributes : {false, true})
    for (const std::string& extension : mesh_extensions()) {
      SCOPED_TRACE(extension);
      const TriangleMesh mesh = pyramid(attributes);
      const auto path = folder.path() / ("m" + extension);
      write_mesh(path, mesh);
      Notes notes;
      const SceneGraph graph = read_scene(path, {}, notes);
      ASSERT_EQ(shown(graph).size(), 1u);
      const auto& back = geometry_as<TriangleMesh>(graph, shown(graph)[0].surface);
      ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
      EXPECT_EQ(back.uvs.empty(), mesh.uvs.empty());
      // OBJ numbers corners in the order of its faces: the corners are compared, not their numbers.
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t a = mesh.triangles[t][k], b = back.triangles[t][k];
          EXPECT_EQ(back.positions[b], mesh.positions[a]);
          if (!attributes) continue;
          expect_near(back.normals[b], mesh.normals[a], 1e-6f);
          EXPECT_NEAR(back.uvs[b].x, mesh.uvs[a].x, 1e-6f);
          EXPECT_NEAR(back.uvs[b].y, mesh.uvs[a].y, 1e-6f);
        }
    }
}

TEST(WriteMesh, ThePathAndWhatIsWrongAreNamed) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] { write_mesh(folder.path() / "m.stl", pyramid(true)); }).find(".ply"), std::string::npos);
  TriangleMesh broken = pyramid(false);
  broken.triangles[0][0] = 9;
  EXPECT_THROW(write_mesh(folder.path() / "m.ply", broken), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(WriteMesh, AnEmptyMeshIsAFileToo) {
  EXPECT_NE(ply_of({}).find("element face 0"), std::string::npos);
  EXPECT_EQ(obj_of({}), "");
  EXPECT_EQ(glb_of({}).find("BIN"), std::string::npos);
}

}  // namespace
}  // namespace lambert
