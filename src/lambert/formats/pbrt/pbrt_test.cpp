#include "lambert/formats/pbrt/pbrt_test_tools.h"

#include "lambert/base/file.h"

#include <chrono>

namespace lambert {
namespace {

const std::filesystem::path data = LAMBERT_SHARED_DATA;

SceneGraph read_file(const std::filesystem::path& path, Notes& notes) {
  return read_pbrt(MappedFile(path).text(), path.string(), path.parent_path(), notes);
}

TEST(Pbrt, CornellBox) {
  const auto path = data / "scenes/bitterli-pbrt4/cornell-box/scene-v4.pbrt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs " << path;
  Notes notes;
  const SceneGraph graph = read_file(path, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(shown(graph).size(), 8u);
  EXPECT_EQ(graph.materials.size(), 8u);
  std::size_t triangles = 0, lights = 0;
  for (const Shown& s : shown(graph)) {
    triangles += geometry_as<TriangleMesh>(graph, s.surface).triangles.size();
    if (!s.surface.emission) continue;
    ++lights;
    EXPECT_EQ(s.surface.emission->radiance.value, Rgb(17, 12, 4));
    const TriangleMesh& lamp = geometry_as<TriangleMesh>(graph, s.surface);
    const Triangle t = lamp.triangles[0];
    EXPECT_LT(cross(lamp.positions[t[1]] - lamp.positions[t[0]], lamp.positions[t[2]] - lamp.positions[t[0]]).y, 0)
        << "the lamp shines down";
  }
  EXPECT_EQ(triangles, 36u);
  EXPECT_EQ(lights, 1u);
  const Camera& camera = graph.cameras().at(0);
  EXPECT_EQ(camera.resolution, Vec2i(1024, 1024));
  const Ray middle = camera.ray(Vec2(512, 512)).ray;
  expect_near(middle.origin, {0, 1, 6.8f}, 1e-4f);
  expect_near(middle.direction, {0, 0, -1}, 1e-4f);
  EXPECT_GT(camera.ray(Vec2(1024, 512)).ray.direction.x, 0) << "the green wall, at +x, stands on the right";
  EXPECT_EQ(graph.settings.samples_per_pixel, 64);
  EXPECT_EQ(graph.settings.max_depth, 65);
}

TEST(Pbrt, VeachMis) {
  const auto path = data / "scenes/bitterli-pbrt4/veach-mis/scene-v4.pbrt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs " << path;
  Notes notes;
  const SceneGraph graph = read_file(path, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(shown(graph).size(), 9u);
  EXPECT_EQ(graph.materials.size(), 6u);
  std::size_t spheres = 0;
  for (const Shown& s : shown(graph)) {
    if (std::holds_alternative<TriangleMesh>(graph.geometry(s.surface.geometry))) continue;
    ++spheres;
    EXPECT_TRUE(s.surface.emission);
    EXPECT_NEAR(graph.world_transform(s.node).point(Vec3(0)).y, 6.5f, 1e-5f);
  }
  EXPECT_EQ(spheres, 3u);
  EXPECT_EQ(graph.cameras().at(0).resolution, Vec2i(1280, 720));
}

TEST(Pbrt, OldSyntaxIsRefusedWithAdvice) {
  const auto path = data / "scenes/pbrt-v2/killeroo-simple.pbrt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs " << path;
  Notes notes;
  const std::string message = error_of([&] { read_file(path, notes); });
  EXPECT_NE(message.find("killeroo-simple.pbrt:5:1: unknown film 'image'"), std::string::npos) << message;
  EXPECT_NE(message.find("pbrt-v2 or v3"), std::string::npos) << message;
}

TEST(Pbrt, OldDirectivesAreExplained) {
  for (const char* word :
       {"SurfaceIntegrator", "VolumeIntegrator", "Renderer", "WorldEnd", "TransformBegin", "TransformEnd"}) {
    Notes notes;
    const std::string message = error_of([&] { read_pbrt("\n " + std::string(word), "s.pbrt", {}, notes); });
    EXPECT_EQ(message.find("s.pbrt:2:2: '" + std::string(word) + "' is the syntax of pbrt-v2 or v3"), 0u) << message;
  }
}

TEST(Pbrt, LongArraysParseFast) {
  std::string text = "WorldBegin Shape \"trianglemesh\" \"point3 P\" [";
  for (int i = 0; i < 300000; ++i) text += " 0.12345678 -12.5 1e-3\n";
  text += "] \"integer indices\" [ 0 1 2 ]";
  Notes notes;
  const auto start = std::chrono::steady_clock::now();
  read_pbrt(text, "s.pbrt", {}, notes);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", std::to_string(elapsed.count()));
#ifdef NDEBUG
  EXPECT_LT(elapsed.count(), 1.0) << "usually a twentieth of this";
#endif
}

const std::string sample = R"(LookAt 0 0 -5  0 0 0  0 1 0
Camera "perspective" "float fov" 40 Film "rgb" "integer xresolution" [ 40 ] "string filename" "a.png"
Sampler "zsobol" "integer pixelsamples" 4 Integrator "volpath" "integer maxdepth" 3 PixelFilter "gaussian"
WorldBegin # the world
Attribute "shape" "float alpha" 1
Texture "c" "spectrum" "checkerboard" "rgb tex1" [ 1 0 0 ] "float uscale" 2
MakeNamedMaterial "m" "string type" "diffuse" "texture reflectance" "c"
AttributeBegin
  AreaLightSource "diffuse" "blackbody L" 5000 "bool twosided" true
  Translate 0 1 0 Rotate 30 0 1 0 ReverseOrientation
  Shape "disk" "float radius" 2
AttributeEnd
LightSource "infinite" "rgb L" [ .1 .2 .3 ] "float scale" 2
NamedMaterial "m"
ObjectBegin "o" Shape "sphere" Material "conductor" "spectrum eta" "metal-Au-eta" Shape "cylinder" ObjectEnd
Transform [ 1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1 ]
ObjectInstance "o"
Shape "trianglemesh" "point3 P" [ 0 0 0 1 0 0 0 1 0 ] "integer indices" [ 0 1 2 ] "normal N" [ 0 0 1 0 0 1 0 0 1 ]
Shape "polygon" "point3 P" [ 0 0 0 1 0 0 1 1 0 ]
)";

TEST(Pbrt, SurvivesDamage) {
  Notes notes;
  EXPECT_EQ(shown(read_pbrt(sample, "s.pbrt", {}, notes)).size(), 5u);
  expect_survives_damage(sample, 1500, [](const std::string& text) {
    Notes ignored;
    read_pbrt(text, "s.pbrt", {}, ignored);
  });
}

}  // namespace
}  // namespace lambert
