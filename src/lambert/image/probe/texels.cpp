#include "lambert/image/probe/texels.h"

#include "lambert/base/parallel.h"

#include <algorithm>

namespace lambert::probe {
namespace {

struct Span {
  double low, high;
};
Span span_of(TexelRule rule, int i, int n) {
  if (rule == TexelRule::cells) return {static_cast<double>(i) / n, static_cast<double>(i + 1) / n};
  if (n == 1) return {0, 1};
  return {std::max(0.0, (i - 0.5) / (n - 1)), std::min(1.0, (i + 0.5) / (n - 1))};
}

}  // namespace

Vec2 uv_of(const Probe& probe, Vec2 pixel) {
  const Vec2 size(probe.width(), probe.height());
  if (probe.texels == TexelRule::cells) return pixel / size;
  return (pixel - 0.5f) / glm::max(size - 1.0f, Vec2(1));
}

Vec2 pixel_of(const Probe& probe, Vec2 uv) {
  const Vec2 size(probe.width(), probe.height());
  if (probe.texels == TexelRule::cells) return uv * size;
  return uv * (size - 1.0f) + 0.5f;
}

std::optional<Texel> texel_at(const Probe& probe, Vec3 d) {
  const auto p = point(probe.projection, d);
  if (!p) return std::nullopt;
  const Vec2 pixel = pixel_of(probe, p->uv);
  return Texel{p->chart, std::clamp(static_cast<int>(pixel.x), 0, probe.width() - 1),
               std::clamp(static_cast<int>(pixel.y), 0, probe.height() - 1)};
}

std::optional<Texel> neighbour(const Probe& probe, const Texel& texel, Vec2i step) {
  const Texel n{texel.chart, texel.x + step.x, texel.y + step.y};
  if (n.x >= 0 && n.y >= 0 && n.x < probe.width() && n.y < probe.height()) return n;
  const auto d = direction(probe.projection, {n.chart, uv_of(probe, Vec2(n.x, n.y) + 0.5f)});
  return d ? texel_at(probe, *d) : std::nullopt;
}

Cell texel_cell(const Probe& probe, int x, int y) {
  const Span u = span_of(probe.texels, x, probe.width()), v = span_of(probe.texels, y, probe.height());
  return {u.low, u.high, v.low, v.high};
}

TexelIntegrals::TexelIntegrals(const Probe& probe) : probe_(&probe) {
  const auto* map = std::get_if<LatLong>(&probe.projection);
  if (!map) return;
  for (int y = 0; y < probe.height(); ++y) rows_.push_back(lat_long_row(texel_cell(probe, 0, y)));
  for (int x = 0; x < probe.width(); ++x) columns_.push_back(lat_long_column(*map, texel_cell(probe, x, 0)));
}

TexelMeasure texel_measure(const Probe& probe) {
  const auto w = static_cast<std::size_t>(probe.width()), h = static_cast<std::size_t>(probe.height());
  const TexelIntegrals texel(probe);
  TexelMeasure m;
  m.solid_angle.resize(w * h);
  parallel_for(h, [&](std::size_t y) {
    for (std::size_t x = 0; x < w; ++x)
      m.solid_angle[y * w + x] = static_cast<float>(texel(0, static_cast<int>(x), static_cast<int>(y)).solid_angle);
  });
  return m;
}

Vec3 texel_moment(const Probe& probe, int chart, int x, int y) {
  return Vec3(integrals(probe.projection, chart, texel_cell(probe, x, y)).moment);
}

}  // namespace lambert::probe
