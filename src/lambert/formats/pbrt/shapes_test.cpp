#include "lambert/formats/pbrt/pbrt_test_tools.h"

#include <filesystem>

namespace lambert {
namespace {

template <class S>
S shape_of(const std::string& shape) {
  const SceneGraph graph = read_whole_world(shape);
  return shape_as<S>(graph, shown(graph).at(0).surface);
}
TriangleMesh mesh_of(const std::string& shape) {
  const SceneGraph graph = read_whole_world(shape);
  return geometry_as<TriangleMesh>(graph, shown(graph).at(0).surface);
}

TEST(PbrtShapes, Quadrics) {
  const auto sphere = shape_of<Sphere>("Shape \"sphere\" \"float radius\" 2 \"float zmin\" -1 \"float phimax\" 180");
  EXPECT_EQ(sphere.radius, 2);
  EXPECT_EQ(sphere.z_min, -1);
  EXPECT_EQ(sphere.z_max, 2);
  EXPECT_NEAR(sphere.phi_max, pi, 1e-6f);
  EXPECT_TRUE(shape_of<Sphere>("Shape \"sphere\" \"float radius\" 3").is_full());
  const auto disk = shape_of<Disk>("Shape \"disk\" \"float height\" 1 \"float radius\" 3 \"float innerradius\" .5");
  EXPECT_EQ(disk.height, 1);
  EXPECT_EQ(disk.inner_radius, 0.5f);
  const auto cylinder = shape_of<Cylinder>("Shape \"cylinder\" \"float radius\" 3 \"float zmin\" 2 \"float zmax\" 0");
  EXPECT_EQ(cylinder.z_min, 0);
  EXPECT_EQ(cylinder.z_max, 2);
  EXPECT_FALSE(cylinder.caps);
  EXPECT_TRUE(shape_of<Cylinder>("Shape \"cylinder\" \"bool caps\" true").caps);
}

TEST(PbrtShapes, LambertsOwn) {
  EXPECT_NEAR(shape_of<Polygon>("Shape \"polygon\" \"point3 P\" [ 0 0 0  2 0 0  2 1 0  1 1 0  1 2 0  0 2 0 ]").area(),
              3, 1e-5f);
  const auto cube = shape_of<ConvexPolyhedron>(
      "Shape \"convexpolyhedron\" \"float planes\" [ 2 0 0 2  -1 0 0 1  0 1 0 1  0 -1 0 1  0 0 1 1  0 0 -1 1 ]");
  expect_near(cube.bounds().max, {1, 1, 1});
  EXPECT_NE(error_of([] {
              read_world("Shape \"convexpolyhedron\" \"float planes\" [ 1 0 0 1 ]");
            }).find("s.pbrt:2:1: Shape \"convexpolyhedron\": "),
            std::string::npos);
  EXPECT_NE(error_of([] { read_world("Shape \"polygon\" \"point3 P\" [ 0 0 0 1 0 0 ]"); }).find("s.pbrt:2:1: "),
            std::string::npos);
}

TEST(PbrtShapes, TriangleMesh) {
  const TriangleMesh m = mesh_of(
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"normal N\" [ 0 0 1 0 0 1 0 0 1 ] "
      "\"point2 uv\" [ 0 0 1 0 0 1 ] \"vector3 S\" [ 1 0 0 1 0 0 1 0 0 ]");
  EXPECT_EQ(m.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(m.uvs[1], Vec2(1, 0));
  EXPECT_EQ(m.tangents[0], Vec4(1, 0, 0, 1));
}

TEST(PbrtShapes, NormalsDecideWhichSideIsOutward) {
  const TriangleMesh m =
      mesh_of("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"normal N\" [ 0 0 -1 0 0 -1 0 0 -1 ]");
  EXPECT_EQ(m.triangles, (std::vector<Triangle>{{0, 2, 1}}));
}

TEST(PbrtShapes, ReverseOrientationIsPartOfTheState) {
  const SceneGraph graph = read_whole_world(
      "AttributeBegin ReverseOrientation Shape \"sphere\" ReverseOrientation Shape \"sphere\" AttributeEnd");
  EXPECT_TRUE(shown(graph).at(0).surface.reverse_orientation);
  EXPECT_FALSE(shown(graph).at(1).surface.reverse_orientation);
}

TEST(PbrtShapes, BilinearPatches) {
  const TriangleMesh m =
      mesh_of("Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ] \"integer indices\" [ 0 1 2 3 ]");
  EXPECT_NEAR(m.area(), 1, 1e-6f);
  for (const Triangle& t : m.triangles) {
    const Vec3 n = cross(m.positions[t[1]] - m.positions[t[0]], m.positions[t[2]] - m.positions[t[0]]);
    EXPECT_GT(n.z, 0) << "outward is du x dv";
  }
  Notes notes;
  read_world("Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 1 ]", notes);
  EXPECT_TRUE(has_note(notes, "not planar"));
}

TEST(PbrtShapes, LoopSubdivisionShowsItsCage) {
  Notes notes;
  const SceneGraph graph = read_world(
      "Shape \"loopsubdiv\" \"integer levels\" 2 \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 2 ]",
      notes);
  EXPECT_EQ(geometry_as<TriangleMesh>(graph, shown(graph).at(0).surface).normals.size(), 3u);
  EXPECT_TRUE(has_note(notes, "control mesh"));
}

TEST(PbrtShapes, PlyMeshesAreReadOnceAndShared) {
  const TemporaryFolder folder;
  folder.write("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2\n");
  Notes notes;
  const std::string shape = "Shape \"plymesh\" \"string filename\" \"a.ply\" ";
  const SceneGraph graph = read_world(shape + "Translate 1 0 0 " + shape, notes, "", folder.path());
  EXPECT_EQ(graph.geometry_count(), 1u);
  EXPECT_EQ(shown(graph).size(), 2u);
  EXPECT_NE(error_of([&] {
              read_world("Shape \"plymesh\" \"string filename\" \"b.ply\"", notes, "", folder.path());
            }).find("s.pbrt:2:1: Shape \"plymesh\": "),
            std::string::npos);
}

TEST(PbrtShapes, Errors) {
  const auto message = [](const std::string& shape) { return error_of([&] { read_world(shape); }); };
  EXPECT_EQ(message("Shape \"sphere\" \"float radius\" -1"), "s.pbrt:2:1: Shape \"sphere\": 'radius' must be above 0");
  EXPECT_EQ(message("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 3 ]"),
            "s.pbrt:2:1: Shape \"trianglemesh\": index 3 is out of range: there are 3 points");
  EXPECT_EQ(message("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 ]"),
            "s.pbrt:2:1: Shape \"trianglemesh\": the number of indices must be a multiple of 3, found 2");
  EXPECT_EQ(message("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"point2 uv\" [ 0 0 ]"),
            "s.pbrt:2:1: Shape \"trianglemesh\": 'uv' has 1 values for 3 points");
  EXPECT_NE(message("\n  Shape \"cone\"").find("s.pbrt:3:3: unknown shape 'cone' (known: sphere, disk, cylinder"),
            std::string::npos);
}

}  // namespace
}  // namespace lambert
