#include "lambert/material/material.h"
#include "lambert/material/spectrum.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

GltfPbr made(const GltfMaterial& m, const TextureSet& textures = {}, const MaterialContext& context = {}) {
  Material material;
  material.model = m;
  return std::get<GltfPbr>(make_bsdf(material, textures, context).model());
}

TEST(GltfMaterial, DefaultsAreTheSpecifications) {
  const GltfPbr b = made({});
  EXPECT_EQ(b.base_colour, Rgb(1));
  EXPECT_FLOAT_EQ(b.metallic, 1);
  EXPECT_FLOAT_EQ(b.alpha_x, 1);
  EXPECT_FLOAT_EQ(b.ior, 1.5f);
  EXPECT_FLOAT_EQ(b.specular, 1);
  EXPECT_FLOAT_EQ(b.clearcoat + b.iridescence + b.transmission, 0);
  EXPECT_EQ(b.sheen_colour, Rgb());
}

TEST(GltfMaterial, MultipliesFactorTextureAndVertexColour) {
  TextureSet textures;
  GltfMaterial m;
  m.base_colour = {Rgb(0.5f), textures.add(ConstantTexture{{1, 0.5f, 0.5f, 1}})};
  // metallic-roughness: roughness in green, metallic in blue
  const TextureId mr = textures.add(ConstantTexture{{0, 0.5f, 0.25f, 1}});
  m.metallic = {0.8f, mr, 2}, m.roughness = {1, mr, 1};
  MaterialContext context;
  context.vertex_colour = Rgb(1, 1, 0.5f);
  const GltfPbr b = made(m, textures, context);
  EXPECT_EQ(b.base_colour, Rgb(0.5f, 0.25f, 0.125f));
  EXPECT_FLOAT_EQ(b.metallic, 0.2f);
  EXPECT_FLOAT_EQ(b.alpha_x, 0.25f) << "α = roughness²";
}

// KHR_materials_anisotropy: α_t = mix(α, 1, strength²), α_b = α.
TEST(GltfMaterial, AnisotropyStretchesAlongTheTangent) {
  GltfMaterial m;
  m.roughness.value = 0.5f, m.anisotropy = 0.6f;
  EXPECT_FLOAT_EQ(made(m).alpha_x, 0.25f + 0.75f * 0.36f);
  EXPECT_FLOAT_EQ(made(m).alpha_y, 0.25f);
  TextureSet textures;
  m.anisotropy_texture = textures.add(ConstantTexture{{1, 0.5f, 0.5f, 1}});
  EXPECT_FLOAT_EQ(made(m, textures).alpha_x, 0.25f + 0.75f * 0.09f);
}

// KHR_materials_dispersion: V_d = 20 / dispersion.
TEST(GltfMaterial, DispersesByWavelength) {
  GltfMaterial m;
  m.ior = 1.6f, m.dispersion = 0.5f;
  MaterialContext blue;
  blue.wavelength_nm = 450;
  EXPECT_FLOAT_EQ(made(m).ior, 1.6f);
  EXPECT_FLOAT_EQ(made(m, {}, blue).ior, cauchy_eta(1.6f, 40, 450));
}

TEST(GltfMaterial, AnIndexOfZeroReflectsEverything) {
  GltfMaterial m;
  m.ior = 0;
  EXPECT_GT(f0_of_eta(made(m).ior), 0.999f);
}

TEST(GltfMaterial, FilmThicknessRunsFromMinimumToMaximum) {
  TextureSet textures;
  GltfMaterial m;
  m.iridescence.value = 1;
  m.iridescence_thickness_min = 200, m.iridescence_thickness_max = 600;
  EXPECT_FLOAT_EQ(made(m).iridescence_thickness_nm, 600) << "without a texture";
  m.iridescence_thickness = {1, textures.add(ConstantTexture{{0, 0.25f, 0, 1}}), 1};
  EXPECT_FLOAT_EQ(made(m, textures).iridescence_thickness_nm, 300);
}

TEST(GltfMaterial, CarriesItsOtherLayers) {
  GltfMaterial m;
  m.clearcoat.value = 0.7f, m.clearcoat_roughness.value = 0.5f;
  m.sheen_colour.value = Rgb(0.2f), m.sheen_roughness.value = 0.4f;
  m.specular.value = 0.3f, m.specular_colour.value = Rgb(1, 0.5f, 2);
  m.transmission.value = 0.9f, m.thin_walled = false;
  const GltfPbr b = made(m);
  EXPECT_FLOAT_EQ(b.clearcoat, 0.7f);
  EXPECT_FLOAT_EQ(b.clearcoat_alpha, 0.25f);
  EXPECT_EQ(b.sheen_colour, Rgb(0.2f));
  EXPECT_FLOAT_EQ(b.sheen_roughness, 0.4f);
  EXPECT_FLOAT_EQ(b.specular, 0.3f);
  EXPECT_EQ(b.specular_colour, Rgb(1, 0.5f, 2));
  EXPECT_FLOAT_EQ(b.transmission, 0.9f);
  EXPECT_FALSE(b.thin_walled);
}

}  // namespace
}  // namespace lambert
