#include "lambert/image/tonemap/mertens.h"

#include "lambert/base/error.h"
#include "lambert/image/tonemap/fast_math.h"
#include "lambert/image/tonemap/pyramid.h"

#include <cmath>
#include <functional>
#include <string>

namespace lambert::tone {
namespace {

/// The sRGB curve and its inverse on [0, 1].
float coded(float v) {
  const float power = 1.055f * fast_pow(at_least(v, 0.0031308f), 1 / 2.4f) - 0.055f;
  return chosen(v <= 0.0031308f, 12.92f * v, power);
}
float decoded(float v) {
  const float power = fast_pow((at_least(v, 0.04045f) + 0.055f) * (1 / 1.055f), 2.4f);
  return chosen(v <= 0.04045f, v * (1 / 12.92f), power);
}

void for_channels(RgbPlanes& planes, const std::function<void(Plane&)>& body) {
  for (Plane* channel : {&planes.r, &planes.g, &planes.b}) body(*channel);
}

void convert(RgbPlanes& planes, float (*curve)(float)) {
  for_channels(planes, [&](Plane& channel) {
    for_rows(channel.height, [&](int y) {
      for (float& v : channel.row(y)) v = curve(std::min(std::max(v, 0.0f), 1.0f));
    });
  });
}

bool has_colour(const RgbPlanes& p) { return p.r.values != p.g.values || p.g.values != p.b.values; }

/// How good each pixel of an exposure is (coded values).
Plane quality(const RgbPlanes& p, const Mertens& m, bool colour) {
  Plane grey(p.r.width, p.r.height), out(p.r.width, p.r.height);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    grey.values[i] = (p.r.values[i] + p.g.values[i] + p.b.values[i]) * (1.0f / 3.0f);
  constexpr float least = 0.001f;
  for_rows(grey.height, [&](int y) {
    const auto up = grey.row(std::max(y - 1, 0)), down = grey.row(std::min(y + 1, grey.height - 1)), at = grey.row(y);
    const auto r = p.r.row(y), g = p.g.row(y), b = p.b.row(y);
    const auto to = out.row(y);
    for (std::size_t x = 0; x < to.size(); ++x) {
      const float mean = at[x];
      const float contrast =
          std::abs(up[x] + down[x] + at[x > 0 ? x - 1 : 0] + at[std::min(x + 1, to.size() - 1)] - 4 * mean);
      const float dr = r[x] - mean, dg = g[x] - mean, db = b[x] - mean;
      const float saturation = std::sqrt((dr * dr + dg * dg + db * db) * (1.0f / 3.0f));
      const float er = r[x] - 0.5f, eg = g[x] - 0.5f, eb = b[x] - 0.5f;
      // The Gaussian of deviation 0.2 for each channel; 18.0 is log2(e) / (2 * 0.2^2).
      const float exposedness = fast_exp2(-18.033688f * (er * er + eg * eg + eb * eb));
      to[x] = fast_pow(at_least(contrast, least), m.contrast) *
              (colour ? fast_pow(at_least(saturation, least), m.saturation) : 1.0f) *
              fast_pow(at_least(exposedness, least), m.exposedness);
    }
  });
  return out;
}

/// Divides the planes by their sum.
void normalise(std::vector<Plane>& weights) {
  for_rows(weights.front().height, [&](int y) {
    std::vector<float> sum(static_cast<std::size_t>(weights.front().width), 0.0f);
    for (const Plane& w : weights)
      for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += w.row(y)[x];
    for (Plane& w : weights)
      for (std::size_t x = 0; x < sum.size(); ++x) w.row(y)[x] /= sum[x];
  });
}

/// sum[k] += weights[k] times level k of the Laplacian pyramid of `channel`.
void add_weighted_pyramid(std::vector<Plane>& sum, Plane channel, const std::vector<Plane>& weights) {
  for (std::size_t k = 0; k < weights.size(); ++k) {
    Plane next;
    if (k + 1 < weights.size()) {
      next = halved(channel);
      const Plane smooth = doubled(next, channel.width, channel.height);
      for (std::size_t i = 0; i < smooth.values.size(); ++i) channel.values[i] -= smooth.values[i];
    }
    for (std::size_t i = 0; i < channel.values.size(); ++i)
      sum[k].values[i] += weights[k].values[i] * channel.values[i];
    channel = std::move(next);
  }
}

Plane collapsed(std::vector<Plane> pyramid) {
  for (std::size_t k = pyramid.size() - 1; k-- > 0;) {
    const Plane smooth = doubled(pyramid[k + 1], pyramid[k].width, pyramid[k].height);
    for (std::size_t i = 0; i < smooth.values.size(); ++i) pyramid[k].values[i] += smooth.values[i];
  }
  return std::move(pyramid.front());
}

std::vector<Plane> gaussian_pyramid(Plane plane) {
  std::vector<Plane> levels{std::move(plane)};
  while (std::min(levels.back().width, levels.back().height) > 1) levels.push_back(halved(levels.back()));
  return levels;
}

/// `exposure(i)` gives coded values, and is asked twice for each, so that memory does not grow with the stack but for
/// the weights.
RgbPlanes fused(std::size_t count, const std::function<RgbPlanes(std::size_t)>& exposure, const Mertens& m) {
  std::vector<Plane> weights;
  bool colour = false;
  for (std::size_t i = 0; i < count && !colour; ++i) colour = has_colour(exposure(i));
  for (std::size_t i = 0; i < count; ++i) weights.push_back(quality(exposure(i), m, colour));
  normalise(weights);
  std::vector<Plane> r, g, b;
  for (Plane level = weights.front(); r.empty() || std::min(r.back().width, r.back().height) > 1; level = halved(level))
    for (std::vector<Plane>* sum : {&r, &g, &b}) sum->emplace_back(level.width, level.height);
  for (std::size_t i = 0; i < count; ++i) {
    RgbPlanes planes = exposure(i);
    const std::vector<Plane> levels = gaussian_pyramid(std::move(weights[i]));
    add_weighted_pyramid(r, std::move(planes.r), levels);
    add_weighted_pyramid(g, std::move(planes.g), levels);
    add_weighted_pyramid(b, std::move(planes.b), levels);
  }
  RgbPlanes out{collapsed(std::move(r)), collapsed(std::move(g)), collapsed(std::move(b))};
  convert(out, decoded);
  return out;
}

}  // namespace

void Mertens::map(RgbPlanes& planes, const LuminanceMap& map) const {
  const float middle = key / map.statistics.log_average;
  const auto exposure = [&](std::size_t i) {
    RgbPlanes exposed = planes;
    const float stops = step * (static_cast<float>(i) - 0.5f * static_cast<float>(exposures - 1));
    for_channels(exposed, [scale = middle * std::exp2(stops)](Plane& channel) {
      for_rows(channel.height, [&](int y) {
        for (float& v : channel.row(y)) v *= scale;
      });
    });
    convert(exposed, coded);
    return exposed;
  };
  planes = fused(static_cast<std::size_t>(exposures), exposure, *this);
}

Image fuse_exposures(std::span<const Image> stack, const Mertens& settings) {
  if (stack.empty()) throw Error("exposure fusion needs at least one image");
  const Image& first = stack.front();
  for (const Image& image : stack)
    if (image.width() != first.width() || image.height() != first.height())
      throw Error("exposures must have one size; the first is " + std::to_string(first.width()) + "x" +
                  std::to_string(first.height()) + ", another " + std::to_string(image.width()) + "x" +
                  std::to_string(image.height()));
  const auto exposure = [&](std::size_t i) {
    const Image& image = stack[i];
    const Plane empty(image.width(), image.height());
    RgbPlanes planes{empty, empty, empty};
    const auto alpha = image.channel("A");
    for_rows(image.height(), [&](int y) {
      for (int x = 0; x < image.width(); ++x) {
        Rgb c = image.rgb(x, y);
        if (const float a = alpha ? image.at(x, y, *alpha) : 1.0f; a > 0) c = c / a;
        planes.r.at(x, y) = c.r > 0 ? c.r : 0.0f;
        planes.g.at(x, y) = c.g > 0 ? c.g : 0.0f;
        planes.b.at(x, y) = c.b > 0 ? c.b : 0.0f;
      }
    });
    convert(planes, coded);
    return planes;
  };
  const RgbPlanes planes = fused(stack.size(), exposure, settings);
  const auto alpha = first.channel("A");
  Image out(first.width(), first.height(), alpha ? rgba_channels() : rgb_channels());
  out.metadata = first.metadata;
  for_rows(out.height(), [&](int y) {
    for (int x = 0; x < out.width(); ++x) {
      const float a = alpha ? std::clamp(first.at(x, y, *alpha) > 0 ? first.at(x, y, *alpha) : 0.0f, 0.0f, 1.0f) : 1.0f;
      const Rgb c(planes.r.at(x, y), planes.g.at(x, y), planes.b.at(x, y));
      out.set_rgb(x, y, alpha && a > 0 ? c * a : c);
      if (alpha) out.at(x, y, 3) = a;
    }
  });
  return out;
}

}  // namespace lambert::tone
