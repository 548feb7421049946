#include "lambert/draw/picture.h"

#include "lambert/draw/outline.h"
#include "lambert/draw/pixels.h"
#include "lambert/draw/stroke_font.h"
#include "lambert/draw/svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambert::draw {
namespace {

const Rings square = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};

Picture square_picture() {
  Picture picture{.title = "a <square> & more"};
  picture.areas.push_back({.rings = square, .fill = pastel(0), .edge = strong(0)});
  add_indices(picture, square, {});
  picture.legend.push_back({"one", strong(0)});
  return picture;
}

template <class Mark>
std::vector<Mark> marks_of(const Drawing& drawing) {
  std::vector<Mark> found;
  for (const auto& mark : drawing.marks)
    if (const Mark* m = std::get_if<Mark>(&mark)) found.push_back(*m);
  return found;
}

TEST(Picture, KeepsTheShapeAndTurnsYDown) {
  const Drawing drawing = drawn(square_picture());
  const Ring ring = marks_of<Fill>(drawing).at(0).rings.at(0);
  EXPECT_NEAR(ring[1].x - ring[0].x, ring[0].y - ring[3].y, 1e-9);
  EXPECT_GT(ring[0].y, ring[3].y);
  for (const Vec2d p : ring) {
    EXPECT_GE(p.x, 0);
    EXPECT_LE(p.x, drawing.width);
    EXPECT_GE(p.y, 0);
    EXPECT_LE(p.y, drawing.height);
  }
}

TEST(Picture, IndicesStandOutsideOfTheirCorners) {
  const Drawing drawing = drawn(square_picture(), {.grid = false});
  const Ring ring = marks_of<Fill>(drawing).at(0).rings.at(0);
  const Vec2d centre = (ring[0] + ring[2]) / 2.0;
  for (const Words& words : marks_of<Words>(drawing)) {
    if (words.text.size() != 1) continue;
    const Vec2d corner = ring.at(static_cast<std::size_t>(words.text[0] - '0'));
    EXPECT_GT(glm::length(words.at - centre), glm::length(corner - centre));
    EXPECT_LT(glm::length(words.at - corner), 20);
  }
}

TEST(Picture, LabelsDoNotCoverEachOther) {
  Picture picture;
  Ring crowd;
  for (int i = 0; i < 500; ++i) crowd.push_back({std::cos(i * 0.7), std::sin(i * 1.3)});
  add_indices(picture, {crowd}, {});
  const std::vector<Words> labels = marks_of<Words>(drawn(picture, {.grid = false}));
  EXPECT_GT(labels.size(), 50u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_TRUE(std::abs(labels[i].at.y - labels[k].at.y) > 7 || std::abs(labels[i].at.x - labels[k].at.x) > 5);
}

TEST(Picture, AnyFiniteCoordinatesAreDrawn) {
  for (const double size : {1e-310, 1e-200, 1e-9, 1.0, 1e12, 1e200, 1.7e308})
    for (const double offset : {0.0, size / 2, 1e7 * size}) {
      Picture picture;
      const double low = offset - size, high = offset + size;
      if (!std::isfinite(low) || !std::isfinite(high)) continue;
      const Rings rings = {{{low, low}, {high, low}, {high, high}}, {{low, low}}, {}};
      picture.areas.push_back({.rings = rings, .fill = {}, .edge = {}});
      add_indices(picture, rings, {});
      const Drawing drawing = drawn(picture);
      EXPECT_GT(drawing.height, 0);
      EXPECT_LT(drawing.height, 1200);
      EXPECT_EQ(svg_text(drawing).find("nan"), std::string::npos) << size << " " << offset;
      EXPECT_EQ(svg_text(drawing).find("inf"), std::string::npos) << size << " " << offset;
      rasterised(drawing);
    }
  EXPECT_GT(drawn({}).width, 0);
}

TEST(Picture, SvgEscapesTextAndPaintsByTheRule) {
  Picture picture = square_picture();
  const std::string svg = svg_text(drawn(picture));
  EXPECT_NE(svg.find("a &lt;square> &amp; more"), std::string::npos);
  EXPECT_NE(svg.find("fill-rule=\"evenodd\""), std::string::npos);
  picture.areas[0].rule = FillRule::non_zero;
  picture.legend.clear();
  EXPECT_EQ(svg_text(drawn(picture)).find("fill-rule"), std::string::npos);
}

TEST(Pixels, AreCoveredByArea) {
  Drawing drawing{.width = 8, .height = 4};
  drawing.marks.emplace_back(Fill{{{{1, 1}, {3, 1}, {3, 2}, {1, 2}}}, FillRule::non_zero, Colour{}});
  drawing.marks.emplace_back(Fill{{{{5, 0}, {6.5, 0}, {6.5, 4}, {5, 4}}}, FillRule::non_zero, Colour{255, 0, 0, 0.5}});
  const Pixels pixels = rasterised(drawing);
  ASSERT_EQ(pixels.width, 8);
  ASSERT_EQ(pixels.height, 4);
  const auto at = [&](int x, int y, int channel) {
    return int{pixels.rgb[static_cast<std::size_t>((y * 8 + x) * 3 + channel)]};
  };
  EXPECT_EQ(at(0, 0, 0), 255);
  EXPECT_EQ(at(1, 1, 0), 0);
  EXPECT_EQ(at(2, 1, 1), 0);
  EXPECT_EQ(at(3, 1, 0), 255);
  EXPECT_NEAR(at(5, 2, 1), 128, 1);
  EXPECT_NEAR(at(6, 2, 1), 191, 1) << "half covered, half opaque";
  EXPECT_EQ(at(6, 2, 0), 255);
}

TEST(Pixels, AStrokeHasItsWidth) {
  Drawing drawing{.width = 40, .height = 20};
  drawing.marks.emplace_back(Stroke{{{5, 10}, {35, 10}}, false, Colour{}, 4});
  const Pixels pixels = rasterised(drawing);
  double dark = 0;
  for (std::size_t i = 0; i < pixels.rgb.size(); i += 3) dark += 1 - pixels.rgb[i] / 255.0;
  EXPECT_NEAR(dark, 30 * 4 + 3.14159 * 4, 2);
}

TEST(Pixels, DashesAreHalfOfALine) {
  const Stroke stroke{{{0, 0}, {60, 0}, {60, 20}}, false, {}, 1, 4};
  double length = 0;
  for (const Ring& ring : outline(stroke))
    if (ring.size() == 4) length += glm::length(ring[1] - ring[0]);
  EXPECT_NEAR(length, 40, 4);
}

TEST(StrokeFont, EveryLetterHasAShapeAndAWidth) {
  for (char c = '!'; c <= '~'; ++c) {
    const std::vector<Ring> strokes = text_strokes({&c, 1}, {0, 0}, 10);
    EXPECT_FALSE(strokes.empty()) << c;
    for (const Ring& stroke : strokes)
      for (const Vec2d p : stroke) {
        EXPECT_GE(p.y, -7.1) << c;
        EXPECT_LE(p.y, 2.5) << c;
      }
  }
  EXPECT_TRUE(text_strokes(" ", {0, 0}, 10).empty());
  EXPECT_GT(text_width("10", 10), text_width("1", 10));
  EXPECT_NEAR(text_width("abcdefghij0123456789", 11), 20 * 0.58 * 11, 20);
}

}  // namespace
}  // namespace lambert::draw
