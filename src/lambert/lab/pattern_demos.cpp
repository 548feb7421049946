/// Point patterns, what their spectra are, and how their errors fall.

#include "lambert/base/parallel.h"
#include "lambert/draw/montage.h"
#include "lambert/draw/pixels.h"
#include "lambert/draw/plot.h"
#include "lambert/lab/demo.h"
#include "lambert/lab/periodogram.h"
#include "lambert/lab/scenes.h"
#include "lambert/polygon/clip/half_plane_clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lambert::lab {
namespace {

constexpr double pi_d = std::numbers::pi;
constexpr std::array<PatternKind, 6> kinds{PatternKind::regular,        PatternKind::random,
                                           PatternKind::jittered,       PatternKind::poisson_disk,
                                           PatternKind::best_candidate, PatternKind::sobol};

std::string name_of(PatternKind kind) { return pattern_names()[static_cast<std::size_t>(kind)]; }

/// The points as dots on a square of `size` pixels.
draw::Drawing dots(const std::vector<Vec2>& points, double size) {
  draw::Drawing d{.width = size, .height = size, .marks = {}};
  d.marks.emplace_back(
      draw::Stroke{.points = {{0.5, 0.5}, {size - 0.5, 0.5}, {size - 0.5, size - 0.5}, {0.5, size - 0.5}},
                   .closed = true,
                   .colour = {200, 206, 212}});
  for (const Vec2 p : points) d.marks.emplace_back(draw::Disk{size * Vec2d(p), 1.8, {20, 60, 130}});
  return d;
}

constexpr int reach = 64, sets = 48, points_a_set = 256;

/// The mean over many sets; regular points are the same each time.
std::vector<double> mean_spectrum(PatternKind kind, std::uint64_t seed) {
  std::vector<std::vector<double>> each(kind == PatternKind::regular ? 1 : sets);
  parallel_for(each.size(), [&](std::size_t i) {
    each[i] = periodogram(pattern_points(kind, points_a_set, seed * 1000 + i), reach);
  });
  std::vector<double> mean(each[0].size());
  for (const std::vector<double>& one : each)
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += one[i] / static_cast<double>(each.size());
  return mean;
}

/// Power 1, that of random points, is middle grey; 0, where the constant is left out, black.
Image spectrum_image(const std::vector<double>& power) {
  constexpr int side = 2 * reach + 1;
  Image image(side, side, rgb_channels());
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const bool constant = x == reach && y == reach;
      const double p = constant ? 0 : power[static_cast<std::size_t>(y * side + x)];
      image.set_rgb(x, y, Rgb(static_cast<float>(std::min(1.0, 0.25 * p))));
    }
  return image;
}

/// The part of the unit square left of a line at an angle through a point.
double coverage(Vec2d through, double angle) {
  const polygon::Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Vec2d along(std::cos(angle), std::sin(angle));
  return std::abs(
      polygon::signed_area(polygon::sutherland_hodgman(square, polygon::ClipLine{through, through + along})));
}

/// The rms error of the coverage of a pixel by random edges.
double edge_error(PatternKind kind, int count, std::uint64_t seed) {
  constexpr int patterns = 24, edges = 64;
  std::vector<double> squares(patterns);
  parallel_for(patterns, [&](std::size_t i) {
    const auto points = pattern_points(kind, count, seed * 100 + i);
    const auto places = random_points(2 * edges, seed * 100 + i + 5000);
    for (std::size_t e = 0; e < edges; ++e) {
      const Vec2d through(places[2 * e]);
      const double angle = 2 * pi_d * static_cast<double>(places[2 * e + 1].x);
      const Vec2d along(std::cos(angle), std::sin(angle));
      const auto inside = std::count_if(points.begin(), points.end(), [&](Vec2 p) {
        const Vec2d d = Vec2d(p) - through;
        return along.x * d.y - along.y * d.x > 0;
      });
      const double error = static_cast<double>(inside) / static_cast<double>(points.size()) - coverage(through, angle);
      squares[i] += error * error / edges;
    }
  });
  double sum = 0;
  for (const double s : squares) sum += s / patterns;
  return std::sqrt(sum);
}

}  // namespace

Shown show_patterns(const LabSettings& settings) {
  Shown shown;
  std::vector<draw::Panel> panels;
  for (const PatternKind kind : kinds) {
    const auto points = pattern_points(kind, 256, settings.seed);
    panels.push_back({name_of(kind), to_image(rasterised(dots(points, 220)))});
    shown.facts.emplace_back("smallest separation in sixteenths, " + name_of(kind), 16 * smallest_separation(points));
  }
  shown.picture = montage(panels, {.columns = 3});
  return shown;
}

Shown show_spectra(const LabSettings& settings) {
  std::vector<draw::Panel> above, panels;
  Shown shown;
  for (const PatternKind kind : kinds) {
    panels.push_back(
        {name_of(kind), to_image(rasterised(dots(pattern_points(kind, points_a_set, settings.seed), 129)))});
    const auto power = mean_spectrum(kind, settings.seed);
    above.push_back({fmt::format("-{0} to {0} cycles", reach), spectrum_image(power)});
    shown.facts.emplace_back("power at frequency 8, " + name_of(kind), radial_mean(power, reach)[8]);
  }
  panels.insert(panels.end(), above.begin(), above.end());
  shown.picture = montage(panels, {.columns = static_cast<int>(kinds.size()), .caption_size = 11});
  return shown;
}

Shown show_radial_spectra(const LabSettings& settings) {
  draw::Plot plot{.title = "256 points: mean power at a frequency",
                  .x = {.label = "cycles across the square", .low = 0, .high = 64},
                  .y = {.label = "power; random points have 1", .low = 0, .high = 2.5}};
  Shown shown;
  for (const PatternKind kind : kinds) {
    if (kind == PatternKind::regular) continue;  // lines at multiples of 16
    const auto mean = radial_mean(mean_spectrum(kind, settings.seed), reach);
    draw::Series series{.name = name_of(kind)};
    for (std::size_t r = 1; r < mean.size(); ++r) series.points.emplace_back(static_cast<double>(r), mean[r]);
    plot.series.push_back(series);
    shown.facts.emplace_back("power below frequency 8, " + name_of(kind),
                             (mean[1] + mean[2] + mean[3] + mean[4] + mean[5] + mean[6] + mean[7]) / 7);
  }
  shown.picture = drawn(plot);
  return shown;
}

Shown show_best_candidate(const LabSettings& settings) {
  constexpr int width = 160, height = 120;
  const Scene scene = zone_plate(width, height);
  const Image truth = sampled_by_tiles(scene, width, height, {PatternKind::jittered, 64, settings.seed + 9});
  Shown shown;
  std::vector<draw::Panel> panels;
  for (const int samples : {1, 4})
    for (const PatternKind kind : {PatternKind::jittered, PatternKind::best_candidate}) {
      const Image image = sampled_by_tiles(scene, width, height, {kind, samples, settings.seed});
      const std::string name = fmt::format("{} sample{} a pixel, {}", samples, samples == 1 ? "" : "s", name_of(kind));
      panels.push_back({name, draw::magnified(image, 2)});
      shown.facts.emplace_back("rms error, " + name, rms_difference(image, truth));
    }
  shown.picture = montage(panels, {.columns = 2});
  return shown;
}

Shown show_error(const LabSettings& settings) {
  draw::Plot plot{.title = "Coverage of a pixel by an edge",
                  .x = {.label = "samples", .logarithmic = true},
                  .y = {.label = "rms error", .logarithmic = true}};
  Shown shown;
  for (const PatternKind kind : kinds) {
    draw::Series series{.name = name_of(kind), .mark = draw::Series::Mark::line_and_points};
    // A thousand best candidates take seconds.
    const int last = kind == PatternKind::best_candidate ? 16 : 32;
    for (int side = 1; side <= last; side *= 2)
      series.points.emplace_back(side * side, edge_error(kind, side * side, settings.seed));
    const Vec2d begin = series.points[1], end = series.points.back();
    shown.facts.emplace_back("slope, " + name_of(kind), std::log(end.y / begin.y) / std::log(end.x / begin.x));
    plot.series.push_back(std::move(series));
  }
  shown.picture = drawn(plot);
  return shown;
}

}  // namespace lambert::lab
