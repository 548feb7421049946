#include "lambert/image/probe/layout.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

// rows: IS-19 LF-13
TEST(Layout, CutUndoesArranged) {
  const Probe cube = map_of(Cube{}, 5, pattern);
  for (const char* name : {"vertical-cross", "horizontal-cross", "vertical-strip", "horizontal-strip", "faces"}) {
    const Layout l = layout(name);
    const std::vector<Image> pictures = arranged(cube, l.arrangement);
    if (l.arrangement != Arrangement::files) {
      EXPECT_EQ(guess_layout(pictures.front()), name);
    }
    const Probe back = cut(l, pictures);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_TRUE(
          std::equal(back.charts[i].pixels().begin(), back.charts[i].pixels().end(), cube.charts[i].pixels().begin()))
          << name << i;
  }
}

// rows: IS-19 IS-20
TEST(Layout, OpenExrsAttributeIsSetAndRead) {
  for (const std::string& name : layout_names()) {
    const Layout l = layout(name);
    Probe probe{l.projection, l.texels, {}};
    const Vec2i size = chart_size(l.projection, 8);
    for (int i = 0; i < chart_count(l.projection); ++i) probe.charts.emplace_back(size.x, size.y, rgb_channels());
    probe.charts.front().attributes["envmap"] = {"envmap", "cube"};  // of what it was made from
    probe.charts.front().attributes["expTime"] = {"float", "0.5"};
    const Image picture = arranged(probe, l.arrangement).front();
    EXPECT_EQ(picture.attributes.at("expTime").value, "0.5") << name;
    if (name.starts_with("openexr-")) {
      EXPECT_EQ(picture.attributes.at("envmap").value, name == "openexr-cube" ? "cube" : "latlong");
      EXPECT_EQ(guess_layout(picture), name);
    } else {
      EXPECT_FALSE(picture.attributes.contains("envmap")) << name;
    }
  }
}

// rows: IS-19 LF-13
// Neighbours in the picture are neighbours on the sphere: the cross can be folded.
TEST(Layout, CrossesFold) {
  constexpr int n = 16;
  const Probe cube = map_of(Cube{}, n, [](Vec3 d) { return Rgb(d.x, d.y, d.z); });
  const auto at = [](const Image& i, int x, int y) {
    const Rgb c = i.rgb(x, y);
    return Vec3(c.r, c.g, c.b);
  };
  const Image vertical = arranged(cube, Arrangement::vertical_cross).front();
  for (int y = 0; y + 1 < 4 * n; ++y) EXPECT_LT(length(at(vertical, n + 5, y) - at(vertical, n + 5, y + 1)), 0.2f) << y;
  for (int x = 0; x + 1 < 3 * n; ++x) EXPECT_LT(length(at(vertical, x, n + 3) - at(vertical, x + 1, n + 3)), 0.2f) << x;
  const Image horizontal = arranged(cube, Arrangement::horizontal_cross).front();
  for (int x = 0; x + 1 < 4 * n; ++x)
    EXPECT_LT(length(at(horizontal, x, n + 3) - at(horizontal, x + 1, n + 3)), 0.2f) << x;
  // The middle of the cross is ahead.
  EXPECT_LT(at(vertical, 3 * n / 2, 3 * n / 2).z, -0.99f);
  EXPECT_GT(at(vertical, 3 * n / 2, n / 2).y, 0.99f);
  EXPECT_GT(at(vertical, 5 * n / 2, 3 * n / 2).x, 0.99f);
}

TEST(Layout, SaysWhatDoesNotFit) {
  const auto error = [](const auto& f) -> std::string {
    try {
      f();
    } catch (const Error& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_NE(error([] { layout("lat-lon"); }).find("lat-long"), std::string::npos);
  EXPECT_NE(error([] { guess_layout(Image(8, 8, {"Y"})); }).find("say which"), std::string::npos);
  EXPECT_NE(error([] { guess_layout(Image(9, 7, {"Y"})); }).find("9x7"), std::string::npos);
  EXPECT_NE(error([] { cut(layout("vertical-cross"), {Image(8, 8, {"Y"})}); }).find("3 across"), std::string::npos);
  EXPECT_NE(error([] { cut(layout("mirror-ball"), {Image(8, 6, {"Y"})}); }).find("square"), std::string::npos);
  EXPECT_NE(error([] { cut(layout("faces"), {Image(8, 8, {"Y"})}); }), "");
  EXPECT_EQ(guess_layout(Image(8, 4, {"Y"})), "lat-long");
}

}  // namespace
}  // namespace lambert::probe
