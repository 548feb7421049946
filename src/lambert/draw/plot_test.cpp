#include "lambert/draw/plot.h"

#include "lambert/draw/axis_scale.h"
#include "lambert/draw/pixels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::draw {
namespace {

template <class Mark>
std::vector<Mark> marks_of(const Drawing& drawing) {
  std::vector<Mark> found;
  for (const auto& mark : drawing.marks)
    if (const auto* m = std::get_if<Mark>(&mark)) found.push_back(*m);
  return found;
}

bool says(const Drawing& drawing, const std::string& text) {
  for (const Words& words : marks_of<Words>(drawing))
    if (words.text == text) return true;
  return false;
}

TEST(AxisScale, StepsAreRound) {
  EXPECT_DOUBLE_EQ(round_step(1), 1);
  EXPECT_DOUBLE_EQ(round_step(1.6), 2);
  EXPECT_DOUBLE_EQ(round_step(0.03), 0.02);
  EXPECT_DOUBLE_EQ(round_step(480), 500);
}

TEST(AxisScale, MapsTheEndsToThePixelsGiven) {
  const AxisScale linear({.label = "", .logarithmic = false, .low = -1, .high = 3}, {}, 10, 50);
  EXPECT_DOUBLE_EQ(linear.pixel(-1), 10);
  EXPECT_DOUBLE_EQ(linear.pixel(1), 30);
  const AxisScale logarithmic({.label = "", .logarithmic = true, .low = 1e-2, .high = 1e2}, {}, 0, 100);
  EXPECT_DOUBLE_EQ(logarithmic.pixel(1), 50);
  EXPECT_FALSE(std::isfinite(logarithmic.pixel(-1)));
}

TEST(AxisScale, TicksAreWrittenWhereTheyLie) {
  const AxisScale scale({.label = "", .logarithmic = true, .low = 1, .high = 1000}, {}, 0, 300);
  std::vector<std::string> written;
  for (const auto& [pixel, text] : scale.ticks(60)) {
    if (text.empty()) continue;
    written.push_back(text);
    EXPECT_NEAR(pixel, 100 * std::log10(std::stod(text)), 1e-9);
  }
  EXPECT_EQ(written, (std::vector<std::string>{"1", "10", "100", "1000"}));
}

TEST(Plot, NamesAxesSeriesAndTitle) {
  const Drawing drawing = drawn(Plot{.title = "error",
                                     .x = {.label = "samples", .logarithmic = true},
                                     .y = {.label = "rms", .logarithmic = true},
                                     .series = {{.name = "jittered", .points = {{1, 1}, {10, 0.1}, {100, 0.01}}}}});
  for (const char* text : {"error", "samples", "rms", "jittered", "100", "0.01"})
    EXPECT_TRUE(says(drawing, text)) << text;
}

TEST(Plot, LinesEndAtTheAxesAndAtGaps) {
  const Drawing drawing =
      drawn(Plot{.x = {.label = "", .low = 0, .high = 1},
                 .y = {.label = "", .low = 0, .high = 1},
                 .series = {{.points = {{-1, 0.5}, {0.5, 0.5}, {NAN, 0}, {0.6, 0.5}, {0.6, 9}}, .width = 7}}});
  std::vector<Stroke> lines;
  for (const Stroke& s : marks_of<Stroke>(drawing))
    if (s.width == 7) lines.push_back(s);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_DOUBLE_EQ(lines[0].points.front().x, 64);
  EXPECT_DOUBLE_EQ(lines[1].points.back().y, 14);
}

TEST(Plot, DrawsAnyData) {
  const double big = 1e308;
  for (const std::vector<Vec2d>& points :
       {std::vector<Vec2d>{}, {{0, 0}}, {{NAN, INFINITY}}, {{-big, -big}, {big, big}}, {{1e-320, 0}, {0, 1e-320}}})
    for (const bool logarithmic : {false, true}) {
      const Drawing drawing = drawn(Plot{.x = {.label = "x", .logarithmic = logarithmic},
                                         .y = {.label = "y", .logarithmic = logarithmic},
                                         .series = {{.name = "s", .points = points}}});
      EXPECT_EQ(rasterised(drawing).width, 640);
    }
}

TEST(Plot, AreasEndAtZeroAndAtTheAxes) {
  const Axis x{.label = "", .low = 0, .high = 10}, y{.label = "", .low = -1, .high = 4};
  const Drawing drawing = drawn(Plot{
      .title = "", .x = x, .y = y, .series = {{.name = "", .points = {{2, 1}, {4, 9}}, .mark = Series::Mark::area}}});
  const std::vector<Fill> fills = marks_of<Fill>(drawing);
  ASSERT_EQ(fills.size(), 1u);
  Box2 covered;
  for (const Vec2d p : fills[0].rings.at(0)) covered.add(p);
  Box2 axes;
  for (const Stroke& stroke : marks_of<Stroke>(drawing))
    if (stroke.closed)
      for (const Vec2d p : stroke.points) axes.add(p);
  const double unit_x = (axes.max.x - axes.min.x) / 10, unit_y = (axes.max.y - axes.min.y) / 5;
  EXPECT_NEAR(covered.min.x, axes.min.x + 2 * unit_x, 1e-9);
  EXPECT_NEAR(covered.max.x, axes.min.x + 4 * unit_x, 1e-9);
  EXPECT_NEAR(covered.max.y, axes.max.y - unit_y, 1e-9) << "at 0, above the axis";
  EXPECT_NEAR(covered.min.y, axes.min.y, 1e-9) << "cut where the axis ends";
}

}  // namespace
}  // namespace lambert::draw
