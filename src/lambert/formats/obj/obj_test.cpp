#include "lambert/formats/format_test_tools.h"

#include "lambert/base/file.h"

namespace lambert {
namespace {

SceneGraph read(const std::string& text, Notes& notes, const std::filesystem::path& folder = {}) {
  return read_obj(text, "m.obj", folder, notes);
}
SceneGraph read(const std::string& text) {
  Notes notes;
  return read(text, notes);
}
const TriangleMesh& mesh(const SceneGraph& graph, std::size_t i = 0) {
  return geometry_as<TriangleMesh>(graph, shown(graph).at(i).surface);
}
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, PolygonsBecomeTriangles) {
  const SceneGraph graph = read(square + "f 1 2 3 4\n");
  EXPECT_EQ(mesh(graph).triangles.size(), 2u);
  EXPECT_NEAR(mesh(graph).area(), 1, 1e-6f);
  const SceneGraph concave = read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
  EXPECT_EQ(mesh(concave).triangles.size(), 4u);
  EXPECT_NEAR(mesh(concave).area(), 3, 1e-6f);
}

TEST(Obj, IndicesCountFromBothEnds) {
  const SceneGraph graph = read(square + "f -4 -3 -2\nv 5 5 5\nf 1 2 -1\n");
  EXPECT_EQ(mesh(graph).triangles.size(), 2u);
  expect_near(mesh(graph).positions[mesh(graph).triangles[1][2]], {5, 5, 5});
}

TEST(Obj, CornersThatDifferInAnythingAreOwnVertices) {
  const SceneGraph graph = read(square + "vt 0 0.25\nvt 1 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf 1/2/1 3/1/1 4/1/1\n");
  const TriangleMesh& m = mesh(graph);
  EXPECT_EQ(m.positions.size(), 5u);
  EXPECT_EQ(m.normals.size(), 5u);
  EXPECT_EQ(m.uvs[0], Vec2(0, 0.75f)) << "v runs down here";
}

TEST(Obj, AllFormsOfCorners) {
  const SceneGraph graph =
      read(square + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\n");
  ASSERT_EQ(shown(graph).size(), 2u) << "faces with and without normals stand apart";
  EXPECT_EQ(mesh(graph, 0).triangles.size() + mesh(graph, 1).triangles.size(), 4u);
}

TEST(Obj, SmoothingComputesNormals) {
  const std::string roof = "v 0 0 0\nv 1 0 1\nv 2 0 0\nv 0 1 0\nv 1 1 1\nv 2 1 0\n";
  const SceneGraph flat = read(roof + "f 1 2 5 4\nf 2 3 6 5\n");
  EXPECT_TRUE(mesh(flat).normals.empty());
  const SceneGraph smooth = read(roof + "s 1\nf 1 2 5 4\nf 2 3 6 5\n");
  ASSERT_EQ(mesh(smooth).normals.size(), 6u);
  const SceneGraph apart = read(roof + "s 1\nf 1 2 5 4\ns 2\nf 2 3 6 5\n");
  EXPECT_EQ(shown(apart).size(), 2u);
  const SceneGraph off = read(roof + "s 1\ns off\nf 1 2 5 4\n");
  EXPECT_TRUE(mesh(off).normals.empty());
}

TEST(Obj, VertexColours) {
  const SceneGraph graph = read("v 0 0 0\nv 1 0 0 .2 .4 .6\nv 1 1 0 1 0 0\nf 1 2 3\n");
  ASSERT_EQ(mesh(graph).colours.size(), 3u);
  EXPECT_EQ(mesh(graph).colours[0], Vec4(1));
  EXPECT_EQ(mesh(graph).colours[1], Vec4(0.2f, 0.4f, 0.6f, 1));
}

TEST(Obj, GroupsAndMaterialsMakeSurfaces) {
  Notes notes;
  const SceneGraph graph = read(square + "o one\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\no two\nf 1 2 3\n", notes);
  EXPECT_EQ(shown(graph).size(), 3u);
  EXPECT_TRUE(has_note(notes, "the material 'red' is missing"));
}

TEST(Obj, LinesMayBeContinuedAndWindows) {
  const SceneGraph graph = read("v 0 0 0\r\nv 1 0 \\\r\n0\r\nv 1 1 0 # corner\r\nf 1 2 \\\n 3");
  EXPECT_EQ(mesh(graph).positions[1], Vec3(1, 0, 0));
}

TEST(Obj, WhatIsIgnoredIsNoted) {
  Notes notes;
  read(square + "mtllib none.mtl\nl 1 2\nfancy 3\nf 1 2\nf 1 2 3\n", notes);
  for (const char* note : {"'none.mtl' is missing", "'l' is ignored", "unknown statement 'fancy'", "fewer than 3"}) {
    EXPECT_TRUE(has_note(notes, note)) << note;
  }
}

TEST(Obj, ErrorsSayWhere) {
  EXPECT_EQ(error_of([] { read("v 0 0 0\nv 1 x 0\n"); }),
            "m.obj:2:5: expected a coordinate, a finite number, found 'x'");
  EXPECT_EQ(error_of([] { read("v 0 1e999 0\n"); }),
            "m.obj:1:5: expected a coordinate, a finite number, found '1e999'");
  EXPECT_EQ(error_of([] { read("v 0 0\n"); }),
            "m.obj:1:6: expected a coordinate, a finite number, found the end of the line");
  EXPECT_EQ(error_of([] { read(square + "f 1 2 9\n"); }),
            "m.obj:5:7: there is no vertex 9: the file has given 4 so far");
  EXPECT_EQ(error_of([] { read(square + "f 1 2 0\n"); }),
            "m.obj:5:7: there is no vertex 0: the file has given 4 so far");
  EXPECT_EQ(error_of([] { read(square + "f 1/1 2 3\n"); }),
            "m.obj:5:3: there is no texture coordinate 1: the file has given 0 so far");
  EXPECT_EQ(error_of([] { read(square + "f 1 2 x\n"); }), "m.obj:5:7: expected the index of vertex, found 'x'");
  EXPECT_EQ(error_of([] { read(square); }), "m.obj: has no faces");
  EXPECT_NE(error_of([] { read("\x01x 1 2\n"); }).find("m.obj:1:1: '?x' is no OBJ statement"), std::string::npos);
}

TEST(Obj, SurvivesDamage) {
  const std::string sample = square +
                             "vt 0 0\nvt 1 1\nvn 0 0 1\ng a b\nusemtl m\ns 1\nf 1/1/1 2/2/1 3/1/1 4/2/1\n"
                             "f -1 -2 -3\nf 1//1 2//1 3//1\n";
  expect_survives_damage(sample, 1000, [](const std::string& text) { read(text); });
}

TEST(Obj, ReadsFilesOfOtherPrograms) {
  const std::filesystem::path data = LAMBERT_SHARED_DATA;
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "needs " << data;
  int files = 0;
  for (const char* folder : {"scenes/lajolla", "meshes/common-3d-test-models"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data / folder)) {
      if (entry.path().extension() != ".obj") continue;
      Notes notes;
      const SceneGraph graph = read_obj(MappedFile(entry.path()).text(), entry.path().string(), data / folder, notes);
      EXPECT_GT(shown(graph).size(), 0u) << entry.path();
      EXPECT_EQ(notes.counts().size(), 0u) << entry.path();
      ++files;
    }
  }
  EXPECT_GE(files, 10);
}

}  // namespace
}  // namespace lambert
