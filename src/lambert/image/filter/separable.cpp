#include "lambert/image/filter/separable.h"

#include "lambert/base/parallel.h"
#include "lambert/image/filter/lanes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace lambert {
namespace {

std::size_t rounded_up(std::size_t n) { return (n + lane_count - 1) / lane_count * lane_count; }

/// out[i] = Σ weight · in[index · stride + i], for i in [0, count).
void filter_down(const float* in, std::size_t stride, std::span<const Tap> taps, std::size_t count, float* out) {
  const auto at = [&](const Tap& t, std::size_t i) { return in + static_cast<std::size_t>(t.index) * stride + i; };
  std::size_t i = 0;
  for (; i + 4 * lane_count <= count; i += 4 * lane_count) {
    Lanes a{}, b{}, c{}, d{};
    for (const Tap& t : taps) {
      const float* p = at(t, i);
      a += t.weight * load_lanes(p);
      b += t.weight * load_lanes(p + lane_count);
      c += t.weight * load_lanes(p + 2 * lane_count);
      d += t.weight * load_lanes(p + 3 * lane_count);
    }
    store_lanes(out + i, a);
    store_lanes(out + i + lane_count, b);
    store_lanes(out + i + 2 * lane_count, c);
    store_lanes(out + i + 3 * lane_count, d);
  }
  for (; i < count; ++i) {
    float sum = 0;
    for (const Tap& t : taps) sum += t.weight * *at(t, i);
    out[i] = sum;
  }
}

/// `N` channels of eight rows at once. in[(pixel · channels + c) · 8 + row], its pixel 0 being that of index `first`.
template <std::size_t N>
void filter_across(const float* in, int first, std::size_t channels, std::span<const Tap> taps, float* out) {
  Lanes sum[N]{};
  for (const Tap& t : taps) {
    const float* p = in + static_cast<std::size_t>(t.index - first) * channels * lane_count;
    for (std::size_t c = 0; c < N; ++c) sum[c] += t.weight * load_lanes(p + c * lane_count);
  }
  for (std::size_t c = 0; c < N; ++c) store_lanes(out + c * lane_count, sum[c]);
}

struct Tile {
  std::size_t begin, end;  // columns of the output
  int first, last;         // columns of the input that they read
};

/// So wide that what neighbours read twice is small, so narrow that eight rows of it stay in a near cache.
std::vector<Tile> tiles_of(const Taps& columns, int in, std::size_t channels) {
  std::size_t support = 1;
  for (std::size_t i = 0; i < columns.size(); ++i) support = std::max(support, columns[i].size());
  const std::size_t wanted = std::max(1024 / channels, 8 * support);
  const std::size_t width = std::clamp(wanted * columns.size() / static_cast<std::size_t>(in), std::size_t{32}, wanted);
  std::vector<Tile> tiles;
  for (std::size_t begin = 0; begin < columns.size(); begin += width) {
    Tile tile{begin, std::min(columns.size(), begin + width), in, -1};
    for (std::size_t i = tile.begin; i < tile.end; ++i)
      for (const Tap& t : columns[i])
        tile.first = std::min(tile.first, t.index), tile.last = std::max(tile.last, t.index);
    tiles.push_back(tile);
  }
  return tiles;
}

void filter_tile(const Image& in, const Taps& columns, const Taps& rows, const Tile& tile, std::size_t y, Image& out) {
  const std::size_t channels = in.channel_count();
  const std::size_t height = std::min(lane_count, rows.size() - y);
  if (tile.last < tile.first) return;  // all black
  const std::size_t count = static_cast<std::size_t>(tile.last - tile.first + 1) * channels, wide = rounded_up(count);
  const std::size_t results = (tile.end - tile.begin) * channels, results_wide = rounded_up(results);
  const std::size_t most = std::max(wide, results_wide) * lane_count;
  const auto scratch = std::make_unique_for_overwrite<float[]>(most),
             lanes = std::make_unique_for_overwrite<float[]>(most);

  const float* corner = in.pixels().data() + static_cast<std::size_t>(tile.first) * channels;
  for (std::size_t r = 0; r < lane_count; ++r) {
    float* to = scratch.get() + r * wide;
    if (r < height) filter_down(corner, static_cast<std::size_t>(in.width()) * channels, rows[y + r], count, to);
    std::fill(to + (r < height ? count : 0), to + wide, 0.0f);
  }
  for (std::size_t i = 0; i < wide; i += lane_count)
    transpose_8x8(scratch.get() + i, wide, lanes.get() + i * lane_count, lane_count);

  float* to = scratch.get();
  for (std::size_t x = tile.begin; x < tile.end; ++x)
    for (std::size_t c = 0; c < channels;) {
      const float* from = lanes.get() + c * lane_count;
      const std::size_t n = std::min<std::size_t>(4, channels - c);
      switch (n) {
        case 4: filter_across<4>(from, tile.first, channels, columns[x], to); break;
        case 3: filter_across<3>(from, tile.first, channels, columns[x], to); break;
        case 2: filter_across<2>(from, tile.first, channels, columns[x], to); break;
        default: filter_across<1>(from, tile.first, channels, columns[x], to); break;
      }
      c += n, to += n * lane_count;
    }
  std::fill(to, scratch.get() + results_wide * lane_count, 0.0f);
  for (std::size_t i = 0; i < results_wide; i += lane_count)
    transpose_8x8(scratch.get() + i * lane_count, lane_count, lanes.get() + i, results_wide);
  for (std::size_t r = 0; r < height; ++r)
    std::copy_n(lanes.get() + r * results_wide, results,
                out.row(static_cast<int>(y + r)).data() + tile.begin * channels);
}

}  // namespace

Image separably_filtered(const Image& image, const Taps& columns, const Taps& rows, const FractionSink& progress) {
  assert(!image.empty());
  Image out(static_cast<int>(columns.size()), static_cast<int>(rows.size()), image.channels());
  out.metadata = image.metadata;
  const std::vector<Tile> tiles = tiles_of(columns, image.width(), image.channel_count());
  const std::size_t bundles = (rows.size() + lane_count - 1) / lane_count;
  parallel_for(bundles * tiles.size(), progress, [&](std::size_t i) {
    filter_tile(image, columns, rows, tiles[i % tiles.size()], i / tiles.size() * lane_count, out);
  });
  return out;
}

}  // namespace lambert
