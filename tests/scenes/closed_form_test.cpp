#include "known_scenes.h"

#include "lambert/light/light_test_tools.h"
#include "lambert/render/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace lambert {
namespace {

struct Measurement {
  double mean = 0;
  double standard_error = 0;
};

Measurement measure(const Scene& scene, const Camera& camera, SamplerKind sampler,
                    const std::map<std::string, std::string>& method_settings, int samples) {
  const auto method = make_method("path");
  SettingTable table = method->settings();
  for (const auto& [key, value] : method_settings) table.set(key, value);
  RenderSettings settings{.samples_per_pixel = samples, .sampler = sampler};
  settings.filter.kind = FilterKind::box;
  const RenderResult result = render(scene, camera, *method, settings);
  Measurement m;
  double variance = 0;
  for (int y = 0; y < camera.resolution.y; ++y)
    for (int x = 0; x < camera.resolution.x; ++x) {
      m.mean += static_cast<double>(luminance(result.film.mean({x, y})));
      variance += result.film.variance_of_mean({x, y});
    }
  const double pixels = camera.resolution.x * camera.resolution.y;
  m.mean /= pixels;
  m.standard_error = std::sqrt(variance) / pixels;
  return m;
}

/// Every sampler and camera must give `expected`, within four standard errors of independent samples (the better
/// samplers err less) and a thousandth for rounding.
void expect_radiance(SceneGraph graph, const std::vector<Camera>& cameras, double expected,
                     const std::map<std::string, std::string>& method_settings = {}, int samples = 256) {
  const Scene scene = compile(std::move(graph));
  for (const std::string& sampler : sampler_names())
    for (const Camera& camera : cameras) {
      const Measurement m = measure(scene, camera, sampler_kind(sampler), method_settings, samples);
      EXPECT_NEAR(m.mean, expected, 4 * m.standard_error + 1e-3 * expected) << sampler << ", " << camera.name;
      EXPECT_LT(m.standard_error, 0.05 * expected) << "the test says too little: " << sampler << ", " << camera.name;
    }
}

// rows: PT-23 PT-26 PT-29
TEST(ClosedForm, SphereFromInsideHasRadianceOne) {
  expect_radiance(furnace(0.5f, 0.5f), cameras_at({0, 0, 0}, {0.3f, 0.2f, -1}), 1.0);
}

// rows: PT-26
TEST(ClosedForm, FurnaceOfAlbedoFourFifthsGivesFive) {
  expect_radiance(furnace(0.8f, 1), cameras_at({0, 0, 0.3f}, {0, 0.1f, -1}), 5.0, {}, 112);
}

TEST(ClosedForm, FurnaceWithoutRouletteAgrees) {
  expect_radiance(furnace(0.5f, 0.5f), cameras_at({0, 0, 0}, {1, 0, 0}), 1.0,
                  {{"roulette-depth", "1000"}, {"max-depth", "24"}}, 20);
}

// rows: PT-27
TEST(ClosedForm, PointLightAtTheCentreOfASphere) {
  const float albedo = 0.6f, intensity = 3, radius = 2;
  const double expected = 0.6 / std::numbers::pi * 3 / 4 / 0.4;
  expect_radiance(point_light_in_sphere(albedo, intensity, radius), cameras_at({0.5f, 0, 0}, {0, 0.3f, -1}), expected);
}

/// Cameras that look down on the origin from below the lamps; the panoramic one would see more than that point.
std::vector<Camera> cameras_on_the_floor() {
  auto cameras = cameras_at({0, 0.5f, 0}, {0, 0, 0});
  cameras.pop_back();
  for (Camera& c : cameras)
    if (auto* o = std::get_if<Orthographic>(&c.projection)) o->half_width = o->half_height = 1e-3f;
  return cameras;
}

void expect_irradiance(SceneGraph graph, double irradiance) {
  expect_radiance(std::move(graph), cameras_on_the_floor(), 0.7 / std::numbers::pi * irradiance, {{"max-depth", "1"}});
}

/// Turns +z to -y, then lifts.
Transform facing_down(float height) {
  return Transform::translate({0, height, 0}) * Transform::rotate(degrees(90), {1, 0, 0});
}

// E-PT-10: a unit square lamp of radiance 1 at height 1 gives a facing point the irradiance 0.752276.
// rows: PT-27 PT-28
TEST(ClosedForm, SquareLampOverAFloor) { expect_irradiance(lamp_over_floor(0.7f, 1), 0.752276); }

// E-PT-10: Lambert's formula holds for every polygon, be it tilted, not convex and to one side.
// rows: PT-27
TEST(ClosedForm, PolygonLampOverAFloor) {
  const Transform place = Transform::translate({0.4f, 1.2f, 0.1f}) * Transform::rotate(degrees(15), {0, 0, 1}) *
                          Transform::rotate(degrees(90), {1, 0, 0});
  const std::vector<Vec3> arrow = {
      {-0.5f, -0.5f, 0}, {0.6f, -0.5f, 0}, {0.5f, 0.5f, 0}, {0, -0.1f, 0}, {-0.6f, 0.4f, 0}};
  std::vector<Vec3> world;
  for (const Vec3 p : arrow) world.push_back(place.point(p));
  expect_irradiance(floor_under(0.7f, Shape(Polygon(arrow)), place, 2),
                    2 * lambert_polygon_irradiance(Vec3(0), {0, 1, 0}, world));
}

// E = π L (r/d)² cos θ for a sphere that is wholly above the horizon.
// rows: PT-27
TEST(ClosedForm, SphereLampOverAFloor) {
  const Vec3 centre(0.5f, 1.2f, -0.3f);
  const double d = static_cast<double>(length(centre)), r = 0.4;
  const Shape ball = Sphere{.radius = 0.4f, .z_min = -0.4f, .z_max = 0.4f};
  expect_irradiance(floor_under(0.7f, ball, Transform::translate(centre), 2),
                    std::numbers::pi * 2 * r * r / (d * d) * static_cast<double>(centre.y) / d);
}

// E = π L r² / (r² + h²) below the centre of a disk.
// rows: PT-27
TEST(ClosedForm, DiskLampOverAFloor) {
  expect_irradiance(floor_under(0.7f, Shape(Disk{.radius = 0.5f}), facing_down(1), 2), std::numbers::pi * 2 * 0.2);
}

// rows: PT-29
TEST(ClosedForm, SkyOverAFloor) { expect_irradiance(floor_under_sky(0.7f, 1.5f), std::numbers::pi * 1.5); }

}  // namespace
}  // namespace lambert
