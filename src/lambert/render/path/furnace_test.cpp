/// Bodies that absorb nothing vanish in a uniform environment; others never shine brighter than it.

#include "lambert/render/path/path_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

Roughness roughness(float alpha) { return {.u = {alpha}, .v = {alpha}, .remap = false}; }

void expect_invisible(const Material& material, const char* what, double tolerance = 1e-3) {
  for (const Geometry& body : {Geometry(Shape(Sphere{})), Geometry(box(Vec3(-0.8f), Vec3(0.8f)))}) {
    const Transform turn = Transform::rotate(degrees(30), normalize(Vec3(1, 2, 0.5f)));
    const SeenMean seen = path_mean(in_white(body, material, turn), facing_camera());
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(static_cast<double>(seen.mean[c]), 1, tolerance + 4 * seen.standard_error) << what;
    EXPECT_LT(seen.standard_error, 0.02) << "the test says too little: " << what;
  }
}

TEST(Furnace, LosslessBodiesAreInvisible) {
  expect_invisible({.model = DiffuseMaterial{RgbParameter{Rgb(1)}}}, "white");
  expect_invisible({.model = DiffuseTransmissionMaterial{{Rgb(0.3f)}, {Rgb(0.7f)}}}, "leaf");
  expect_invisible({.model = ConductorMaterial{.reflectance = {Rgb(1)}, .use_reflectance = true}}, "mirror");
  expect_invisible({.model = DielectricMaterial{.eta = 1.5f}}, "glass");
  expect_invisible({.model = DielectricMaterial{.eta = 2.4f}}, "diamond");
  expect_invisible({.model = DielectricMaterial{.eta = 0.7f}}, "bubble");
  expect_invisible({.model = DielectricMaterial{.eta = 1.5f, .thin = true}}, "pane");
}

// Microfacet models of single scattering lose more the rougher they are, and never gain.
TEST(Furnace, RoughBodiesNeverShine) {
  const auto share = [](MaterialModel model) {
    const SeenMean seen = path_mean(in_white(Shape(Sphere{}), {.model = std::move(model)}), facing_camera(), {}, 32);
    EXPECT_LT(seen.standard_error, 0.02);
    const double y = static_cast<double>(luminance(seen.mean));
    EXPECT_LT(y, 1 + 4 * seen.standard_error + 1e-3);
    return y;
  };
  const ConductorMaterial mirror{.reflectance = {Rgb(1)}, .use_reflectance = true};
  double metal = 1, glass = 1;
  for (const float alpha : {0.02f, 0.1f, 0.3f, 0.5f, 1.0f}) {
    ConductorMaterial rough = mirror;
    rough.roughness = roughness(alpha);
    const double new_metal = share(rough), new_glass = share(DielectricMaterial{.roughness = roughness(alpha)});
    EXPECT_LT(new_metal, metal + 0.01) << alpha;
    EXPECT_LT(new_glass, glass + 0.01) << alpha;
    EXPECT_GT(std::min(new_metal, new_glass), 0.25) << alpha;
    metal = new_metal, glass = new_glass;
    EXPECT_GT(share(CoatedDiffuseMaterial{.reflectance = {Rgb(1)}, .roughness = roughness(alpha)}), 0.6) << alpha;
    EXPECT_GT(share(CoatedConductorMaterial{.interface_roughness = roughness(alpha), .conductor = mirror}), 0.25)
        << alpha;
  }
}

// GGX with alpha = 1 has D = 1/pi and, seen along the normal, G2 = 2 c / (1 + c) for light at cosine c: the albedo is
// the integral of c / (1 + c) over [0, 1], which is 1 - ln 2.
TEST(Furnace, AFlatMetalOfAlphaOneSeenFromAbove) {
  const ConductorMaterial metal{.reflectance = {Rgb(1)}, .use_reflectance = true, .roughness = roughness(1)};
  const SeenMean seen = path_mean(in_white(Shape(Disk{}), {.model = metal}), facing_camera(1e-3f), {}, 1024);
  EXPECT_NEAR(static_cast<double>(seen.mean.g), 1 - std::log(2.0), 4 * seen.standard_error + 2e-3);
  EXPECT_LT(seen.standard_error, 2e-3);
}

TEST(Furnace, GltfNeverShines) {
  for (const float r : {0.0f, 0.3f, 0.7f, 1.0f}) {
    GltfMaterial plain{.metallic = {0}, .roughness = {r}}, metal{.roughness = {r}};
    GltfMaterial coated = plain, cloth = plain, glass = plain, film = plain;
    coated.clearcoat = {1};
    cloth.sheen_colour = {Rgb(1)}, cloth.sheen_roughness = {0.5f};
    glass.transmission = {1}, glass.thin_walled = false;
    film.iridescence = {1};
    for (const GltfMaterial& m : {plain, metal, coated, cloth, glass, film}) {
      const SeenMean seen = path_mean(in_white(Shape(Sphere{}), {.model = m}), facing_camera());
      const double y = static_cast<double>(luminance(seen.mean));
      EXPECT_LT(y, 1.005 + 4 * seen.standard_error);
      EXPECT_GT(y, 0.3);
    }
  }
}

// Wavelengths are drawn so that their colours average to white.
TEST(Furnace, DispersionAveragesToWhite) {
  const SeenMean seen =
      path_mean(in_white(Shape(Sphere{}), {.model = DielectricMaterial{.eta = 1.6f, .abbe_number = 20}}),
                facing_camera(), {}, 512);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen.mean[c], 1, 0.03f) << "channel " << c;
}

TEST(Furnace, RouletteAndDepthKeepTheMean) {
  const Scene scene =
      in_white(Geometry(torus(0.5f, 0.2f, 16, 12)), {.model = DiffuseMaterial{RgbParameter{Rgb(0.7f)}}});
  const MethodWords eager = {{"roulette-depth", "0"}, {"roulette-threshold", "1"}};
  const SeenMean often = path_mean(scene, facing_camera(), eager, 256);
  const SeenMean never = path_mean(scene, facing_camera(), {{"roulette-depth", "1000"}, {"max-depth", "60"}}, 256);
  const auto result = statistics::z_test(static_cast<double>(luminance(often.mean) - luminance(never.mean)),
                                         std::hypot(often.standard_error, never.standard_error), 0);
  EXPECT_TRUE(result) << result.message;
  EXPECT_LT(often.standard_error, 0.01);
}

}  // namespace
}  // namespace lambert
