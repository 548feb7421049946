#include "lambert/material/material.h"

#include "lambert/material/spectrum.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

template <class Model>
Model made(MaterialModel description, const TextureSet& textures = {}, const MaterialContext& context = {}) {
  Material m;
  m.model = std::move(description);
  const Bsdf bsdf = make_bsdf(m, textures, context);
  EXPECT_TRUE(std::holds_alternative<Model>(bsdf.model()));
  return std::get<Model>(bsdf.model());
}

TEST(MakeBsdf, DiffuseTakesConstantTimesTexture) {
  TextureSet textures;
  const TextureId t = textures.add(ConstantTexture{{0.5f, 1, 0.25f, 1}});
  EXPECT_EQ(made<Diffuse>(DiffuseMaterial{{Rgb(0.3f)}}).reflectance, Rgb(0.3f));
  EXPECT_EQ(made<Diffuse>(DiffuseMaterial{{Rgb(0.8f), t}}, textures).reflectance, Rgb(0.4f, 0.8f, 0.2f));
  EXPECT_EQ(made<Diffuse>(DiffuseMaterial{{Rgb(7)}}).reflectance, Rgb(1)) << "no more light than arrives";
}

TEST(MakeBsdf, DiffuseTransmissionConservesEnergy) {
  const auto sheet = made<DiffuseTransmission>(DiffuseTransmissionMaterial{{Rgb(0.9f)}, {Rgb(0.9f)}});
  EXPECT_LE(max_component(sheet.reflectance + sheet.transmittance), 1.00001f);
  EXPECT_EQ(made<DiffuseTransmission>(DiffuseTransmissionMaterial{}).transmittance, Rgb(0.25f));
}

TEST(MakeBsdf, RoughnessIsRemappedBySquareRootWhenAsked) {
  ConductorMaterial m;
  m.roughness = {{0.25f}, {0.04f}, true};
  EXPECT_FLOAT_EQ(made<Conductor>(m).alpha_x, 0.5f);
  EXPECT_FLOAT_EQ(made<Conductor>(m).alpha_y, 0.2f);
  m.roughness.remap = false;
  EXPECT_FLOAT_EQ(made<Conductor>(m).alpha_x, 0.25f);
}

TEST(MakeBsdf, AConductorReflectsAsItIsTold) {
  ConductorMaterial m;
  m.use_reflectance = true;
  m.reflectance.value = Rgb(0.9f, 0.6f, 0.3f);
  const auto conductor = made<Conductor>(m);
  const Rgb f = fresnel_conductor(1, conductor.eta, conductor.k);
  EXPECT_NEAR(f.r, 0.9f, 1e-4f);
  EXPECT_NEAR(f.g, 0.6f, 1e-4f);
  EXPECT_NEAR(f.b, 0.3f, 1e-4f);
}

TEST(MakeBsdf, ACoatedMetalMeetsItsCoatNotAir) {
  CoatedConductorMaterial m;
  m.interface_eta = 1.5f;
  m.conductor.eta.value = Rgb(0.3f), m.conductor.k.value = Rgb(3);
  m.conductor.roughness = {{0.3f}, {0.3f}, false};
  const auto coated = made<CoatedConductor>(m);
  EXPECT_FLOAT_EQ(coated.metal.eta.g, 0.2f);
  EXPECT_FLOAT_EQ(coated.metal.k.g, 2);
  EXPECT_FLOAT_EQ(coated.metal.alpha_x, 0.3f);
}

TEST(MakeBsdf, ACoatedDiffuseReflectsBaseAndCoat) {
  CoatedDiffuseMaterial m;
  m.reflectance.value = Rgb(0);
  const Rgb coat = made<CoatedDiffuse>(m).albedo({0, 0, 1});
  EXPECT_NEAR(coat.g, 0.04f, 0.01f) << "Fresnel's reflection at normal incidence";
  m.reflectance.value = Rgb(0.8f, 0.2f, 0.2f);
  EXPECT_GT(made<CoatedDiffuse>(m).albedo({0, 0, 1}).r, 0.5f);
}

TEST(MakeBsdf, GlassDispersesByWavelength) {
  DielectricMaterial glass;
  glass.eta = 1.7f, glass.abbe_number = 30;
  MaterialContext blue, red;
  blue.wavelength_nm = 450, red.wavelength_nm = 650;
  EXPECT_FLOAT_EQ(made<Dielectric>(glass).eta, 1.7f);
  EXPECT_FLOAT_EQ(made<Dielectric>(glass, {}, blue).eta, cauchy_eta(1.7f, 30, 450));
  EXPECT_GT(made<Dielectric>(glass, {}, blue).eta, made<Dielectric>(glass, {}, red).eta);
  glass.thin = true;
  EXPECT_FLOAT_EQ(made<ThinDielectric>(glass, {}, blue).eta, 1.7f);
}

TEST(IsDispersive, OnlyWhereLightIsRefracted) {
  Material m;
  EXPECT_FALSE(is_dispersive(m));
  DielectricMaterial glass;
  m.model = glass;
  EXPECT_FALSE(is_dispersive(m));
  glass.abbe_number = 40;
  m.model = glass;
  EXPECT_TRUE(is_dispersive(m));
  glass.thin = true;
  m.model = glass;
  EXPECT_FALSE(is_dispersive(m));

  GltfMaterial gltf;
  gltf.dispersion = 0.5f, gltf.transmission.value = 1, gltf.thin_walled = false;
  m.model = gltf;
  EXPECT_TRUE(is_dispersive(m));
  gltf.thin_walled = true;
  m.model = gltf;
  EXPECT_FALSE(is_dispersive(m));
}

}  // namespace
}  // namespace lambert
