#include "lambert/formats/pbrt/pbrt_test_tools.h"

namespace lambert {
namespace {

TEST(PbrtDirectives, ObjectsAreInstancedWithBothTransformations) {
  const SceneGraph graph = read_whole_world(
      "ObjectBegin \"pair\" Translate 0 1 0 Shape \"sphere\" Identity Shape \"disk\" ObjectEnd\n"
      "Translate 5 0 0 ObjectInstance \"pair\" Scale 2 2 2 ObjectInstance \"pair\" Shape \"sphere\"");
  const std::vector<Shown> all = shown(graph);
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(graph.geometry_count(), 3u) << "instances share their geometry";
  std::vector<Vec3> spheres;
  for (const Shown& s : all) {
    if (std::holds_alternative<Sphere>(geometry_as<Shape>(graph, s.surface))) {
      spheres.push_back(graph.world_transform(s.node).point(Vec3(0)));
    }
  }
  ASSERT_EQ(spheres.size(), 3u);
  expect_near(spheres[0], {5, 1, 0});
  expect_near(spheres[1], {5, 2, 0});
  expect_near(spheres[2], {5, 0, 0});
}

TEST(PbrtDirectives, ObjectsKeepTheStateOutside) {
  const SceneGraph graph = read_whole_world(
      "ObjectBegin \"o\" Material \"conductor\" Translate 1 1 1 Shape \"sphere\" ObjectEnd Shape \"sphere\"");
  ASSERT_EQ(shown(graph).size(), 1u) << "objects show only where they are instanced";
  EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(first_material(graph).model));
  expect_near(graph.world_transform(shown(graph).at(0).node).point(Vec3(0)), {0, 0, 0});
}

TEST(PbrtDirectives, ObjectErrors) {
  const auto message = [](const std::string& world) { return error_of([&] { read_world(world); }); };
  EXPECT_EQ(message("ObjectInstance \"x\""), "s.pbrt:2:1: unknown object 'x'");
  EXPECT_EQ(message("ObjectBegin \"x\" ObjectInstance \"x\""),
            "s.pbrt:2:17: ObjectInstance cannot stand within an object");
  EXPECT_EQ(message("ObjectBegin \"x\" ObjectBegin \"y\""), "s.pbrt:2:17: ObjectBegin within an object");
  EXPECT_EQ(message("ObjectEnd"), "s.pbrt:2:1: ObjectEnd without ObjectBegin");
  EXPECT_EQ(message("AttributeBegin ObjectBegin \"x\" AttributeEnd"),
            "s.pbrt:2:32: AttributeEnd without AttributeBegin");
  EXPECT_EQ(message("ObjectBegin \"x\" AttributeBegin ObjectEnd"), "s.pbrt:2:32: ObjectEnd before AttributeEnd");
  EXPECT_EQ(message("ObjectBegin \"x\"\n"), "s.pbrt:3:1: the file ends before ObjectEnd of 'x'");
  EXPECT_EQ(message("AttributeBegin"), "s.pbrt:2:15: the file ends before AttributeEnd");
}

TEST(PbrtDirectives, OrderAroundWorldBegin) {
  Notes notes;
  const auto message = [&](const std::string& text) { return error_of([&] { read_pbrt(text, "s.pbrt", {}, notes); }); };
  EXPECT_EQ(message("Shape \"sphere\""), "s.pbrt:1:1: Shape must stand behind WorldBegin");
  EXPECT_EQ(message("WorldBegin\n Camera \"perspective\""), "s.pbrt:2:2: Camera must stand before WorldBegin");
  EXPECT_EQ(message(""), "s.pbrt:1:1: the file ends without WorldBegin");
  EXPECT_EQ(message("WorldBegin Shpae \"sphere\"").substr(0, 70),
            "s.pbrt:1:12: unknown directive 'Shpae'; did you mean 'Shape'? (known: ");
  EXPECT_EQ(message("\"WorldBegin\""), "s.pbrt:1:1: expected a directive, found \"WorldBegin\"");
  EXPECT_EQ(message("WorldBegin Shape sphere"),
            "s.pbrt:1:18: expected the type of the shape in quotes, found 'sphere'");
  EXPECT_EQ(message("WorldBegin Shape"),
            "s.pbrt:1:17: expected the type of the shape in quotes, found the end of the file");
}

TEST(PbrtDirectives, MediaAreNoted) {
  Notes notes;
  read_world("MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" MediumInterface \"fog\" \"\" Shape \"sphere\"",
             notes);
  EXPECT_TRUE(has_note(notes, "participating media"));
  Notes none;
  read_world("MediumInterface \"\" \"\" Shape \"sphere\"", none);
  EXPECT_TRUE(none.empty());
}

TEST(PbrtInclude, SharesTheStateAndNamesTheFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  folder.write("sub/part.pbrt", "Translate 1 0 0\n Include \"leaf.pbrt\"\n");
  folder.write("leaf.pbrt", "Shape \"sphere\"");
  folder.write("bad.pbrt", "\n  Shpae \"sphere\"");
  Notes notes;
  const SceneGraph graph = read_world("Include \"sub/part.pbrt\" Shape \"sphere\"", notes, "", folder.path());
  ASSERT_EQ(shown(graph).size(), 2u);
  for (const Shown& s : shown(graph)) expect_near(graph.world_transform(s.node).point(Vec3(0)), {1, 0, 0});
  EXPECT_NE(error_of([&] {
              read_world("Include \"bad.pbrt\"", notes, "", folder.path());
            }).find("bad.pbrt:2:3: unknown directive 'Shpae'"),
            std::string::npos);
  EXPECT_NE(error_of([&] { read_world(" Include \"none.pbrt\"", notes, "", folder.path()); }).find("s.pbrt:2:2: "),
            std::string::npos);
}

TEST(PbrtInclude, ImportLeavesTheStateAlone) {
  const TemporaryFolder folder;
  folder.write("part.pbrt", "Translate 1 0 0 MakeNamedMaterial \"m\" \"string type\" \"diffuse\" Shape \"sphere\"");
  Notes notes;
  const SceneGraph graph =
      read_world("Import \"part.pbrt\" NamedMaterial \"m\" Shape \"sphere\"", notes, "", folder.path());
  ASSERT_EQ(shown(graph).size(), 2u);
  expect_near(graph.world_transform(shown(graph)[1].node).point(Vec3(0)), {0, 0, 0});
}

TEST(PbrtInclude, CyclesAreRefused) {
  const TemporaryFolder folder;
  folder.write("a.pbrt", "Include \"b.pbrt\"");
  folder.write("b.pbrt", "\nInclude \"a.pbrt\"");
  Notes notes;
  const std::string message = error_of([&] { read_world("Include \"a.pbrt\"", notes, "", folder.path()); });
  EXPECT_NE(message.find("b.pbrt:2:1: 'a.pbrt' includes itself"), std::string::npos) << message;
}

TEST(PbrtInclude, DepthIsLimited) {
  const TemporaryFolder folder;
  for (int i = 0; i < 70; ++i) {
    folder.write(std::to_string(i) + ".pbrt", "Include \"" + std::to_string(i + 1) + ".pbrt\"");
  }
  Notes notes;
  EXPECT_NE(error_of([&] { read_world("Include \"0.pbrt\"", notes, "", folder.path()); }).find("too many files"),
            std::string::npos);
}

}  // namespace
}  // namespace lambert
