#include "lambert/formats/gltf/materials.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

TestDocument with_material(std::string_view material) {
  TestDocument d = triangle_document();
  d.set("materials", "[" + std::string(material) + "]");
  primitive(d)["material"] = 0;
  return d;
}
Material material(std::string_view json) {
  const SceneGraph graph = read(with_material(json));
  return first_material(graph);
}
GltfMaterial model(std::string_view json) { return std::get<GltfMaterial>(material(json).model); }
/// Of a material with one extension.
GltfMaterial extended(const std::string& extension, const std::string& content) {
  return model(R"({"extensions": {")" + extension + "\": " + content + "}}");
}
std::optional<Emission> emission(std::string_view json) {
  const SceneGraph graph = read(with_material(json));
  return shown(graph).at(0).surface.emission;
}

TEST(GltfMaterials, DefaultsAreTheSpecifications) {
  const GltfMaterial m = model("{}");
  EXPECT_EQ(m.base_colour.value, Rgb(1.0f));
  EXPECT_EQ(m.metallic.value, 1);
  EXPECT_EQ(m.roughness.value, 1);
  EXPECT_EQ(m.ior, 1.5f);
  EXPECT_EQ(m.specular.value, 1);
  EXPECT_EQ(m.clearcoat.value, 0);
  EXPECT_EQ(m.transmission.value, 0);
  EXPECT_EQ(m.iridescence.value, 0);
  EXPECT_FALSE(material("{}").double_sided);
  EXPECT_FALSE(emission("{}"));
  const SceneGraph without = read(triangle_document());
  EXPECT_EQ(first_material(without).name, "glTF default");
}

TEST(GltfMaterials, FactorsAreLimited) {
  const GltfMaterial m = model(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 2, -1, 1], "metallicFactor": 0.25,
      "roughnessFactor": 7}})");
  EXPECT_EQ(m.base_colour.value, Rgb(0.5f, 1, 0));
  EXPECT_EQ(m.metallic.value, 0.25f);
  EXPECT_EQ(m.roughness.value, 1);
}

TEST(GltfMaterials, AlphaModes) {
  const std::string base = R"("pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.75]})";
  EXPECT_EQ(material("{" + base + "}").alpha_mode, AlphaMode::opaque);
  const Material mask = material(R"({"alphaMode": "MASK", "alphaCutoff": 0.25, )" + base + "}");
  EXPECT_EQ(mask.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(mask.alpha_cutoff, 0.25f);
  EXPECT_EQ(mask.alpha.value, 0.75f);
  EXPECT_EQ(material(R"({"alphaMode": "BLEND"})").alpha_mode, AlphaMode::blend);
  EXPECT_NE(refusal(with_material(R"({"alphaMode": "BLENT"})")).find("/materials/0/alphaMode: unknown mode"),
            std::string::npos);
}

TEST(GltfMaterials, EmissionAndItsStrength) {
  EXPECT_EQ(emission(R"({"emissiveFactor": [1, 0.5, 0]})")->radiance.value, Rgb(1, 0.5f, 0));
  const auto strong = emission(R"({"emissiveFactor": [1, 0.5, 0], "doubleSided": true,
      "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}}})");
  EXPECT_EQ(strong->radiance.value, Rgb(8, 4, 0));
  EXPECT_TRUE(strong->two_sided);
  EXPECT_NE(refusal(with_material(R"({"emissiveFactor": [1e20, 0, 0],
      "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 1e30}}})"))
                .find("emissiveStrength: the emission is too large"),
            std::string::npos);
}

TEST(GltfMaterials, UnlitIsSeenButLightsNothing) {
  const std::string json = R"({"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1]},
      "extensions": {"KHR_materials_unlit": {}}})";
  EXPECT_EQ(emission(json)->radiance.value, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_FALSE(emission(json)->casts_light);
  EXPECT_EQ(std::get<DiffuseMaterial>(material(json).model).reflectance.value, Rgb(0.0f));
}

TEST(GltfMaterials, IorDispersionAndTransmission) {
  EXPECT_EQ(extended("KHR_materials_ior", R"({"ior": 1.33})").ior, 1.33f);
  EXPECT_GE(extended("KHR_materials_ior", R"({"ior": 0})").ior, 1000);
  EXPECT_EQ(extended("KHR_materials_dispersion", R"({"dispersion": 0.5})").dispersion, 0.5f);
  EXPECT_EQ(extended("KHR_materials_transmission", R"({"transmissionFactor": 0.75})").transmission.value, 0.75f);
  EXPECT_TRUE(extended("KHR_materials_transmission", "{}").thin_walled);
  EXPECT_NE(refusal(with_material(R"({"extensions": {"KHR_materials_ior": {"ior": 0.5}}})"))
                .find("ior: expected 0 or at least 1"),
            std::string::npos);
}

TEST(GltfMaterials, VolumesAbsorb) {
  const Material m = material(R"({"extensions": {"KHR_materials_volume": {"thicknessFactor": 1,
      "attenuationDistance": 2, "attenuationColor": [1, 0.5, 0.25]}}})");
  // After the distance, the colour is what is left.
  EXPECT_NEAR(std::exp(-2 * m.absorption.g), 0.5f, 1e-6f);
  EXPECT_NEAR(std::exp(-2 * m.absorption.b), 0.25f, 1e-6f);
  EXPECT_EQ(m.absorption.r, 0);
  EXPECT_FALSE(std::get<GltfMaterial>(m.model).thin_walled);
  EXPECT_TRUE(m.double_sided);
  EXPECT_NE(
      refusal(with_material(
                  R"({"extensions": {"KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 0}}})"))
          .find("attenuationDistance: expected more than 0"),
      std::string::npos);
}

TEST(GltfMaterials, SpecularClearcoatSheen) {
  const GltfMaterial specular =
      extended("KHR_materials_specular", R"({"specularFactor": 0.5, "specularColorFactor": [2, 1, 0]})");
  EXPECT_EQ(specular.specular.value, 0.5f);
  EXPECT_EQ(specular.specular_colour.value, Rgb(2, 1, 0));
  const GltfMaterial coat =
      extended("KHR_materials_clearcoat", R"({"clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.25})");
  EXPECT_EQ(coat.clearcoat.value, 0.5f);
  EXPECT_EQ(coat.clearcoat_roughness.value, 0.25f);
  const GltfMaterial sheen =
      extended("KHR_materials_sheen", R"({"sheenColorFactor": [0.1, 0.2, 0.3], "sheenRoughnessFactor": 0.4})");
  EXPECT_EQ(sheen.sheen_colour.value, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(sheen.sheen_roughness.value, 0.4f);
}

TEST(GltfMaterials, AnisotropyAndIridescence) {
  const GltfMaterial a =
      extended("KHR_materials_anisotropy", R"({"anisotropyStrength": 0.5, "anisotropyRotation": 1.25})");
  EXPECT_EQ(a.anisotropy, 0.5f);
  EXPECT_EQ(a.anisotropy_rotation, 1.25f);
  const GltfMaterial i = extended("KHR_materials_iridescence", R"({"iridescenceFactor": 1, "iridescenceIor": 1.5,
      "iridescenceThicknessMinimum": 200, "iridescenceThicknessMaximum": 600})");
  EXPECT_EQ(i.iridescence.value, 1);
  EXPECT_EQ(i.iridescence_ior, 1.5f);
  EXPECT_EQ(i.iridescence_thickness_min, 200);
  EXPECT_EQ(i.iridescence_thickness_max, 600);
}

TEST(GltfMaterials, SpecularGlossinessIsConverted) {
  const std::string json = R"({"extensions": {"KHR_materials_pbrSpecularGlossiness":
      {"diffuseFactor": [0.5, 0.25, 0, 1], "glossinessFactor": 0.75}}})";
  const GltfMaterial m = model(json);
  EXPECT_EQ(m.base_colour.value, Rgb(0.5f, 0.25f, 0));
  EXPECT_EQ(m.metallic.value, 0);
  EXPECT_EQ(m.roughness.value, 0.25f);
  EXPECT_TRUE(has_note(notes_of(with_material(json)), "converted to metallic-roughness"));
}

TEST(GltfMaterials, WrongKindsAreNamed) {
  EXPECT_EQ(refusal(with_material(R"({"pbrMetallicRoughness": {"metallicFactor": "1"}})")),
            "t.gltf: /materials/0/pbrMetallicRoughness/metallicFactor: expected a number, found a string");
  TestDocument d = triangle_document();
  primitive(d)["material"] = 0;
  EXPECT_EQ(refusal(d), "t.gltf: /meshes/0/primitives/0/material: refers to 0 of materials, but there are 0");
}

}  // namespace
}  // namespace lambert::gltf
