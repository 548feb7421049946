/// What numbers of a file hold of light: how exactly, and from which brightness to which.

#include "lambert/draw/axis_scale.h"
#include "lambert/draw/plot.h"
#include "lambert/lab/demo.h"
#include "lambert/lab/pixel_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lambert::lab {
namespace {

constexpr int first_octave = -34, last_octave = 34;

draw::Series error_series(const std::string& name, const std::vector<OctaveError>& errors) {
  draw::Series series{.name = name};
  for (const OctaveError& e : errors) series.points.emplace_back(e.radiance, e.error);
  return series;
}

void add_errors(Shown& shown, const std::string& name, const std::vector<OctaveError>& errors) {
  for (const int octave : {-10, -1, 9})
    shown.facts.emplace_back(fmt::format("octave 2^{}, {}", octave, name),
                             errors[static_cast<std::size_t>(octave - first_octave)].error);
}

/// Row LF-15: 8 bits are 8 million short of it, 12 bits 500 thousand.
constexpr double real_world_ratio = 2.048e9;

/// The ends of the worked example's radiance map (row LF-17).
hdr::RadianceRange example_map() {
  Image map(2, 1, {"Y"});
  map.at(0, 0, 0) = 121.741f;
  map.at(1, 0, 0) = 0.005f;
  return hdr::radiance_range(map);
}

struct Bar {
  std::string name, words;
  double ratio = 1;
  draw::Colour colour;
};

constexpr draw::Colour of_light{219, 109, 40}, of_integers{9, 105, 218}, of_floats{26, 127, 55}, ink{36, 41, 47},
    white{255, 255, 255}, faint{226, 230, 235}, grey{110, 119, 129};

/// Bars from 1 on a logarithmic axis, a line at the real world's; those that leave the axis carry their words inside.
draw::Drawing bars(const std::string& title, const std::vector<Bar>& all) {
  constexpr double left = 172, right = 812, top = 40, row = 30, half = 9;
  constexpr int decades = 18;
  const double bottom = top + row * static_cast<double>(all.size());
  const draw::AxisScale scale({.label = "", .logarithmic = true, .low = 1, .high = std::pow(10.0, decades)}, {}, left,
                              right);
  draw::Drawing d{.width = right + 18, .height = bottom + 46, .marks = {}};
  const auto upright = [&](double x, const draw::Colour& colour, double dash) {
    d.marks.emplace_back(draw::Stroke{.points = {{x, top}, {x, bottom}}, .colour = colour, .width = 1, .dash = dash});
  };
  const auto middle = [&](std::size_t i) { return top + row * (static_cast<double>(i) + 0.5); };
  for (int k = 0; k <= decades; k += 3) {
    const double x = scale.pixel(std::pow(10.0, k));
    upright(x, faint, 0);
    const std::string text = k == 0 ? "1" : fmt::format("1e{}", k);
    d.marks.emplace_back(draw::Words{{x, bottom + 15}, text, grey, 11, draw::Anchor::middle});
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double y = middle(i), end = scale.pixel(all[i].ratio);
    polygon::Ring outline{{left, y - half}, {end, y - half}, {end, y + half}, {left, y + half}};
    if (end > right)
      outline = {{left, y - half}, {right - half, y - half}, {right, y}, {right - half, y + half}, {left, y + half}};
    d.marks.emplace_back(draw::Fill{.rings = {outline}, .rule = draw::FillRule::non_zero, .colour = all[i].colour});
  }
  upright(scale.pixel(real_world_ratio), ink, 5);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double y = middle(i) + 4, end = scale.pixel(all[i].ratio);
    d.marks.emplace_back(draw::Words{{left - 8, y}, all[i].name, ink, 12, draw::Anchor::end});
    if (end > right)
      d.marks.emplace_back(draw::Words{{right - 2 * half, y}, all[i].words, white, 11, draw::Anchor::end});
    else
      d.marks.emplace_back(draw::Words{{end + 6, y}, all[i].words, ink, 11, draw::Anchor::start, true});
  }
  d.marks.emplace_back(draw::Words{{10, 20}, title, ink, 14});
  d.marks.emplace_back(
      draw::Words{{(left + right) / 2, bottom + 36}, "largest number over smallest", ink, 12, draw::Anchor::middle});
  return d;
}

std::string short_by(double ratio) {
  const double factor = real_world_ratio / ratio;
  const std::string words = factor >= 1e6   ? fmt::format("{:.3g} million", factor / 1e6)
                            : factor >= 1e5 ? fmt::format("{:.3g} thousand", factor / 1e3)
                                            : fmt::format("{:.0f}", factor);
  return fmt::format("{:.6g}, short by {}", ratio, words);
}

}  // namespace

Shown show_precision(const LabSettings&) {
  draw::Plot plot{.title = "What image files keep of light",
                  .x = {.label = "radiance", .logarithmic = true, .low = 1e-10, .high = 1e10},
                  .y = {.label = "worst relative error in an octave", .logarithmic = true, .low = 2e-12, .high = 3.0},
                  .series = {},
                  .width = 720,
                  .height = 480};
  Shown shown;
  for (const PixelFormat& format : pixel_formats()) {
    const auto errors = octave_errors(format, first_octave, last_octave);
    plot.series.push_back(
        error_series(fmt::format("{}, {} bytes a pixel", format.name, format.bytes_per_pixel), errors));
    add_errors(shown, format.name, errors);
  }
  const auto beside = octave_errors(pixel_formats()[2], first_octave, last_octave, 100);
  draw::Series series = error_series("RGBE, beside channels 100 times as bright", beside);
  series.colour = draw::series_colour(2);
  series.dashed = true;
  plot.series.push_back(std::move(series));
  add_errors(shown, "RGBE beside channels 100 times as bright", beside);
  shown.picture = drawn(plot);
  return shown;
}

Shown show_range(const LabSettings&) {
  const hdr::RadianceRange map = example_map();
  std::vector<Bar> all{{"the real world", "2.05e9: 256 times 8 million", real_world_ratio, of_light},
                       {"a radiance map", fmt::format("{:.6g}: {:g} to {:g}", map.ratio(), map.min_positive, map.max),
                        map.ratio(), of_light}};
  Shown shown{{},
              {{"ratio of the radiance map", map.ratio()}, {"one of 256 equal steps over it", hdr::step_size(map, 8)}}};
  for (const int bits : {8, 12}) {
    all.push_back({fmt::format("{} bits, equal steps", bits), short_by(std::exp2(bits)), std::exp2(bits), of_integers});
    shown.facts.emplace_back(fmt::format("{} bits are short of the real world by", bits),
                             hdr::shortfall(real_world_ratio, bits));
  }
  for (const PixelFormat& format : pixel_formats()) {
    const hdr::RadianceRange kept = kept_range(format);
    const bool enough = kept.ratio() >= real_world_ratio;
    all.push_back({format.name,
                   enough ? fmt::format("{:.2g}: {:.2g} to {:.5g}", kept.ratio(), kept.min_positive, kept.max)
                          : short_by(kept.ratio()),
                   kept.ratio(), enough ? of_floats : of_integers});
    shown.facts.emplace_back("smallest number, " + format.name, kept.min_positive);
    shown.facts.emplace_back("largest number, " + format.name, kept.max);
    shown.facts.emplace_back("decades, " + format.name, std::log10(kept.ratio()));
  }
  shown.picture = bars("The dynamic range that numbers hold", all);
  return shown;
}

}  // namespace lambert::lab
