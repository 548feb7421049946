#include "lambert/draw/plot.h"

#include "lambert/draw/axis_scale.h"
#include "lambert/draw/stroke_font.h"
#include "lambert/polygon/clip/half_plane_clip.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert::draw {
namespace {

constexpr Colour black{36, 41, 47}, grey{110, 119, 129}, faint{226, 230, 235};
constexpr double label_size = 12, tick_size = 11;

/// The part of a segment inside of the box (Liang and Barsky 1984); false when there is none.
bool clip(const Box2& box, Vec2d& a, Vec2d& b) {
  double enter = 0, leave = 1;
  const Vec2d direction = b - a;
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const double speed = side * direction[axis];
      const double room = side < 0 ? a[axis] - box.min[axis] : box.max[axis] - a[axis];
      if (speed == 0 && room < 0) return false;
      if (speed > 0) leave = std::min(leave, room / speed);
      if (speed < 0) enter = std::max(enter, room / speed);
    }
  if (enter > leave) return false;
  b = a + leave * direction;
  a = a + enter * direction;
  return true;
}

class Artist {
 public:
  explicit Artist(const Plot& plot)
      : plot_(plot),
        area_(room(plot)),
        x_(scale(plot.x, 0, area_.min.x, area_.max.x)),
        y_(scale(plot.y, 1, area_.max.y, area_.min.y)) {
    drawing_.width = plot.width;
    drawing_.height = plot.height;
  }

  Drawing finish() {
    draw_axes();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_series(plot_.series[i], colour(i));
    draw_legend();
    if (!plot_.title.empty()) words({10, 20}, plot_.title, 14, Anchor::start);
    return std::move(drawing_);
  }

 private:
  static Box2 room(const Plot& plot) {
    Box2 box;
    const double top = (plot.title.empty() ? 14 : 34) + (plot.y.label.empty() ? 0 : 18);
    box.add({64, top});
    box.add({std::max(96.0, plot.width - 18), std::max(80.0, plot.height - 46)});
    return box;
  }
  AxisScale scale(const Axis& axis, int c, double begin, double end) const {
    std::vector<double> values;
    for (const Series& s : plot_.series)
      for (const Vec2d p : s.points) values.push_back(p[c]);
    return {axis, values, begin, end};
  }
  Colour colour(std::size_t i) const { return plot_.series[i].colour.value_or(series_colour(i)); }

  void words(Vec2d at, const std::string& text, double size, Anchor anchor) {
    drawing_.marks.emplace_back(Words{at, text, size == tick_size ? grey : black, size, anchor});
  }
  void stroke(Ring points, const Colour& c, double width, double dash = 0, bool closed = false) {
    drawing_.marks.emplace_back(Stroke{std::move(points), closed, c, width, dash});
  }

  void draw_axes() {
    for (const auto& [x, text] : x_.ticks(64)) {
      stroke({{x, area_.min.y}, {x, area_.max.y}}, faint, text.empty() ? 0.5 : 1);
      if (!text.empty()) words({x, area_.max.y + 15}, text, tick_size, Anchor::middle);
    }
    for (const auto& [y, text] : y_.ticks(36)) {
      stroke({{area_.min.x, y}, {area_.max.x, y}}, faint, text.empty() ? 0.5 : 1);
      if (!text.empty()) words({area_.min.x - 6, y + 4}, text, tick_size, Anchor::end);
    }
    stroke({area_.min, {area_.max.x, area_.min.y}, area_.max, {area_.min.x, area_.max.y}}, grey, 1, 0, true);
    words({(area_.min.x + area_.max.x) / 2, area_.max.y + 36}, plot_.x.label, label_size, Anchor::middle);
    // Upright letters stay readable in pixels: the label of y stands above its axis.
    words({10, area_.min.y - 8}, plot_.y.label, label_size, Anchor::start);
  }

  void draw_series(const Series& s, const Colour& c) {
    const bool lines = s.mark != Series::Mark::points && s.mark != Series::Mark::area;
    const bool points = s.mark == Series::Mark::points || s.mark == Series::Mark::line_and_points;
    std::vector<Vec2d> at;
    for (const Vec2d p : s.points) {
      const Vec2d next{x_.pixel(p.x), y_.pixel(p.y)};
      if (s.mark == Series::Mark::steps && !at.empty()) at.emplace_back(next.x, at.back().y);
      at.push_back(next);
    }
    if (lines) draw_line(at, c, s);
    if (s.mark == Series::Mark::area) draw_area(at, c);
    if (!points) return;
    for (const Vec2d p : at)
      if (p.x >= area_.min.x && p.x <= area_.max.x && p.y >= area_.min.y && p.y <= area_.max.y)
        drawing_.marks.emplace_back(Disk{p, 1.5 * s.width, c});
  }

  void draw_line(const std::vector<Vec2d>& at, const Colour& c, const Series& s) {
    Ring run;
    const auto end_run = [&] {
      if (run.size() > 1) stroke(run, c, s.width, s.dashed ? 5 : 0);
      run.clear();
    };
    for (std::size_t i = 1; i < at.size(); ++i) {
      Vec2d a = at[i - 1], b = at[i];
      const bool seen = std::isfinite(a.x + a.y + b.x + b.y) && clip(area_, a, b);
      if (!seen || run.empty() || run.back() != a) end_run();
      if (!seen) continue;
      if (run.empty()) run.push_back(a);
      run.push_back(b);
    }
    end_run();
  }

  void draw_area(const std::vector<Vec2d>& at, const Colour& c) {
    const double zero = y_.pixel(0), base = std::isfinite(zero) ? zero : area_.max.y;
    const std::array sides{polygon::keep_x_from(area_.min.x), polygon::keep_x_to(area_.max.x),
                           polygon::keep_y_from(area_.min.y), polygon::keep_y_to(area_.max.y)};
    Ring run;
    const auto end_run = [&] {
      if (run.size() > 1) {
        const double first = run.front().x, last = run.back().x;
        run.emplace_back(last, base);
        run.emplace_back(first, base);
        drawing_.marks.emplace_back(
            Fill{.rings = {polygon::sutherland_hodgman(run, sides)}, .rule = FillRule::non_zero, .colour = c});
      }
      run.clear();
    };
    for (const Vec2d p : at) {
      if (std::isfinite(p.x + p.y))
        run.push_back(p);
      else
        end_run();
    }
    end_run();
  }

  /// In the corner with the fewest data.
  void draw_legend() {
    double width = 0;
    std::size_t lines = 0;
    for (const Series& s : plot_.series) {
      if (s.name.empty()) continue;
      width = std::max(width, text_width(s.name, tick_size));
      ++lines;
    }
    if (lines == 0) return;
    const Vec2d size{width + 40, 16 * static_cast<double>(lines) + 8};
    const std::array<Vec2d, 4> corners{
        Vec2d(area_.max.x - size.x - 6, area_.min.y + 6), Vec2d(area_.min.x + 6, area_.min.y + 6),
        Vec2d(area_.max.x - size.x - 6, area_.max.y - size.y - 6), Vec2d(area_.min.x + 6, area_.max.y - size.y - 6)};
    const Vec2d corner = *std::min_element(corners.begin(), corners.end(),
                                           [&](Vec2d a, Vec2d b) { return covered(a, size) < covered(b, size); });
    drawing_.marks.emplace_back(
        Fill{.rings = {{corner, corner + Vec2d(size.x, 0), corner + size, corner + Vec2d(0, size.y)}},
             .rule = FillRule::even_odd,
             .colour = Colour{255, 255, 255, 0.85}});
    double y = corner.y + 17;
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      const Series& s = plot_.series[i];
      if (s.name.empty()) continue;
      const Vec2d middle{corner.x + 17, y - 4};
      if (s.mark == Series::Mark::area)
        drawing_.marks.emplace_back(Fill{
            .rings = {{middle - Vec2d(10, 5), middle + Vec2d(10, -5), middle + Vec2d(10, 5), middle + Vec2d(-10, 5)}},
            .rule = FillRule::non_zero,
            .colour = colour(i)});
      else if (s.mark != Series::Mark::points)
        stroke({middle - Vec2d(10, 0), middle + Vec2d(10, 0)}, colour(i), s.width, s.dashed ? 5 : 0);
      if (s.mark == Series::Mark::points || s.mark == Series::Mark::line_and_points)
        drawing_.marks.emplace_back(Disk{middle, 1.5 * s.width, colour(i)});
      words({corner.x + 34, y}, s.name, tick_size, Anchor::start);
      y += 16;
    }
  }

  std::size_t covered(Vec2d corner, Vec2d size) const {
    std::size_t count = 0;
    for (const Series& s : plot_.series)
      for (const Vec2d p : s.points) {
        const double x = x_.pixel(p.x), y = y_.pixel(p.y);
        if (x > corner.x && x < corner.x + size.x && y > corner.y && y < corner.y + size.y) ++count;
      }
    return count;
  }

  const Plot& plot_;
  Box2 area_;
  AxisScale x_, y_;
  Drawing drawing_;
};

}  // namespace

Colour series_colour(std::size_t index) {
  // Blue, orange, green, red, purple, brown, teal, grey: told apart by most eyes, also on white paper.
  static constexpr std::array<Colour, 8> colours{Colour{9, 105, 218},  Colour{219, 109, 40}, Colour{26, 127, 55},
                                                 Colour{207, 34, 46},  Colour{130, 80, 223}, Colour{133, 77, 14},
                                                 Colour{17, 138, 135}, Colour{110, 119, 129}};
  return colours[index % colours.size()];
}

Drawing drawn(const Plot& plot) { return Artist(plot).finish(); }

}  // namespace lambert::draw
