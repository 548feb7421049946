#include "lambert/texture/mip_map.h"

#include "lambert/image/colour.h"
#include "lambert/image/filter/lookup.h"
#include "lambert/image/filter/taps.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace lambert {
namespace {

/// The light of every 8-bit code.
using CodeTable = std::array<float, 256>;
const CodeTable& table_of(bool srgb) {
  const auto make = [](bool decode) {
    CodeTable t;
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = decode ? srgb_decode8(static_cast<std::uint8_t>(i)) : static_cast<float>(i) * (1.0f / 255.0f);
    return t;
  };
  static const CodeTable tables[] = {make(false), make(true)};
  return tables[srgb];
}

/// RGBA of 1 to 4 channels, where `colour` and `plain` give a channel's value.
template <class Colour, class Plain>
Vec4 spread(std::size_t channels, const Colour& colour, const Plain& plain) {
  switch (channels) {
    case 1: {
      const float v = colour(0);
      return {v, v, v, 1};
    }
    case 2: {
      const float v = colour(0);
      return {v, v, v, plain(1)};
    }
    case 3: return {colour(0), colour(1), colour(2), 1};
    default: return {colour(0), colour(1), colour(2), plain(3)};
  }
}

/// How a level is read; two types, so that the choice is made once a lookup.
struct FloatTexels {
  const float* data;
  std::size_t width, channels;
  Vec4 operator()(int x, int y) const {
    const float* p = data + (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * channels;
    const auto value = [p](std::size_t c) { return p[c]; };
    return spread(channels, value, value);
  }
};
struct ByteTexels {
  const std::uint8_t* data;
  std::size_t width, channels;
  const float *colour, *plain;
  Vec4 operator()(int x, int y) const {
    const std::uint8_t* p = data + (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * channels;
    return spread(
        channels, [this, p](std::size_t c) { return colour[p[c]]; }, [this, p](std::size_t c) { return plain[p[c]]; });
  }
};

/// use(texels) with whichever of both `level` holds.
template <class Level, class Use>
Vec4 with_texels(const Level& level, int channels, bool srgb, const Use& use) {
  const auto width = static_cast<std::size_t>(level.width), count = static_cast<std::size_t>(channels);
  if (level.bytes.empty()) return use(FloatTexels{level.floats.data(), width, count});
  return use(ByteTexels{level.bytes.data(), width, count, table_of(srgb).data(), table_of(false).data()});
}

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
  return with_texels(level, channels_, settings_.srgb, [&](const auto& texel) { return texel(x, y); });
}

Vec4 MipMap::lookup(Vec2 uv, float filter_width) const {
  const Level& base = levels_[0];
  const EdgeModes edges{settings_.wrap_u, settings_.wrap_v};
  uv = {tame_coordinate(uv.x), tame_coordinate(uv.y)};
  if (settings_.filter == TextureFilter::nearest)
    return with_texels(base, channels_, settings_.srgb, [&](const auto& texel) {
      return nearest_lookup({base.width, base.height}, uv, edges, texel);
    });
  const auto bilinear = [&](int i) {
    const Level& level = levels_[static_cast<std::size_t>(i)];
    return with_texels(level, channels_, settings_.srgb, [&](const auto& texel) {
      return bilinear_lookup({level.width, level.height}, uv, edges, texel);
    });
  };
  const float texels = filter_width * static_cast<float>(std::max(base.width, base.height));
  if (!(texels > 1) || levels_.size() == 1) return bilinear(0);
  return blended_levels(std::min(std::log2(texels), static_cast<float>(levels_.size() - 1)), bilinear);
}

}  // namespace lambert
