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

std::vector<std::string> display_channels(const Image& image) {
  std::vector<std::string> channels = image.has_colour() ? rgb_channels() : std::vector<std::string>{"Y"};
  if (image.channel("A")) channels.emplace_back("A");
  return channels;
}

Image empty_display(const Image& image) {
  Image out(image.width(), image.height(), display_channels(image));
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
void by_rows(const RadianceRows& rows, float scale, Image& out, const Change& change) {
  for_row_blocks(out.height(), [&](std::size_t, int first, int last) {
    ColourRow row(out.width());
    for (int y = first; y < last; ++y) {
      rows.load(y, scale, row);
      change(row, y);
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
void bound(Plane& plane, float largest) {
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
    by_rows(rows, scale, *out, [&](ColourRow& row, int y) {
      colour_from_luminance(row, map.luminance.row(y).data(), shown.row(y).data(), saturation);
    });
  }
  void from_planes(const RgbPlanes& planes) const {
    by_rows(rows, scale, *out, [&](ColourRow& row, int y) {
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
      by_rows(rows, scale, *out, [&](ColourRow& row, int) {
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
      by_rows(rows, scale, *out, [&](ColourRow& row, int) { apply_colour(curve, row); });
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
    by_rows(rows, scale, *out, [&, this](ColourRow& row, int) {
      std::vector<float> light(row.r.size()), shown(row.r.size());
      luminances(row, light.data());
      apply(curve, light.data(), shown.data(), shown.size());
      colour_from_luminance(row, light.data(), shown.data(), saturation);
    });
  }
};

void tonemap_into(Image& out, const Image& image, const ToneSettings& settings) {
  const float automatic = settings.automatic ? auto_exposure_stops(image, *settings.automatic) : 0;
  const Job job{.rows = RadianceRows(image),
                .out = &out,
                .scale = std::exp2(settings.exposure + automatic),
                .channels = settings.channels,
                .saturation = settings.saturation};
  std::visit([&](const auto& op) { job.run(op); }, settings.op);
}

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
  Image out = empty_display(image);
  tonemap_into(out, image, settings);
  return out;
}

Image tonemap(Image&& image, const ToneSettings& settings) {
  if (image.channels() != display_channels(image)) return tonemap(image, settings);
  tonemap_into(image, image, settings);
  return std::move(image);
}

}  // namespace lambert
