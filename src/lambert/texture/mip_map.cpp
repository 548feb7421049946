#include "lambert/texture/mip_map.h"

#include "lambert/image/colour.h"
#include "lambert/image/filter/lookup.h"
#include "lambert/image/filter/taps.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lambert {
namespace {

float to_float(std::uint8_t code) { return static_cast<float>(code) * (1.0f / 255.0f); }

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
  const Taps columns = area_taps(from.width, to.width), rows = area_taps(from.height, to.height);
  std::size_t at = 0;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < columns.size(); ++x) {
      Vec4 sum(0);
      for (const Tap& row : rows[y])
        for (const Tap& column : columns[x]) sum += row.weight * column.weight * fetch(from, column.index, row.index);
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

Vec4 MipMap::lookup(Vec2 uv, float filter_width) const {
  const Level& base = levels_[0];
  const EdgeModes edges{settings_.wrap_u, settings_.wrap_v};
  const auto fetch_from = [&](const Level& level) { return [&](int x, int y) { return fetch(level, x, y); }; };
  uv = {tame_coordinate(uv.x), tame_coordinate(uv.y)};
  if (settings_.filter == TextureFilter::nearest)
    return nearest_lookup({base.width, base.height}, uv, edges, fetch_from(base));
  const auto bilinear = [&](int i) {
    const Level& level = levels_[static_cast<std::size_t>(i)];
    return bilinear_lookup({level.width, level.height}, uv, edges, fetch_from(level));
  };
  const float texels = filter_width * static_cast<float>(std::max(base.width, base.height));
  if (!(texels > 1) || levels_.size() == 1) return bilinear(0);
  return blended_levels(std::min(std::log2(texels), static_cast<float>(levels_.size() - 1)), bilinear);
}

}  // namespace lambert
