#include "known_scenes.h"

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
  expect_radiance(furnace(0.8f, 1), cameras_at({0, 0, 0.3f}, {0, 0.1f, -1}), 5.0);
}

TEST(ClosedForm, FurnaceWithoutRouletteAgrees) {
  expect_radiance(furnace(0.5f, 0.5f), cameras_at({0, 0, 0}, {1, 0, 0}), 1.0,
                  {{"roulette-depth", "1000"}, {"max-depth", "24"}}, 64);
}

// rows: PT-27
TEST(ClosedForm, PointLightAtTheCentreOfASphere) {
  const float albedo = 0.6f, intensity = 3, radius = 2;
  const double expected = 0.6 / std::numbers::pi * 3 / 4 / 0.4;
  expect_radiance(point_light_in_sphere(albedo, intensity, radius), cameras_at({0.5f, 0, 0}, {0, 0.3f, -1}), expected);
}

// E-PT-10: a unit square lamp of radiance 1 at height 1 gives a facing point the irradiance 0.752276.
// rows: PT-27 PT-28
TEST(ClosedForm, SquareLampOverAFloor) {
  auto cameras = cameras_at({0, 0.5f, 0}, {0, 0, 0});
  cameras.pop_back();  // the panoramic camera sees more than the point below
  for (Camera& c : cameras)
    if (auto* o = std::get_if<Orthographic>(&c.projection)) o->half_width = o->half_height = 1e-3f;
  expect_radiance(lamp_over_floor(0.7f, 1), cameras, 0.7 / std::numbers::pi * 0.752276, {{"max-depth", "1"}});
}

}  // namespace
}  // namespace lambert
