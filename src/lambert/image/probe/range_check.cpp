#include "lambert/image/probe/range_check.h"

#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::probe {
namespace {

template <class F>
void for_each_texel(const Probe& probe, const F& f) {
  const TexelMeasure measure = texel_measure(probe);
  for (int c = 0; c < static_cast<int>(probe.charts.size()); ++c)
    for (int y = 0; y < probe.height(); ++y)
      for (int x = 0; x < probe.width(); ++x) {
        const float omega = measure.solid_angle[static_cast<std::size_t>(y) * static_cast<std::size_t>(probe.width()) +
                                                static_cast<std::size_t>(x)];
        if (omega > 0) f(c, x, y, probe.charts[static_cast<std::size_t>(c)].rgb(x, y), omega);
      }
}

float top_value(const Probe& probe) {
  float top = -std::numeric_limits<float>::infinity();
  for_each_texel(probe, [&](int, int, int, Rgb c, float) { top = std::max(top, max_component(c)); });
  return top;
}

bool on_plateau(Rgb c, float top) { return top > 0 && max_component(c) >= 0.999f * top; }

struct Sum {
  double r = 0, g = 0, b = 0;
  void add(Rgb c, float weight) {
    const auto w = static_cast<double>(weight);
    r += w * static_cast<double>(c.r), g += w * static_cast<double>(c.g), b += w * static_cast<double>(c.b);
  }
  Rgb rgb() const { return {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)}; }
};

}  // namespace

RangeReport check_range(const Probe& probe) {
  RangeReport report;
  const float top = top_value(probe);
  report.plateau_value = top;
  report.darkest = std::numeric_limits<float>::infinity();
  report.brightest = -std::numeric_limits<float>::infinity();
  Sum mean;
  Vec3 towards(0);
  double total = 0, below = 0;
  float next = 0;  // the largest value under the plateau
  for_each_texel(probe, [&](int chart, int x, int y, Rgb c, float omega) {
    const float l = luminance(c);
    report.brightest = std::max(report.brightest, l);
    if (l > 0) report.darkest = std::min(report.darkest, l);
    mean.add(c, omega), total += static_cast<double>(omega);
    if (on_plateau(c, top)) {
      ++report.plateau_texels;
      report.plateau_solid_angle += omega;
      towards += texel_moment(probe, chart, x, y);
    } else {
      next = std::max(next, max_component(c));
      below += static_cast<double>(omega * max_component(c));
    }
  });
  if (!std::isfinite(report.darkest)) report.darkest = 0;
  report.brightest = std::max(report.brightest, 0.0f);
  report.mean_radiance = mean.rgb() / static_cast<float>(total);
  const Irradiance irradiance(probe);
  report.irradiance_up = irradiance({0, 1, 0}), report.irradiance_down = irradiance({0, -1, 0});
  if (report.darkest > 0) report.ratio = report.brightest / report.darkest, report.stops = std::log2(report.ratio);
  if (length(towards) > 0) report.plateau_direction = normalize(towards);
  report.at_format_limit = std::abs(top - 1) < 1e-3f || top >= 65000;
  const bool stands_out = static_cast<double>(top) * total > 4 * below;
  report.clipped = report.plateau_texels >= 1 && top > 0 && next > 0 &&
                   ((report.plateau_texels >= 3 && stands_out) || report.at_format_limit);
  return report;
}

std::optional<Rgb> missing_factor(const Probe& probe, const KnownIrradiance& known) {
  const float top = top_value(probe);
  Sum plateau, other;
  for_each_texel(probe, [&](int chart, int x, int y, Rgb c, float) {
    const float cosine = std::max(0.0f, dot(texel_moment(probe, chart, x, y), known.normal));
    (on_plateau(c, top) ? plateau : other).add(c, cosine);
  });
  const Rgb wanted = known.irradiance - other.rgb(), have = plateau.rgb();
  if (!(min_component(have) > 0) || !(min_component(wanted) > 0)) return std::nullopt;
  return wanted / have;
}

Probe restored(const Probe& probe, Rgb factor) {
  const float top = top_value(probe);
  Probe result = probe;
  for (Image& image : result.charts)
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const Rgb c = image.rgb(x, y);
        if (!on_plateau(c, top)) continue;
        if (image.has_colour())
          image.set_rgb(x, y, c * factor);
        else
          image.at(x, y, 0) *= average(factor);
      }
  return result;
}

}  // namespace lambert::probe
