/// What goes wrong in images made of samples, and what helps.

#include "lambert/draw/montage.h"
#include "lambert/draw/plot.h"
#include "lambert/image/filter/blur.h"
#include "lambert/lab/demo.h"
#include "lambert/lab/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambert::lab {
namespace {

using draw::magnified;
using draw::Panel;

constexpr double pi_d = std::numbers::pi;

/// One above the other.
Image stacked(const Image& above, const Image& below, int gap) {
  Image image(std::max(above.width(), below.width()), above.height() + gap + below.height(), rgb_channels());
  for (float& v : image.pixels()) v = 1;
  const auto paste = [&](const Image& from, int top) {
    for (int y = 0; y < from.height(); ++y)
      for (int x = 0; x < from.width(); ++x) image.set_rgb(x, top + y, from.rgb(x, y));
  };
  paste(above, 0);
  paste(below, above.height() + gap);
  return image;
}

}  // namespace

Shown show_nyquist(const LabSettings&) {
  constexpr double length = 10;  // cycles of a sine of frequency 1
  Shown shown;
  std::vector<draw::Drawing> rows;
  for (const auto& [words, rate] : {std::pair{"closely spaced", 8.0}, std::pair{"widely spaced", 2.2},
                                    std::pair{"very widely spaced", 1.3}, std::pair{"extremely widely spaced", 1.05}}) {
    // Signed: a folded sine may run backwards.
    const double folded = 1 - rate * std::round(1 / rate);
    std::vector<Vec2d> signal, alias, samples;
    for (int i = 0; i <= 1000; ++i) {
      const double t = length * i / 1000;
      signal.emplace_back(t, std::sin(2 * pi_d * t));
      alias.emplace_back(t, std::sin(2 * pi_d * folded * t));
    }
    for (int i = 0; i / rate <= length; ++i) samples.emplace_back(i / rate, std::sin(2 * pi_d * i / rate));
    rows.push_back(drawn(draw::Plot{
        .title = fmt::format("{}: {:g} samples a cycle show a frequency of {:.3g}", words, rate, std::abs(folded)),
        .x = {.label = "cycles of the sine (grey); dots: samples; dashed: what they show", .low = 0, .high = length},
        .y = {.label = "", .low = -1.15, .high = 1.15},
        .series =
            {{.points = signal, .colour = draw::Colour{175, 184, 193}},
             {.points = alias, .colour = draw::series_colour(1), .dashed = true},
             {.points = samples, .mark = draw::Series::Mark::points, .colour = draw::series_colour(0), .width = 2.2}},
        .width = 720,
        .height = 190}));
    shown.facts.emplace_back(fmt::format("frequency shown at {:g} samples a cycle", rate), alias_frequency(1, rate));
  }
  shown.picture = draw::side_by_side(rows, 1);
  return shown;
}

Shown show_detail(const LabSettings& settings) {
  constexpr int width = 96, height = 72;
  const Scene scene = small_details(width, height);
  const Image truth = sampled(scene, width, height, {PatternKind::jittered, 256, settings.seed});
  const Image one = sampled(scene, width, height, {PatternKind::regular, 1, settings.seed});
  const Image blurred = box_blurred(one, {1, 1});
  const Image nine = sampled(scene, width, height, {PatternKind::regular, 9, settings.seed});
  const std::vector<Panel> panels{{"256 samples a pixel", magnified(truth, 4)},
                                  {"1 sample at the centre", magnified(one, 4)},
                                  {"the same, blurred afterwards", magnified(blurred, 4)},
                                  {"9 samples, averaged", magnified(nine, 4)}};
  return {montage(panels, {.columns = 2}),
          {{"rms error, 1 sample", rms_difference(one, truth)},
           {"rms error, blurred", rms_difference(blurred, truth)},
           {"rms error, 9 samples", rms_difference(nine, truth)}}};
}

Shown show_moire(const LabSettings& settings) {
  std::vector<Panel> panels;
  const auto add = [&](const std::string& name, const Lines& above) {
    panels.push_back(
        {name, sampled(moire({.period = 6}, above), 200, 150, {PatternKind::jittered, 16, settings.seed})});
  };
  for (const double shift : {0.0, 1.5, 3.0, 4.5})
    add(fmt::format("5.7 pixels slid by {:g}", shift), {.period = 5.7, .shift = shift});
  for (const double turn : {1.0, 2.0, 4.0, 8.0})
    add(fmt::format("turned by {:g} degree{}", turn, turn == 1 ? "" : "s"), {.period = 6, .angle = turn * pi_d / 180});
  return {montage(panels, {.columns = 4, .caption_size = 12}),
          // Bands where the layers fall in step, by the difference of their frequencies.
          {{"bands of the slid layers, pixels", 1 / (1 / 5.7 - 1.0 / 6)},
           {"bands of the layers turned by 4 degrees, pixels", 6 / (2 * std::sin(2 * pi_d / 180))}}};
}

Shown show_comb(const LabSettings& settings) {
  constexpr int width = 52, height = 52, long_width = 208;
  std::vector<Panel> panels;
  for (const int samples : {1, 16})
    for (const PatternKind kind : {PatternKind::regular, PatternKind::jittered}) {
      const auto image = [&](int teeth, int columns) {
        return sampled(comb({.teeth = teeth, .top = 1}), columns, height, {kind, samples, settings.seed});
      };
      panels.push_back(
          {fmt::format("{} grid, {} sample{} a pixel", kind == PatternKind::regular ? "regular" : "jittered", samples,
                       samples == 1 ? "" : "s"),
           stacked(magnified(image(50, width), 4), magnified(image(202, long_width), 1), 6)});
    }
  const double period = alias_period(Comb{}.pitch);
  return {montage(panels, {.columns = 4}),
          {{"false period, pixels", period}, {"false frequency, per pixel", 1 / period}}};
}

Shown show_pixel(const LabSettings& settings) {
  // The corner of a red shape covers a little of the pixel: two of the nine cell centres lie in it.
  const polygon::Ring red{{0.2, 0}, {1, 0}, {1, 0.48}};
  const auto is_red = [](Vec2 p) { return static_cast<double>(p.y) < 0.6 * (static_cast<double>(p.x) - 0.2); };
  const auto count = [&](const std::vector<Vec2>& points) {
    return std::count_if(points.begin(), points.end(), is_red);
  };
  // The notes show a jittered pixel of which one sample is red; the first seed that gives one.
  std::uint64_t seed = settings.seed;
  while (count(jittered_points(3, seed)) != 1) ++seed;

  const auto drawing = [&](const std::string& name, const std::vector<Vec2>& points) {
    constexpr double size = 240, left = 20, top = 34;
    const auto at = [&](Vec2d p) { return Vec2d(left, top) + size * p; };
    draw::Drawing d{.width = size + 2 * left, .height = size + top + 34, .marks = {}};
    polygon::Ring square{at({0, 0}), at({1, 0}), at({1, 1}), at({0, 1})}, part;
    for (const Vec2d p : red) part.push_back(at(p));
    d.marks.emplace_back(draw::Fill{.rings = {square}, .colour = {250, 226, 120}});
    d.marks.emplace_back(draw::Fill{.rings = {part}, .colour = {214, 70, 60}});
    for (int i = 0; i <= 3; ++i) {
      d.marks.emplace_back(draw::Stroke{.points = {at({i / 3.0, 0}), at({i / 3.0, 1})}, .colour = {90, 90, 90}});
      d.marks.emplace_back(draw::Stroke{.points = {at({0, i / 3.0}), at({1, i / 3.0})}, .colour = {90, 90, 90}});
    }
    for (const Vec2 p : points)
      d.marks.emplace_back(
          draw::Disk{at(Vec2d(p)), 5, is_red(p) ? draw::Colour{130, 10, 10} : draw::Colour{60, 50, 0}});
    d.marks.emplace_back(draw::Words{{left, 22}, name, {36, 41, 47}, 14});
    const auto reds = count(points);
    d.marks.emplace_back(
        draw::Words{{left, top + size + 22}, fmt::format("{}/9 red + {}/9 yellow", reds, 9 - reds), {36, 41, 47}, 14});
    return d;
  };
  const auto regular = regular_points(3), jittered = jittered_points(3, seed);
  return {draw::side_by_side({drawing("regular", regular), drawing("jittered", jittered)}, 2),
          {{"red by regular samples", static_cast<double>(count(regular)) / 9},
           {"red by jittered samples", static_cast<double>(count(jittered)) / 9},
           {"red by area", 0.5 * 0.8 * 0.48}}};
}

Shown show_jitter(const LabSettings& settings) {
  constexpr int width = 160, height = 120;
  const Scene scene = checkered_plane(width, height);
  const Image truth = sampled(scene, width, height, {PatternKind::jittered, 256, settings.seed});
  std::vector<Panel> panels{{"256 samples a pixel", magnified(truth, 2)}};
  Shown shown;
  const auto add = [&](const std::string& name, PatternKind kind, int samples) {
    const Image image = sampled(scene, width, height, {kind, samples, settings.seed + 1});
    panels.push_back({name, magnified(image, 2)});
    shown.facts.emplace_back("rms error, " + name, rms_difference(image, truth));
  };
  add("1 uniform, no jitter", PatternKind::regular, 1);
  add("1 jittered", PatternKind::jittered, 1);
  add("4 random", PatternKind::random, 4);
  add("4 uniform", PatternKind::regular, 4);
  add("4 jittered", PatternKind::jittered, 4);
  shown.picture = montage(panels, {.columns = 3});
  return shown;
}

}  // namespace lambert::lab
