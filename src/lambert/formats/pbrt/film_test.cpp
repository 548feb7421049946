#include "lambert/formats/pbrt/pbrt_test_tools.h"

namespace lambert {
namespace {

SceneFileSettings read_settings(const std::string& text, Notes& notes) { return read_world("", notes, text).settings; }
SceneFileSettings read_settings(const std::string& text) {
  Notes notes;
  return read_settings(text, notes);
}

TEST(PbrtFilm, SettingsReachTheScene) {
  Notes notes;
  const SceneGraph graph = read_world(
      "", notes,
      "Film \"gbuffer\" \"string filename\" \"a.exr\" \"integer xresolution\" 32 \"integer yresolution\" 16 "
      "PixelFilter \"mitchell\" \"float xradius\" 3 \"float B\" .5 Sampler \"halton\" \"integer pixelsamples\" 7 "
      "Integrator \"path\" \"integer maxdepth\" 9 \"string lightsampler\" \"power\" Accelerator \"bvh\" \"integer x\" "
      "1 "
      "Camera \"perspective\"");
  EXPECT_TRUE(notes.empty());
  const SceneFileSettings& s = graph.settings;
  EXPECT_EQ(s.output, "a.exr");
  EXPECT_EQ(graph.cameras().at(0).resolution, Vec2i(32, 16));
  ASSERT_TRUE(s.filter);
  EXPECT_EQ(s.filter->kind, FilterKind::mitchell);
  EXPECT_EQ(s.filter->radius, Vec2(3, 2));
  EXPECT_EQ(s.filter->b, 0.5f);
  EXPECT_EQ(s.sampler, "halton");
  EXPECT_EQ(s.samples_per_pixel, 7);
  EXPECT_EQ(s.max_depth, 9);
  EXPECT_EQ(s.light_strategy, "power");
}

TEST(PbrtFilm, Defaults) {
  const SceneFileSettings nothing = read_settings("");
  EXPECT_FALSE(nothing.filter || nothing.sampler || nothing.samples_per_pixel || nothing.max_depth || nothing.output);
  const SceneFileSettings s = read_settings("Sampler \"stratified\" Integrator \"path\" PixelFilter \"triangle\"");
  EXPECT_EQ(s.samples_per_pixel, 16);
  EXPECT_EQ(s.max_depth, 5);
  EXPECT_EQ(s.light_strategy, "tree");
  EXPECT_EQ(s.filter->radius, Vec2(2));
}

TEST(PbrtFilm, SubstitutionsAreNoted) {
  Notes notes;
  const SceneFileSettings s = read_settings(
      "Integrator \"volpath\" PixelFilter \"sinc\" Option \"disablepixeljitter\" true Option \"seed\" 3 "
      "Film \"rgb\" \"float cropwindow\" [ 0 .5 0 .5 ] \"float iso\" 400",
      notes);
  EXPECT_EQ(s.filter->kind, FilterKind::lanczos);
  for (const char* note : {"'volpath' is done as 'path'", "'sinc'", "'disablepixeljitter'", "--crop", "sensor"}) {
    EXPECT_TRUE(has_note(notes, note)) << note;
  }
}

TEST(PbrtFilm, Errors) {
  EXPECT_NE(
      error_of([] { read_settings("Sampler \"zobol\""); }).find("s.pbrt:1:1: unknown sampler 'zobol'; did you mean"),
      std::string::npos);
  EXPECT_NE(error_of([] { read_settings("Integrator \"pth\""); }).find("did you mean 'path'"), std::string::npos);
  EXPECT_EQ(error_of([] { read_settings("PixelFilter \"round\""); }),
            "s.pbrt:1:1: unknown pixel filter 'round' (known: box, triangle, gaussian, mitchell, sinc)");
  EXPECT_EQ(error_of([] { read_settings("Film \"rgb\" \"integer xresolution\" 1000000000"); }),
            "s.pbrt:1:1: Film \"rgb\": the resolution exceeds 65536 pixels");
  EXPECT_EQ(error_of([] { read_settings("Film \"rgb\" \"integer xresolution\" -5"); }),
            "s.pbrt:1:1: Film \"rgb\": 'xresolution' must be at least 1");
}

}  // namespace
}  // namespace lambert
