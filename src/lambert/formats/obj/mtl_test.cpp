#include "lambert/formats/obj/mtl.h"
#include "lambert/formats/format_test_tools.h"

#include "lambert/image/io.h"

#include <cmath>

namespace lambert {
namespace {

/// A triangle whose material has these lines.
SceneGraph read(const std::string& material, Notes& notes, const TemporaryFolder& folder = TemporaryFolder()) {
  folder.write("m.mtl", "# made by hand\nnewmtl m\n" + material);
  return read_obj("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n", "m.obj", folder.path(), notes);
}
template <class Model>
Model model_of(const std::string& material) {
  Notes notes;
  return std::get<Model>(first_material(read(material, notes)).model);
}

TEST(Mtl, DiffuseWithoutHighlight) {
  EXPECT_EQ(model_of<DiffuseMaterial>("Kd .1 .2 .3\n").reflectance.value, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(model_of<DiffuseMaterial>("Kd .1 .2 .3\nKs 1 1 1\nillum 1\n").reflectance.value, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(model_of<DiffuseMaterial>("Kd .5\nKs 0 0 0\nillum 2\n").reflectance.value, Rgb(0.5f));
}

TEST(Mtl, HighlightsBecomeMicrofacets) {
  const auto m = model_of<GltfMaterial>("Kd .8 .8 .8\nKs .5 .5 .5\nNs 198\nillum 2\n");
  EXPECT_EQ(m.base_colour.value, Rgb(0.8f));
  EXPECT_EQ(m.metallic.value, 0);
  EXPECT_NEAR(m.roughness.value, std::pow(0.01f, 0.25f), 1e-5f);
  EXPECT_EQ(m.specular_colour.value, Rgb(1)) << "the reflectance 0.04 of glass";
}

TEST(Mtl, PhysicallyBasedKeys) {
  const auto m =
      model_of<GltfMaterial>("Kd .9 .6 .1\nPr .3\nPm 1\nPs .2\nPc .5\nPcr .1\naniso .7\nanisor .25\nNi 1.4\n");
  EXPECT_EQ(m.roughness.value, 0.3f);
  EXPECT_EQ(m.metallic.value, 1);
  EXPECT_EQ(m.sheen_colour.value, Rgb(0.2f));
  EXPECT_EQ(m.clearcoat.value, 0.5f);
  EXPECT_EQ(m.clearcoat_roughness.value, 0.1f);
  EXPECT_EQ(m.anisotropy, 0.7f);
  EXPECT_NEAR(m.anisotropy_rotation, 0.5f * pi, 1e-6f);
  EXPECT_EQ(m.ior, 1.4f);
}

TEST(Mtl, GlassAndMirror) {
  EXPECT_EQ(model_of<DielectricMaterial>("illum 7\nNi 1.33\nd .1\n").eta, 1.33f);
  EXPECT_EQ(model_of<DielectricMaterial>("illum 4\nTr .5\n").eta, 1.5f);
  EXPECT_EQ(model_of<DiffuseMaterial>("illum 4\nKd 1 0 0\n").reflectance.value, Rgb(1, 0, 0)) << "opaque";
  const auto mirror = model_of<ConductorMaterial>("illum 5\nKs .9 .8 .7\n");
  EXPECT_TRUE(mirror.use_reflectance);
  EXPECT_EQ(mirror.reflectance.value, Rgb(0.9f, 0.8f, 0.7f));
}

TEST(Mtl, OpacityAndEmission) {
  Notes notes;
  const SceneGraph graph = read("Kd 1 1 1\nd .25\nKe 3 2 1\n", notes);
  EXPECT_EQ(first_material(graph).alpha_mode, AlphaMode::blend);
  EXPECT_EQ(first_material(graph).alpha.value, 0.25f);
  const std::optional<Emission> emission = shown(graph).at(0).surface.emission;
  ASSERT_TRUE(emission);
  EXPECT_EQ(emission->radiance.value, Rgb(3, 2, 1));
  EXPECT_TRUE(emission->two_sided);
  EXPECT_FALSE(shown(read("Kd 1 1 1\nKe 0 0 0\n", notes)).at(0).surface.emission);
}

TEST(Mtl, Maps) {
  const TemporaryFolder folder;
  Image image(1, 2, rgb_channels());
  image.set_rgb(0, 0, Rgb(1, 0, 0));
  image.set_rgb(0, 1, Rgb(0, 1, 0));
  write_image(folder.path() / "my picture.pfm", image);
  Notes notes;
  const SceneGraph graph =
      read("Kd 0 0 0\nmap_Kd -clamp on -o 0 .5 my picture.pfm\nmap_d my picture.pfm\n", notes, folder);
  const Material& m = first_material(graph);
  const auto& reflectance = std::get<DiffuseMaterial>(m.model).reflectance;
  EXPECT_EQ(reflectance.value, Rgb(1)) << "a black Kd does not hide its map";
  // uv of the mesh have v downwards: v = 1 - 0.1 in the file, and 0.1 + 0.5 is in the upper half.
  TextureCoordinates at;
  at.uv = {0.5f, 0.75f};
  EXPECT_NEAR(reflectance.eval(graph.textures, at).r, 1, 0.05f);
  EXPECT_NE(m.alpha.texture, no_texture);
  EXPECT_EQ(m.alpha.channel, 0);
}

TEST(Mtl, WhatIsIgnoredIsNoted) {
  Notes notes;
  read("Kd 1 1 1\nbump -bm .5 b.png\nTf 1 1 1\nmap_Kd -blendu on missing.png\nKs spectral x.rfl\n", notes);
  for (const char* note : {"'bump'", "'Tf'", "'-blendu'", "missing.png", "'Ks spectral'"}) {
    EXPECT_TRUE(has_note(notes, note)) << note;
  }
}

TEST(Mtl, ErrorsSayWhere) {
  Notes notes;
  EXPECT_NE(
      error_of([&] { read("Ns shiny\n", notes); }).find("m.mtl:3:4: expected a value, a finite number, found 'shiny'"),
      std::string::npos);
  obj::MtlLibrary library;
  EXPECT_EQ(error_of([&] { obj::parse_mtl("Kd 1 1 1\n", "x.mtl", library, notes); }),
            "x.mtl:1:1: 'Kd' must stand behind newmtl");
}

TEST(Mtl, SurvivesDamage) {
  const std::string sample =
      "newmtl a\nKd .1 .2 .3\nKs 1 1 1\nNs 30\nillum 2\nmap_Kd -s 2 2 -o .1 .1 x.png\nd -halo .5\nTr .3\nKe 1\nnewmtl "
      "b\nPr .5\n";
  expect_survives_damage(sample, 1000, [](const std::string& text) {
    Notes notes;
    obj::MtlLibrary library;
    obj::parse_mtl(text, "x.mtl", library, notes);
  });
}

}  // namespace
}  // namespace lambert
