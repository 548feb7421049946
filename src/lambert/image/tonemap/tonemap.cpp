#include "lambert/image/tonemap/tonemap.h"

#include "lambert/base/error.h"
#include "lambert/image/tonemap/fast_math.h"
#include "lambert/image/tonemap/radiance_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace lambert {
namespace {

using namespace tone;

/// Not below what logarithms can take.
constexpr float least_luminance = std::numeric_limits<float>::min();

float displayable(float v) {
  const float positive = v > 0 ? v : 0.0f;
  return positive < 1 ? positive : 1.0f;
}

Image empty_display(const Image& image, bool alpha) {
  std::vector<std::string> channels = image.has_colour() ? rgb_channels() : std::vector<std::string>{"Y"};
  if (alpha) channels.emplace_back("A");
  Image out(image.width(), image.height(), std::move(channels));
  out.place({image.data_window().x, image.data_window().y}, image.display_window());
  out.metadata = image.metadata;
  return out;
}

template <std::size_t stride>
void store_colours(const ColourRow& row, float* to) {
  const float* const r = row.r.data();
  const float* const g = row.g.data();
  const float* const b = row.b.data();
  const std::size_t width = row.r.size();
  for (std::size_t x = 0; x < width; ++x) {
    to[x * stride] = displayable(r[x]);
    to[x * stride + 1] = displayable(g[x]);
    to[x * stride + 2] = displayable(b[x]);
  }
}

void store(const ColourRow& row, bool alpha, Image& out, int y) {
  float* const to = out.row(y).data();
  const std::size_t n = out.channel_count(), colours = alpha ? n - 1 : n;
  if (colours == 3 && n == 3)
    store_colours<3>(row, to);
  else if (colours == 3)
    store_colours<4>(row, to);
  else
    for (std::size_t x = 0; x < row.g.size(); ++x) to[x * n] = displayable(row.g[x]);
  if (!alpha) return;
  for (std::size_t x = 0; x < row.alpha.size(); ++x) {
    const float a = row.alpha[x];
    for (std::size_t c = 0; a > 0 && c < colours; ++c) to[x * n + c] *= a;
    to[x * n + colours] = a;
  }
}

/// c' = (c/L)^s L'; a black pixel takes L' as its grey.
void colour_from_luminance(ColourRow& row, const float* luminance, const float* shown, float saturation) {
  const std::size_t width = row.r.size();
  std::vector<float> ratios(width);
  float* const ratio = ratios.data();
  for (std::size_t x = 0; x < width; ++x) {
    const float l = luminance[x] > least_luminance ? luminance[x] : least_luminance;
    ratio[x] = (saturation == 1 ? shown[x] : 1.0f) / l;
  }
  for (std::vector<float>* channel : {&row.r, &row.g, &row.b}) {
    float* const c = channel->data();
    if (saturation == 1) {
      for (std::size_t x = 0; x < width; ++x) {
        const float scaled = c[x] * ratio[x], grey = shown[x];
        c[x] = luminance[x] > least_luminance ? scaled : grey;
      }
    } else {
      for (std::size_t x = 0; x < width; ++x) {
        const float share = c[x] * ratio[x], grey = shown[x];
        const float scaled = fast_pow(at_least(share, 1e-30f), saturation) * grey;
        c[x] = luminance[x] > least_luminance ? scaled : grey;
      }
    }
  }
}

/// Loads each row, lets `change` have it, stores it.
template <class Change>
Image by_rows(const RadianceRows& rows, float scale, const Change& change) {
  Image out = empty_display(rows.image(), rows.has_alpha());
  for_row_blocks(out.height(), [&](std::size_t, int first, int last) {
    ColourRow row(out.width());
    for (int y = first; y < last; ++y) {
      rows.load(y, scale, row);
      change(row, y);
      store(row, rows.has_alpha(), out, y);
    }
  });
  return out;
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
void bound(Plane& plane, float largest) {
  for_rows(plane.height, [&](int y) {
    for (float& v : plane.row(y)) v = v < largest ? v : largest;
  });
}

struct Job {
  RadianceRows rows;
  float scale = 1;
  LuminanceMap map;
  std::optional<ToneChannels> channels;
  float saturation = 1;

  Image from_luminance(const Plane& shown) const {
    return by_rows(rows, scale, [&](ColourRow& row, int y) {
      colour_from_luminance(row, map.luminance.row(y).data(), shown.row(y).data(), saturation);
    });
  }
  Image from_planes(const RgbPlanes& planes) const {
    return by_rows(rows, scale, [&](ColourRow& row, int y) {
      std::ranges::copy(planes.r.row(y), row.r.begin());
      std::ranges::copy(planes.g.row(y), row.g.begin());
      std::ranges::copy(planes.b.row(y), row.b.begin());
    });
  }

  template <LuminanceCurve Op>
  Image run(const Op& op) const {
    const auto curve = op.curve(map);
    if (channels == ToneChannels::rgb)
      return by_rows(rows, scale, [&](ColourRow& row, int) {
        for (std::vector<float>* c : {&row.r, &row.g, &row.b}) apply(curve, c->data(), c->data(), c->size());
      });
    return by_rows(rows, scale, [&, this](ColourRow& row, int y) {
      const float* const luminance = map.luminance.row(y).data();
      std::vector<float> shown(row.r.size());
      apply(curve, luminance, shown.data(), shown.size());
      colour_from_luminance(row, luminance, shown.data(), saturation);
    });
  }

  template <LuminanceOperator Op>
  Image run(const Op& op) {
    bound(map.luminance, map.statistics.largest);
    if (channels != ToneChannels::rgb) return from_luminance(op.map(map));
    RgbPlanes planes = rows.planes(scale);
    for (Plane* channel : {&planes.r, &planes.g, &planes.b}) {
      bound(*channel, map.statistics.largest);
      *channel = op.map({.luminance = std::move(*channel), .statistics = map.statistics});
    }
    return from_planes(planes);
  }

  template <ColourCurve Op>
  Image run(const Op& op) const {
    const auto curve = op.colour_curve(map);
    if (channels != ToneChannels::luminance)
      return by_rows(rows, scale, [&](ColourRow& row, int) { apply_colour(curve, row); });
    return by_rows(rows, scale, [&, this](ColourRow& row, int y) {
      const float* const l = map.luminance.row(y).data();
      const auto grey = [&](float v) { return luminance(curve(Rgb(v))); };
      std::vector<float> shown(row.r.size());
      apply(grey, l, shown.data(), shown.size());
      colour_from_luminance(row, l, shown.data(), saturation);
    });
  }

  template <ColourOperator Op>
  Image run(const Op& op) {
    if (channels != ToneChannels::luminance) {
      RgbPlanes planes = rows.planes(scale);
      op.map(planes, map);
      return from_planes(planes);
    }
    RgbPlanes greys{map.luminance, map.luminance, map.luminance};
    LuminanceMap grey_map = map;
    grey_map.statistics.average_colour = Rgb(map.statistics.average);
    op.map(greys, grey_map);
    Plane shown = std::move(greys.r);
    for (std::size_t i = 0; i < shown.values.size(); ++i)
      shown.values[i] = luminance({shown.values[i], greys.g.values[i], greys.b.values[i]});
    return from_luminance(shown);
  }
};

template <class... Ops>
std::vector<ToneOperator> defaults(const std::variant<Ops...>*) {
  return {Ops{}...};
}
const std::vector<ToneOperator>& operators() {
  static const std::vector<ToneOperator> all = defaults(static_cast<const ToneOperator*>(nullptr));
  return all;
}

constexpr std::array<std::pair<std::string_view, ToneChannels>, 2> channel_choices{
    {{"luminance", ToneChannels::luminance}, {"rgb", ToneChannels::rgb}}};

}  // namespace

std::string tone_operator_name(const ToneOperator& op) {
  return std::visit([](const auto& o) -> std::string { return o.name; }, op);
}
std::string tone_operator_summary(const ToneOperator& op) {
  return std::visit([](const auto& o) -> std::string { return o.summary; }, op);
}
SettingTable tone_operator_settings(ToneOperator& op) {
  return SettingTable(std::visit([](auto& o) { return o.settings(); }, op));
}

ToneOperator tone_operator(std::string_view name) {
  for (const ToneOperator& op : operators())
    if (tone_operator_name(op) == name) return op;
  throw Error("unknown tone operator " + unknown_word(name, tone_operator_names()));
}

std::vector<std::string> tone_operator_names() {
  std::vector<std::string> names;
  for (const ToneOperator& op : operators()) names.push_back(tone_operator_name(op));
  return names;
}

ToneChannels tone_channels(std::string_view name) {
  for (const auto& [known, value] : channel_choices)
    if (known == name) return value;
  throw Error("unknown choice of channels " + unknown_word(name, tone_channels_names()));
}

std::vector<std::string> tone_channels_names() {
  std::vector<std::string> names;
  for (const auto& choice : channel_choices) names.emplace_back(choice.first);
  return names;
}

float auto_exposure_stops(const Image& image, const AutoExposure& a) {
  const LuminanceMap map = RadianceRows(image).luminance_map(1);
  const float low = map.percentile(a.low), high = map.percentile(a.high);
  double sum = 0;
  std::size_t counted = 0;
  for (const float l : map.luminance.values)
    if (l >= least_luminance && l >= low && l <= high) {
      sum += static_cast<double>(fast_log2(l));
      ++counted;
    }
  return counted == 0 ? 0 : std::log2(a.key) - static_cast<float>(sum / static_cast<double>(counted));
}

Image tonemap(const Image& image, const ToneSettings& settings) {
  const float automatic = settings.automatic ? auto_exposure_stops(image, *settings.automatic) : 0;
  const float scale = std::exp2(settings.exposure + automatic);
  const RadianceRows rows(image);
  return std::visit(
      [&](const auto& op) {
        Job job{.rows = rows,
                .scale = scale,
                .map = rows.luminance_map(scale),
                .channels = settings.channels,
                .saturation = settings.saturation};
        return job.run(op);
      },
      settings.op);
}

}  // namespace lambert
