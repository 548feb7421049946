#include "lambert/formats/pbrt/pbrt_test_tools.h"

#include <cmath>

namespace lambert {
namespace {

Camera read_camera(const std::string& settings, Notes& notes) {
  const SceneGraph graph = read_world("", notes, settings);
  EXPECT_EQ(graph.cameras().size(), 1u);
  return graph.cameras().at(0);
}
Camera read_camera(const std::string& settings) {
  Notes notes;
  return read_camera(settings, notes);
}
const std::string wide_film = "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100 ";

TEST(PbrtCamera, FovIsThatOfTheShorterAxis) {
  const auto wide =
      std::get<Perspective>(read_camera(wide_film + "Camera \"perspective\" \"float fov\" 90").projection);
  EXPECT_NEAR(wide.half_height, 1, 1e-6f);
  EXPECT_NEAR(wide.half_width, 2, 1e-6f);
  const auto tall = std::get<Perspective>(
      read_camera("Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 200 Camera \"perspective\"")
          .projection);
  EXPECT_NEAR(tall.half_width, 1, 1e-6f);
  EXPECT_NEAR(tall.half_height, 2, 1e-6f);
}

TEST(PbrtCamera, LooksAlongPlusZWithXToTheRight) {
  const Camera c = read_camera("LookAt 0 0 -5  0 0 0  0 1 0 " + wide_film + "Camera \"perspective\" \"float fov\" 90");
  const Ray middle = c.ray(Vec2(100, 50)).ray;
  expect_near(middle.origin, {0, 0, -5});
  expect_near(middle.direction, {0, 0, 1});
  // The image's right edge lies towards +x although the world is right-handed for everyone else: pbrt's pictures are
  // those of a left-handed camera.
  const Ray right = c.ray(Vec2(200, 50)).ray;
  EXPECT_NEAR(right.direction.x / right.direction.z, 2, 1e-5f);
  const Ray top = c.ray(Vec2(100, 0)).ray;
  EXPECT_NEAR(top.direction.y / top.direction.z, 1, 1e-5f);
}

TEST(PbrtCamera, ScreenWindowAndLens) {
  const Camera c = read_camera(wide_film +
                               "Camera \"perspective\" \"float fov\" 90 \"float screenwindow\" [ 0 2 -1 0 ] "
                               "\"float lensradius\" 0.1 \"float focaldistance\" 3");
  const auto p = std::get<Perspective>(c.projection);
  EXPECT_NEAR(p.half_width, 1, 1e-6f);
  EXPECT_NEAR(p.half_height, 0.5f, 1e-6f);
  EXPECT_NEAR(p.centre.x, 1, 1e-6f);
  EXPECT_NEAR(p.centre.y, -0.5f, 1e-6f);
  EXPECT_EQ(p.lens_radius, 0.1f);
  EXPECT_EQ(p.focal_distance, 3);
}

TEST(PbrtCamera, Orthographic) {
  const Camera c = read_camera(wide_film + "Camera \"orthographic\" \"float screenwindow\" [ -4 4 -2 2 ]");
  const Ray corner = c.ray(Vec2(200, 0)).ray;
  expect_near(corner.origin, {4, 2, 0});
  expect_near(corner.direction, {0, 0, 1});
}

// pbrt's equirectangular camera sees (cos φ sin θ, cos θ, sin φ sin θ) with φ = 2π u, θ = π v.
TEST(PbrtCamera, SphericalDirections) {
  const Camera c = read_camera(wide_film + "Camera \"spherical\" \"string mapping\" \"equirectangular\"");
  for (const Vec2 uv : {Vec2(0.1f, 0.5f), Vec2(0.5f, 0.5f), Vec2(0.75f, 0.3f)}) {
    const float phi = 2 * pi * uv.x, theta = pi * uv.y;
    const Vec3 expected(std::cos(phi) * std::sin(theta), std::cos(theta), std::sin(phi) * std::sin(theta));
    expect_near(c.ray(Vec2(200 * uv.x, 100 * uv.y)).ray.direction, expected, 1e-4f);
  }
}

TEST(PbrtCamera, NotesAndErrors) {
  Notes notes;
  read_camera(wide_film + "Camera \"spherical\"", notes);
  EXPECT_TRUE(has_note(notes, "equalarea"));
  read_camera("Camera \"perspective\" \"float halffov\" 3", notes);
  EXPECT_TRUE(has_note(notes, "s.pbrt:1:22: unused parameter 'halffov' of Camera \"perspective\""));
  EXPECT_EQ(error_of([] { read_camera("Camera \"realistic\""); }),
            "s.pbrt:1:1: unknown camera 'realistic' (known: perspective, orthographic, spherical)");
  EXPECT_EQ(error_of([] { read_camera("Camera \"perspective\" \"float fov\" 180"); }),
            "s.pbrt:1:1: Camera \"perspective\": 'fov' must lie between 0 and 180 degrees");
}

TEST(PbrtCamera, NoneIsLeftToTheFraming) {
  Notes notes;
  EXPECT_TRUE(read_world("", notes).cameras().empty());
}

}  // namespace
}  // namespace lambert
