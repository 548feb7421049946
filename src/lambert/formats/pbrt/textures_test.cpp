#include "lambert/formats/pbrt/pbrt_test_tools.h"

#include "lambert/image/colour.h"
#include "lambert/image/io.h"

namespace lambert {
namespace {

/// The reflectance at (u, v) of a diffuse material that takes it from the spectrum texture "t".
Rgb spectrum_at(const std::string& textures, Vec2 uv, const std::filesystem::path& folder = {}) {
  Notes notes;
  const SceneGraph graph =
      read_world(textures + " Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"", notes, "", folder);
  TextureCoordinates at;
  at.uv = uv;
  return std::get<DiffuseMaterial>(first_material(graph).model).reflectance.eval(graph.textures, at);
}
float float_at(const std::string& textures, Vec2 uv, const std::filesystem::path& folder = {}) {
  Notes notes;
  const SceneGraph graph =
      read_world(textures + " Material \"conductor\" \"texture roughness\" \"t\" Shape \"sphere\"", notes, "", folder);
  TextureCoordinates at;
  at.uv = uv;
  return std::get<ConductorMaterial>(first_material(graph).model).roughness.u.eval(graph.textures, at);
}

TEST(PbrtTextures, ConstantScaleMix) {
  EXPECT_EQ(float_at("Texture \"t\" \"float\" \"constant\" \"float value\" .7", {}), 0.7f);
  EXPECT_NEAR(float_at("Texture \"t\" \"float\" \"scale\" \"float tex\" .7 \"float scale\" .5", {}), 0.35f, 1e-6f);
  EXPECT_NEAR(float_at("Texture \"t\" \"float\" \"mix\" \"float tex1\" .2 \"float tex2\" .6 \"float amount\" .25", {}),
              0.3f, 1e-6f);
  expect_near(spectrum_at("Texture \"half\" \"float\" \"constant\" \"float value\" .5 "
                          "Texture \"c\" \"spectrum\" \"constant\" \"rgb value\" [ .2 .4 .6 ] "
                          "Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"c\" \"texture scale\" \"half\"",
                          {}),
              Rgb(0.1f, 0.2f, 0.3f));
  expect_near(spectrum_at("Texture \"t\" \"spectrum\" \"mix\" \"rgb tex1\" [ 1 0 0 ] \"rgb tex2\" [ 0 1 0 ]", {}),
              Rgb(0.5f, 0.5f, 0));
}

TEST(PbrtTextures, Checkerboard) {
  const std::string board =
      "Texture \"t\" \"float\" \"checkerboard\" \"float uscale\" 4 \"float vscale\" 2 \"float tex1\" .9 \"float tex2\" "
      ".1";
  EXPECT_NEAR(float_at(board, {0.1f, 0.1f}), 0.9f, 1e-6f);
  EXPECT_NEAR(float_at(board, {0.3f, 0.1f}), 0.1f, 1e-6f);
  EXPECT_NEAR(float_at(board, {0.3f, 0.6f}), 0.9f, 1e-6f);
}

TEST(PbrtTextures, ScaledCheckerboardOfColours) {
  const std::string text =
      "Texture \"board\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [ 1 0 0 ] \"rgb tex2\" [ 0 0 1 ] "
      "Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"board\" \"float scale\" .5";
  expect_near(spectrum_at(text, {0.5f, 0.5f}), Rgb(0.5f, 0, 0));
  expect_near(spectrum_at(text, {1.5f, 0.5f}), Rgb(0, 0, 0.5f));
}

/// Two by two pixels: red and green above, blue and white below.
class PbrtImageTextures : public ::testing::Test {
 protected:
  PbrtImageTextures() {
    Image image(2, 2, rgb_channels());
    image.set_rgb(0, 0, Rgb(1, 0, 0));
    image.set_rgb(1, 0, Rgb(0, 1, 0));
    image.set_rgb(0, 1, Rgb(0, 0, 1));
    image.set_rgb(1, 1, Rgb(1, 1, 1));
    write_image(folder_.path() / "four.pfm", image);
    Image grey(1, 1, rgb_channels());
    grey.set_rgb(0, 0, Rgb(srgb_decode(0.5f)));
    write_image(folder_.path() / "grey.png", grey);
  }
  TemporaryFolder folder_;
  const std::string four_ =
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"four.pfm\" \"string filter\" \"point\" ";
};

TEST_F(PbrtImageTextures, VRunsUpTheImage) {
  expect_near(spectrum_at(four_, {0.25f, 0.75f}, folder_.path()), Rgb(1, 0, 0));
  expect_near(spectrum_at(four_, {0.75f, 0.75f}, folder_.path()), Rgb(0, 1, 0));
  expect_near(spectrum_at(four_, {0.25f, 0.25f}, folder_.path()), Rgb(0, 0, 1));
}

TEST_F(PbrtImageTextures, MappingScaleInvert) {
  expect_near(spectrum_at(four_ + "\"float udelta\" .5", {0.25f, 0.75f}, folder_.path()), Rgb(0, 1, 0));
  expect_near(spectrum_at(four_ + "\"float uscale\" 3 \"float vscale\" 1", {0.25f, 0.75f}, folder_.path()),
              Rgb(0, 1, 0));
  expect_near(spectrum_at(four_ + "\"float scale\" .25", {0.25f, 0.75f}, folder_.path()), Rgb(0.25f, 0, 0));
  expect_near(spectrum_at(four_ + "\"bool invert\" true", {0.25f, 0.75f}, folder_.path()), Rgb(0, 1, 1));
}

TEST_F(PbrtImageTextures, WrapModes) {
  expect_near(spectrum_at(four_ + "\"string wrap\" \"black\"", {1.25f, 0.75f}, folder_.path()), Rgb(0, 0, 0));
  expect_near(spectrum_at(four_ + "\"string wrap\" \"clamp\"", {1.25f, 0.75f}, folder_.path()), Rgb(0, 1, 0));
  expect_near(spectrum_at(four_, {1.25f, 0.75f}, folder_.path()), Rgb(1, 0, 0));
}

TEST_F(PbrtImageTextures, Encodings) {
  const std::string grey = "\"imagemap\" \"string filename\" \"grey.png\" ";
  const float encoded = 128.0f / 255, tolerance = 2.0f / 255;
  EXPECT_NEAR(spectrum_at("Texture \"t\" \"spectrum\" " + grey, {}, folder_.path()).g, srgb_decode(encoded), tolerance);
  EXPECT_NEAR(float_at("Texture \"t\" \"float\" " + grey, {}, folder_.path()), srgb_decode(encoded), tolerance);
  EXPECT_NEAR(float_at("Texture \"t\" \"float\" " + grey + "\"string encoding\" \"linear\"", {}, folder_.path()),
              encoded, tolerance);
  EXPECT_NEAR(float_at("Texture \"t\" \"float\" " + grey + "\"string encoding\" \"gamma 3\"", {}, folder_.path()),
              encoded * encoded * encoded, tolerance);
}

TEST_F(PbrtImageTextures, FloatTexturesTakeTheMeanOfColours) {
  EXPECT_NEAR(
      float_at("Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"four.pfm\" \"string filter\" \"point\"",
               {0.25f, 0.75f}, folder_.path()),
      1.0f / 3, 1e-5f);
}

TEST_F(PbrtImageTextures, NormalMapsAreNumbers) {
  Notes notes;
  const SceneGraph graph =
      read_world("Material \"diffuse\" \"string normalmap\" \"grey.png\" Shape \"sphere\"", notes, "", folder_.path());
  const TextureId map = first_material(graph).normal_map;
  ASSERT_NE(map, no_texture);
  EXPECT_NEAR(graph.textures.eval(map, {}).x, 128.0f / 255, 2.0f / 255);
}

TEST_F(PbrtImageTextures, Errors) {
  const auto message = [&](const std::string& text) {
    return error_of([&] { spectrum_at(text, {}, folder_.path()); });
  };
  EXPECT_NE(message("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"none.png\"").find("s.pbrt:2:1: "),
            std::string::npos);
  EXPECT_NE(message(four_ + "\"string wrap\" \"rpeeat\"").find("unknown wrap mode 'rpeeat'"), std::string::npos);
  EXPECT_NE(
      message("Texture \"t\" \"spectrum\" \"windy\"")
          .find("s.pbrt:2:1: unknown texture class 'windy' (known: constant, imagemap, scale, mix, checkerboard)"),
      std::string::npos);
  EXPECT_NE(message("").find("unknown spectrum texture 't'"), std::string::npos);
  EXPECT_NE(message("Texture \"t\" \"colour\" \"constant\"").find("unknown type of texture 'colour'"),
            std::string::npos);
  EXPECT_NE(message(four_ + "\"string mapping\" \"planar\"").find("unknown texture mapping 'planar' (known: uv)"),
            std::string::npos);
}

}  // namespace
}  // namespace lambert
