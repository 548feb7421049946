#include "lambert/formats/pbrt/pbrt_test_tools.h"

#include "lambert/material/spectrum.h"

namespace lambert {
namespace {

template <class Model>
Model model_of(const std::string& material) {
  const SceneGraph graph = read_whole_world(material + " Shape \"sphere\"");
  return std::get<Model>(first_material(graph).model);
}

TEST(PbrtMaterials, Diffuse) {
  EXPECT_EQ(model_of<DiffuseMaterial>("").reflectance.value, Rgb(0.5f));
  EXPECT_EQ(model_of<DiffuseMaterial>("Material \"diffuse\"").reflectance.value, Rgb(0.5f));
  EXPECT_EQ(model_of<DiffuseMaterial>("Material \"diffuse\" \"rgb reflectance\" [ .1 .2 .3 ]").reflectance.value,
            Rgb(0.1f, 0.2f, 0.3f));
}

TEST(PbrtMaterials, DiffuseTransmission) {
  const auto m = model_of<DiffuseTransmissionMaterial>(
      "Material \"diffusetransmission\" \"rgb transmittance\" [ .4 .4 .4 ] \"float scale\" .5");
  EXPECT_EQ(m.reflectance.value, Rgb(0.125f));
  EXPECT_EQ(m.transmittance.value, Rgb(0.2f));
}

TEST(PbrtMaterials, Conductor) {
  const auto copper = model_of<ConductorMaterial>("Material \"conductor\" \"float roughness\" .1");
  EXPECT_EQ(copper.eta.value, named_metal("Cu")->eta);
  EXPECT_EQ(copper.roughness.u.value, 0.1f);
  EXPECT_EQ(copper.roughness.v.value, 0.1f);
  EXPECT_TRUE(copper.roughness.remap);
  const auto gold = model_of<ConductorMaterial>(
      "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\" \"float uroughness\" .2 "
      "\"float vroughness\" .3 \"bool remaproughness\" false");
  EXPECT_EQ(gold.eta.value, named_metal("Au")->eta);
  EXPECT_EQ(gold.k.value, named_metal("Au")->k);
  EXPECT_EQ(gold.roughness.u.value, 0.2f);
  EXPECT_EQ(gold.roughness.v.value, 0.3f);
  EXPECT_FALSE(gold.roughness.remap);
  const auto plain = model_of<ConductorMaterial>("Material \"conductor\" \"rgb reflectance\" [ .9 .8 .7 ]");
  EXPECT_TRUE(plain.use_reflectance);
  EXPECT_EQ(plain.reflectance.value, Rgb(0.9f, 0.8f, 0.7f));
  EXPECT_EQ(error_of([] { read_world("Material \"conductor\" \"rgb reflectance\" [ 1 1 1 ] \"rgb k\" [ 1 1 1 ]"); }),
            "s.pbrt:2:1: Material \"conductor\": takes 'reflectance' or 'eta' and 'k', not both");
}

TEST(PbrtMaterials, Dielectric) {
  EXPECT_EQ(model_of<DielectricMaterial>("Material \"dielectric\"").eta, 1.5f);
  EXPECT_EQ(model_of<DielectricMaterial>("Material \"dielectric\" \"float eta\" 1.33").eta, 1.33f);
  const auto glass = model_of<DielectricMaterial>("Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"");
  EXPECT_NEAR(glass.eta, 1.5168f, 1e-3f);
  EXPECT_NEAR(glass.abbe_number, 64.2f, 1);
  const auto sampled =
      model_of<DielectricMaterial>("Material \"dielectric\" \"spectrum eta\" [ 486.1 1.54 587.6 1.53 656.3 1.52 ]");
  EXPECT_NEAR(sampled.eta, 1.53f, 1e-5f);
  EXPECT_NEAR(sampled.abbe_number, 0.53f / 0.02f, 0.01f);
  const auto thin = model_of<DielectricMaterial>("Material \"thindielectric\" \"float eta\" 1.4");
  EXPECT_TRUE(thin.thin);
  EXPECT_EQ(thin.eta, 1.4f);
}

TEST(PbrtMaterials, Coated) {
  const auto plastic = model_of<CoatedDiffuseMaterial>(
      "Material \"coateddiffuse\" \"rgb reflectance\" [ .1 .2 .3 ] \"float roughness\" .3 \"float eta\" 1.6");
  EXPECT_EQ(plastic.reflectance.value, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(plastic.eta, 1.6f);
  EXPECT_EQ(plastic.roughness.u.value, 0.3f);
  const auto metal = model_of<CoatedConductorMaterial>(
      "Material \"coatedconductor\" \"float interface.roughness\" .01 \"float interface.eta\" 1.7 "
      "\"spectrum conductor.eta\" \"metal-Ag-eta\" \"spectrum conductor.k\" \"metal-Ag-k\" "
      "\"float conductor.roughness\" .2");
  EXPECT_EQ(metal.interface_eta, 1.7f);
  EXPECT_EQ(metal.interface_roughness.u.value, 0.01f);
  EXPECT_EQ(metal.conductor.eta.value, named_metal("Ag")->eta);
  EXPECT_EQ(metal.conductor.roughness.v.value, 0.2f);
  Notes notes;
  read_world("Material \"coateddiffuse\" \"float thickness\" .02", notes);
  EXPECT_TRUE(has_note(notes, "'thickness' is ignored"));
}

TEST(PbrtMaterials, MixByNames) {
  const SceneGraph graph = read_whole_world(
      "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" MakeNamedMaterial \"b\" \"string type\" \"conductor\"\n"
      "Material \"mix\" \"string materials\" [ \"a\" \"b\" ] \"float amount\" .25 Shape \"sphere\"");
  const auto& mix = std::get<MixMaterial>(first_material(graph).model);
  EXPECT_EQ(graph.materials[mix.a].name, "a");
  EXPECT_EQ(graph.materials[mix.b].name, "b");
  EXPECT_EQ(mix.amount.value, 0.25f);
  EXPECT_EQ(error_of([] { read_world("Material \"mix\" \"string materials\" [ \"a\" \"b\" ]"); }),
            "s.pbrt:2:1: Material \"mix\": unknown material 'a'");
}

TEST(PbrtMaterials, InterfaceShowsNothing) {
  Notes notes;
  const SceneGraph graph = read_world("Material \"interface\" Shape \"sphere\" Material \"\" Shape \"sphere\"", notes);
  EXPECT_TRUE(shown(graph).empty());
  EXPECT_TRUE(has_note(notes, "interface material"));
}

TEST(PbrtMaterials, AlphaMakesAVariantOnce) {
  const SceneGraph graph = read_whole_world(
      "Texture \"holes\" \"float\" \"checkerboard\" MakeNamedMaterial \"m\" \"string type\" \"diffuse\" "
      "NamedMaterial \"m\" Shape \"sphere\" Shape \"sphere\" \"float alpha\" .3 Shape \"disk\" \"float alpha\" .3 "
      "Shape \"sphere\" \"texture alpha\" \"holes\"");
  const std::vector<Shown> all = shown(graph);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(graph.materials[all[0].surface.material].alpha_mode, AlphaMode::opaque);
  const Material& veil = graph.materials[all[1].surface.material];
  EXPECT_EQ(veil.alpha_mode, AlphaMode::blend);
  EXPECT_EQ(veil.alpha.value, 0.3f);
  EXPECT_EQ(all[1].surface.material, all[2].surface.material);
  EXPECT_NE(graph.materials[all[3].surface.material].alpha.texture, no_texture);
}

TEST(PbrtMaterials, AlphaOfAMixReachesItsParts) {
  const SceneGraph graph = read_whole_world(
      "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" "
      "Material \"mix\" \"string materials\" [ \"a\" \"a\" ] Shape \"sphere\" \"float alpha\" .3");
  const auto& mix = std::get<MixMaterial>(first_material(graph).model);
  EXPECT_EQ(graph.materials[mix.a].alpha.value, 0.3f);
}

TEST(PbrtMaterials, UnknownTypesNameTypeLineAndTheKnownOnes) {
  const std::string message = error_of([] { read_world("\nMaterial \"hair\""); });
  EXPECT_EQ(
      message,
      "s.pbrt:3:1: unknown material 'hair' (known: diffuse, conductor, dielectric, thindielectric, coateddiffuse, "
      "coatedconductor, diffusetransmission, mix, interface)");
  EXPECT_NE(error_of([] { read_world("Material \"matte\""); }).find("pbrt-v4 calls it 'diffuse'"), std::string::npos);
  EXPECT_NE(error_of([] { read_world("NamedMaterial \"x\""); }).find("s.pbrt:2:1: unknown material 'x'"),
            std::string::npos);
}

TEST(PbrtMaterials, UnusedParametersAreNoted) {
  Notes notes;
  read_world("Material \"diffuse\" \"float roughness\" 1", notes);
  EXPECT_TRUE(has_note(notes, "s.pbrt:2:20: unused parameter 'roughness' of Material \"diffuse\""));
}

TEST(PbrtMaterials, AttributesGiveDefaults) {
  const auto m = model_of<DiffuseMaterial>(
      "Attribute \"material\" \"rgb reflectance\" [ .1 .1 .1 ] Attribute \"shape\" \"float nothing\" 1 "
      "Material \"diffuse\"");
  EXPECT_EQ(m.reflectance.value, Rgb(0.1f));
  EXPECT_NE(error_of([] {
              read_world("Attribute \"lihgt\" \"float x\" 1");
            }).find("s.pbrt:2:1: unknown target of Attribute: 'lihgt'; did you mean 'light'?"),
            std::string::npos);
}

}  // namespace
}  // namespace lambert
