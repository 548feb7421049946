#include "lambert/texture/mip_map.h"

#include "lambert/image/colour.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lambert {
namespace {

/// Index into 0..n-1, or -1 for black.
int wrap(int i, int n, Wrap mode) {
  if (i >= 0 && i < n) return i;
  switch (mode) {
    case Wrap::repeat: return ((i % n) + n) % n;
    case Wrap::mirror: {
      const int period = 2 * n, j = ((i % period) + period) % period;
      return j < n ? j : period - 1 - j;
    }
    case Wrap::clamp: return std::clamp(i, 0, n - 1);
    case Wrap::black: return -1;
  }
  return -1;
}

/// The texels that an output texel covers when `from` texels become `to`, with their shares (which add up to 1).
struct Cover {
  int first = 0;
  float share[3] = {0, 0, 0};
};
Cover cover(int i, int from, int to) {
  const double step = static_cast<double>(from) / to, begin = i * step, end = begin + step;
  Cover c;
  c.first = static_cast<int>(begin);
  for (int k = 0; k < 3; ++k) {
    const double lo = std::max<double>(begin, c.first + k), hi = std::min<double>(end, c.first + k + 1);
    c.share[k] = static_cast<float>(std::max(0.0, hi - lo) / step);
  }
  return c;
}

float to_float(std::uint8_t code) { return static_cast<float>(code) * (1.0f / 255.0f); }

/// Far outside any image but small enough to convert to int.
float finite(float x) { return std::isfinite(x) ? std::clamp(x, -1e6f, 1e6f) : 0; }

}  // namespace

MipMap::MipMap(Texels texels, const Settings& settings) : settings_(settings), channels_(texels.channels) {
  assert(texels.width > 0 && texels.height > 0 && channels_ >= 1 && channels_ <= 4);
  Level base{texels.width, texels.height, std::move(texels.bytes), std::move(texels.floats)};
  if (settings_.srgb && !base.floats.empty() && !texels.linear)
    for (std::size_t i = 0; i < base.floats.size(); ++i)
      if (is_colour(static_cast<int>(i % static_cast<std::size_t>(channels_))))
        base.floats[i] = srgb_decode(base.floats[i]);
  levels_.push_back(std::move(base));
  if (settings_.filter != TextureFilter::trilinear) return;
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halved(levels_.back()));
}

MipMap::Level MipMap::halved(const Level& from) const {
  Level to{std::max(1, from.width / 2), std::max(1, from.height / 2), {}, {}};
  const auto count =
      static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * static_cast<std::size_t>(channels_);
  const bool bytes = !from.bytes.empty();
  (bytes ? to.bytes.resize(count) : to.floats.resize(count));
  std::size_t at = 0;
  for (int y = 0; y < to.height; ++y) {
    const Cover rows = cover(y, from.height, to.height);
    for (int x = 0; x < to.width; ++x) {
      const Cover columns = cover(x, from.width, to.width);
      Vec4 sum(0);
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          if (const float share = rows.share[j] * columns.share[i]; share > 0)
            sum += share * fetch(from, columns.first + i, rows.first + j);
      for (int c = 0; c < channels_; ++c, ++at) {
        const float v = channels_ == 2 && c == 1 ? sum.w : sum[c];
        if (!bytes)
          to.floats[at] = v;
        else
          to.bytes[at] =
              static_cast<std::uint8_t>(std::lround(255 * (settings_.srgb && is_colour(c) ? srgb_encode(v) : v)));
      }
    }
  }
  return to;
}

Vec4 MipMap::fetch(const Level& level, int x, int y) const {
  const auto channels = static_cast<std::size_t>(channels_);
  const std::size_t at =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x)) * channels;
  Vec4 v(0, 0, 0, 1);
  if (level.bytes.empty()) {
    for (std::size_t c = 0; c < channels; ++c) v[static_cast<int>(c)] = level.floats[at + c];
  } else {
    const std::uint8_t* p = &level.bytes[at];
    if (settings_.srgb)
      for (int c = 0; c < std::min(channels_, 3); ++c) v[c] = is_colour(c) ? srgb_decode8(p[c]) : to_float(p[c]);
    else
      for (int c = 0; c < std::min(channels_, 3); ++c) v[c] = to_float(p[c]);
    if (channels_ == 4) v.w = to_float(p[3]);
  }
  if (channels_ == 1) return {v.x, v.x, v.x, 1};
  if (channels_ == 2) return {v.x, v.x, v.x, v.y};
  return v;
}

Vec4 MipMap::wrapped(const Level& level, int x, int y) const {
  x = wrap(x, level.width, settings_.wrap_u), y = wrap(y, level.height, settings_.wrap_v);
  return x < 0 || y < 0 ? Vec4(0) : fetch(level, x, y);
}

Vec4 MipMap::bilinear(const Level& level, Vec2 uv) const {
  const float x = uv.x * static_cast<float>(level.width) - 0.5f, y = uv.y * static_cast<float>(level.height) - 0.5f;
  const int x0 = static_cast<int>(std::floor(finite(x))), y0 = static_cast<int>(std::floor(finite(y)));
  const float s = finite(x) - static_cast<float>(x0), t = finite(y) - static_cast<float>(y0);
  return (1 - t) * ((1 - s) * wrapped(level, x0, y0) + s * wrapped(level, x0 + 1, y0)) +
         t * ((1 - s) * wrapped(level, x0, y0 + 1) + s * wrapped(level, x0 + 1, y0 + 1));
}

Vec4 MipMap::lookup(Vec2 uv, float filter_width) const {
  uv = {finite(uv.x), finite(uv.y)};
  const Level& base = levels_[0];
  if (settings_.filter == TextureFilter::nearest)
    return wrapped(base, static_cast<int>(std::floor(finite(uv.x * static_cast<float>(base.width)))),
                   static_cast<int>(std::floor(finite(uv.y * static_cast<float>(base.height)))));
  const float texels = filter_width * static_cast<float>(std::max(base.width, base.height));
  if (!(texels > 1) || levels_.size() == 1) return bilinear(base, uv);
  const float level = std::min(std::log2(texels), static_cast<float>(levels_.size() - 1));
  const auto lower = static_cast<std::size_t>(level);
  const Vec4 fine = bilinear(levels_[lower], uv);
  const float t = level - static_cast<float>(lower);
  return t > 0 ? fine + t * (bilinear(levels_[lower + 1], uv) - fine) : fine;
}

}  // namespace lambert
