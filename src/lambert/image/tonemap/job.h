#pragma once
/// Runs an operator of any kind over an image.

#include "lambert/image/tonemap/display_rows.h"
#include "lambert/image/tonemap/operators.h"
#include "lambert/image/tonemap/radiance_rows.h"
#include "lambert/image/tonemap/tonemap.h"

#include <optional>
#include <utility>
#include <vector>

namespace lambert::tone {

/// Loads each row, lets `change` have it with room for luminances, stores it.
template <class Change>
void by_rows(const RadianceRows& rows, float scale, Image& out, const Change& change) {
  for_row_blocks(out.height(), [&](std::size_t, int first, int last) {
    ColourRow row(out.width());
    LuminanceRow room(out.width());
    for (int y = first; y < last; ++y) {
      rows.load(y, scale, row);
      change(row, room, y);
      store(row, rows.has_alpha(), out, y);
    }
  });
}

template <class Curve>
void apply(const Curve& curve, const float* from, float* to, std::size_t count) {
  for (std::size_t x = 0; x < count; ++x) to[x] = curve(from[x]);
}

template <class Curve>
void apply_colour(const Curve& curve, ColourRow& row) {
  float* const r = row.r.data();
  float* const g = row.g.data();
  float* const b = row.b.data();
  const std::size_t width = row.r.size();
  for (std::size_t x = 0; x < width; ++x) {
    const Rgb c = curve(Rgb(r[x], g[x], b[x]));
    r[x] = c.r, g[x] = c.g, b[x] = c.b;
  }
}

/// Operators that look around see infinite light as the brightest that is finite.
inline void bound(Plane& plane, float largest) {
  for_rows(plane.height, [&](int y) {
    for (float& v : plane.row(y)) v = v < largest ? v : largest;
  });
}

struct Job {
  RadianceRows rows;
  Image* out;  ///< may be the image of the rows
  float scale = 1;
  std::optional<ToneChannels> channels;
  float saturation = 1;

  void from_luminance(const LuminanceMap& map, const Plane& shown) const {
    by_rows(rows, scale, *out, [&](ColourRow& row, LuminanceRow& room, int y) {
      colour_from_luminance(row, map.luminance.row(y).data(), shown.row(y).data(), room.ratio.data(), saturation);
    });
  }
  void from_planes(const RgbPlanes& planes) const {
    by_rows(rows, scale, *out, [&](ColourRow& row, LuminanceRow&, int y) {
      std::ranges::copy(planes.r.row(y), row.r.begin());
      std::ranges::copy(planes.g.row(y), row.g.begin());
      std::ranges::copy(planes.b.row(y), row.b.begin());
    });
  }

  template <LuminanceCurve Op>
  void run(const Op& op) const {
    constexpr bool whole = requires { Op::needs_luminances; };
    const auto curve = op.curve(whole ? rows.luminance_map(scale) : rows.statistics(scale));
    if (channels == ToneChannels::rgb)
      by_rows(rows, scale, *out, [&](ColourRow& row, LuminanceRow&, int) {
        for (std::vector<float>* c : {&row.r, &row.g, &row.b}) apply(curve, c->data(), c->data(), c->size());
      });
    else
      by_luminance(curve);
  }

  template <LuminanceOperator Op>
  void run(const Op& op) const {
    LuminanceMap map = rows.luminance_map(scale);
    bound(map.luminance, map.statistics.largest);
    if (channels != ToneChannels::rgb) return from_luminance(map, op.map(map));
    RgbPlanes planes = rows.planes(scale);
    for (Plane* channel : {&planes.r, &planes.g, &planes.b}) {
      bound(*channel, map.statistics.largest);
      *channel = op.map({.luminance = std::move(*channel), .statistics = map.statistics});
    }
    from_planes(planes);
  }

  template <ColourCurve Op>
  void run(const Op& op) const {
    const auto curve = op.colour_curve(rows.statistics(scale));
    if (channels == ToneChannels::luminance)
      by_luminance([&](float v) { return luminance(curve(Rgb(v))); });
    else
      by_rows(rows, scale, *out, [&](ColourRow& row, LuminanceRow&, int) { apply_colour(curve, row); });
  }

  template <ColourOperator Op>
  void run(const Op& op) const {
    LuminanceMap map = rows.luminance_map(scale);
    if (channels != ToneChannels::luminance) {
      RgbPlanes planes = rows.planes(scale);
      op.map(planes, map);
      return from_planes(planes);
    }
    RgbPlanes greys{map.luminance, map.luminance, map.luminance};
    map.statistics.average_colour = Rgb(map.statistics.average);
    op.map(greys, map);
    Plane shown = std::move(greys.r);
    for (std::size_t i = 0; i < shown.values.size(); ++i)
      shown.values[i] = luminance({shown.values[i], greys.g.values[i], greys.b.values[i]});
    from_luminance(map, shown);
  }

 private:
  template <class Curve>
  void by_luminance(const Curve& curve) const {
    by_rows(rows, scale, *out, [&, this](ColourRow& row, LuminanceRow& room, int) {
      luminances(row, room.light.data());
      apply(curve, room.light.data(), room.shown.data(), room.light.size());
      colour_from_luminance(row, room.light.data(), room.shown.data(), room.ratio.data(), saturation);
    });
  }
};

}  // namespace lambert::tone
