#include "lambert/image/denoise/patch_distance.h"

#include "lambert/image/denoise/exp_of_minus.h"

#include <algorithm>

namespace lambert::denoise {

PatchGuide::PatchGuide(std::span<const Plane> values, std::span<const Plane> variances, int window_radius,
                       int patch_radius, std::span<const Plane> axes)
    : width_(values[0].width()), height_(values[0].height()) {
  const int pad = window_radius + patch_radius + tile_size;
  for (const Plane& plane : values) values_.emplace_back(plane, pad);
  for (const Plane& plane : variances) variances_.emplace_back(plane, pad);
  for (const Plane& plane : axes) axes_.emplace_back(plane, pad);
}

std::vector<Tile> tiles_of(int width, int height) {
  std::vector<Tile> tiles;
  for (int y = 0; y < height; y += tile_size)
    for (int x = 0; x < width; x += tile_size) tiles.push_back({x, y});
  return tiles;
}

TileWeights::TileWeights(const PatchGuide& guide, Tile tile, int stride, int patch_radius, float sharpness)
    : guide_(guide), tile_(tile), stride_(stride), patch_radius_(patch_radius) {
  const int side = 2 * patch_radius + 1;
  scale_ = sharpness / static_cast<float>(side * side * static_cast<int>(guide.channels()));
}

void TileWeights::compare(int dx, int dy, std::size_t channel) {
  const int side = tile_size + 2 * patch_radius_, left = tile_.x - patch_radius_;
  for (int j = 0; j < side; ++j) {
    const int y = tile_.y - patch_radius_ + j;
    const float* __restrict p = guide_.value(channel, y) + left;
    const float* __restrict q = guide_.value(channel, y + dy) + left + dx;
    const float* __restrict vp = guide_.variance(channel, y) + left;
    const float* __restrict vq = guide_.variance(channel, y + dy) + left + dx;
    float* __restrict d = distance_[static_cast<std::size_t>(j)].data();
    for (int i = 0; i < tile_size + 8; ++i) {
      const float difference = p[i] - q[i];
      const float term = (difference * difference - (vp[i] + std::min(vp[i], vq[i]))) / (1e-10f + vp[i] + vq[i]);
      d[i] = channel == 0 ? term : d[i] + term;
    }
  }
}

const float* TileWeights::at(int dx, int dy) {
  for (std::size_t c = 0; c < guide_.channels(); ++c) compare(dx, dy, c);
  const int patch = 2 * patch_radius_ + 1;
  for (int j = 0; j < tile_size + 2 * patch_radius_; ++j) {
    const float* __restrict d = distance_[static_cast<std::size_t>(j)].data();
    float* __restrict to = across_[static_cast<std::size_t>(j)].data();
    for (int i = 0; i < tile_size; ++i) to[i] = d[i];
    for (int s = 1; s < patch; ++s)
      for (int i = 0; i < tile_size; ++i) to[i] += d[i + s];
  }
  const auto inside = [&](int x, int y) { return x >= 0 && y >= 0 && x < guide_.width() && y < guide_.height(); };
  const int count = side();
  std::array<float, tile_size> row;
  float* __restrict sum = row.data();
  for (int j = 0; j < count; ++j) {
    const int y = j * stride_;
    row = across_[static_cast<std::size_t>(y)];
    for (int s = 1; s < patch; ++s) {
      const float* __restrict from = across_[static_cast<std::size_t>(y + s)].data();
      for (int i = 0; i < tile_size; ++i) sum[i] += from[i];
    }
    const float scale = scale_;
    for (int i = 0; i < tile_size; ++i) sum[i] = std::max(0.0f, sum[i] * scale);
    for (const PaddedPlane& axis : guide_.axes()) {
      const float* __restrict p = axis.row(tile_.y + y) + tile_.x;
      const float* __restrict q = axis.row(tile_.y + y + dy) + tile_.x + dx;
      for (int i = 0; i < tile_size; ++i) sum[i] += (p[i] - q[i]) * (p[i] - q[i]);
    }
    // Of all pixels, those between as well: they cost less than their exceptions would.
    for (int i = 0; i < tile_size; ++i) sum[i] = exp_of_minus(sum[i]);
    float* __restrict to = weights_.data() + j * count;
    for (int i = 0; i < count; ++i) to[i] = sum[i * stride_];
    const int last = tile_.x + tile_size - 1;
    if (inside(std::min(tile_.x, tile_.x + dx), std::min(tile_.y + y, tile_.y + y + dy)) &&
        inside(std::max(last, last + dx), std::max(tile_.y + y, tile_.y + y + dy)))
      continue;
    for (int i = 0; i < count; ++i) {
      const int x = tile_.x + i * stride_;
      if (!inside(x, tile_.y + y) || !inside(x + dx, tile_.y + y + dy)) to[i] = 0;
    }
  }
  return weights_.data();
}

}  // namespace lambert::denoise
