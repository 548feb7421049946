#include "lambert/formats/pbrt/pbrt_test_tools.h"

#include "lambert/material/spectrum.h"

namespace lambert {
namespace {

/// The intensity of a point light with these parameters.
Rgb intensity(const std::string& parameters, const std::filesystem::path& folder = {}) {
  Notes notes;
  const SceneGraph graph = read_world("LightSource \"point\" " + parameters, notes, "", folder);
  return std::get<PointLight>(graph.lights().at(0)).intensity;
}
Rgb reflectance(const std::string& parameter, Notes& notes, const std::filesystem::path& folder = {}) {
  const SceneGraph graph = read_world("Material \"diffuse\" " + parameter + " Shape \"sphere\"", notes, "", folder);
  return std::get<DiffuseMaterial>(first_material(graph).model).reflectance.value;
}
Rgb reflectance(const std::string& parameter) {
  Notes notes;
  return reflectance(parameter, notes);
}

TEST(PbrtSpectra, RgbLightIsRadianceAsItStands) {
  EXPECT_EQ(intensity("\"rgb I\" [ 1 2 3 ]"), Rgb(1, 2, 3));
  EXPECT_EQ(intensity("\"rgb I\" [ 1 2 3 ] \"float scale\" 10"), Rgb(10, 20, 30));
  EXPECT_EQ(intensity(""), Rgb(1, 1, 1));
}

TEST(PbrtSpectra, OtherEmissionHasLuminanceOneTimesScale) {
  const Rgb warm = intensity("\"blackbody I\" 2700 \"float scale\" 3");
  EXPECT_NEAR(luminance(warm), 3, 1e-4f);
  EXPECT_GT(warm.r, 2 * warm.b);
  const Rgb day = intensity("\"blackbody I\" 6504");
  EXPECT_NEAR(day.r, 1, 0.1f);
  EXPECT_NEAR(day.b, 1, 0.1f);
  EXPECT_NEAR(luminance(intensity("\"spectrum I\" [ 400 7 700 7 ]")), 1, 1e-4f);
}

TEST(PbrtSpectra, StandardIlluminants) {
  expect_near(intensity("\"spectrum I\" \"stdillum-D65\""), Rgb(1, 1, 1), 2e-3f);
  const Rgb a = intensity("\"spectrum I\" \"stdillum-A\"");
  // Chromaticity (0.44758, 0.40745) in linear Rec. 709.
  expect_near(a, Rgb(1.8451f, 0.8261f, 0.2333f), 2e-3f);
  // Equal energy is pinkish against D65.
  expect_near(intensity("\"spectrum I\" \"stdillum-E\""), Rgb(1.2048f, 0.9483f, 0.9089f), 3e-3f);
}

TEST(PbrtSpectra, ConstantReflectanceIsGrey) {
  expect_near(reflectance("\"spectrum reflectance\" [ 300 .4 800 .4 ]"), Rgb(0.4f), 1e-3f);
  EXPECT_EQ(reflectance("\"rgb reflectance\" [ .1 .2 .3 ]"), Rgb(0.1f, 0.2f, 0.3f));
}

TEST(PbrtSpectra, ReflectanceAboveOneIsClampedAndNoted) {
  Notes notes;
  EXPECT_EQ(reflectance("\"rgb reflectance\" [ 2 .5 -1 ]", notes), Rgb(1, 0.5f, 0));
  EXPECT_TRUE(has_note(notes, "s.pbrt:2:20: 'reflectance' is clamped"));
}

TEST(PbrtSpectra, SpdFiles) {
  const TemporaryFolder folder;
  folder.write("grey.spd", "# measured\n300 .25\n 500 0.25\n800 .25\n");
  folder.write("bad.spd", "300 .25\n500 x\n");
  Notes notes;
  expect_near(reflectance("\"spectrum reflectance\" \"grey.spd\"", notes, folder.path()), Rgb(0.25f), 1e-3f);
  const std::string message =
      error_of([&] { reflectance("\"spectrum reflectance\" \"bad.spd\"", notes, folder.path()); });
  EXPECT_NE(message.find("bad.spd:2:5: expected the value at that wavelength"), std::string::npos) << message;
}

TEST(PbrtSpectra, Errors) {
  EXPECT_NE(error_of([] {
              reflectance("\"spectrum reflectance\" \"stdillum-D66\"");
            }).find("s.pbrt:2:20: unknown spectrum 'stdillum-D66'; did you mean"),
            std::string::npos);
  EXPECT_EQ(error_of([] { reflectance("\"spectrum reflectance\" [ 400 1 500 ]"); }),
            "s.pbrt:2:20: spectrum 'reflectance' takes pairs of wavelength and value");
  EXPECT_EQ(error_of([] { reflectance("\"spectrum reflectance\" [ 600 1 500 1 ]"); }),
            "s.pbrt:2:20: the wavelengths of spectrum 'reflectance' must be in rising order");
  EXPECT_EQ(error_of([] { intensity("\"blackbody I\" -3"); }),
            "s.pbrt:2:21: blackbody 'I' takes a temperature above 0 kelvin");
}

TEST(PbrtSpectra, ColourSpaces) {
  const SceneGraph graph = read_whole_world(
      "AttributeBegin ColorSpace \"rec2020\" LightSource \"point\" \"rgb I\" [ 1 1 1 ] AttributeEnd "
      "LightSource \"point\" \"rgb I\" [ 0 1 0 ]");
  expect_near(std::get<PointLight>(graph.lights()[0]).intensity, Rgb(1, 1, 1), 1e-4f);
  EXPECT_EQ(std::get<PointLight>(graph.lights()[1]).intensity, Rgb(0, 1, 0));
  EXPECT_NE(error_of([] { read_world("ColorSpace \"srbg\""); }).find("s.pbrt:2:1: unknown colour space 'srbg'"),
            std::string::npos);
}

}  // namespace
}  // namespace lambert
