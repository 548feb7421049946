#include "lambert/image/tonemap/radiance_rows.h"

namespace lambert::tone {
namespace {

/// What an infinite number becomes: far above infinite_radiance in every channel, yet its square is finite.
constexpr float most = 1e12f;

float usable(float v) {
  const float positive = v > 0 ? v : 0.0f;
  return positive < most ? positive : most;
}

/// Channels known when compiling make vectors of the loop; 0: not known.
template <std::size_t stride>
void load_colours(const float* from, std::size_t channels, float scale, ColourRow& row) {
  const std::size_t n = stride ? stride : channels;
  float* const r = row.r.data();
  float* const g = row.g.data();
  float* const b = row.b.data();
  const std::size_t width = row.r.size();
  for (std::size_t x = 0; x < width; ++x) {
    r[x] = usable(from[x * n] * scale);
    g[x] = usable(from[x * n + 1] * scale);
    b[x] = usable(from[x * n + 2] * scale);
  }
}

}  // namespace

void RadianceRows::load(int y, float scale, ColourRow& row) const {
  const float* const from = image_->row(y).data();
  const std::size_t n = image_->channel_count(), width = row.r.size();
  if (!image_->has_colour()) {
    for (std::size_t x = 0; x < width; ++x) row.r[x] = row.g[x] = row.b[x] = usable(from[x * n] * scale);
  } else if (n == 3) {
    load_colours<3>(from, n, scale, row);
  } else if (n == 4) {
    load_colours<4>(from, n, scale, row);
  } else {
    load_colours<0>(from, n, scale, row);
  }
  if (!alpha_) return;
  for (std::size_t x = 0; x < width; ++x) {
    const float a = from[x * n + *alpha_];
    row.alpha[x] = a > 0 ? std::min(a, 1.0f) : 0.0f;
    const float divisor = a > 0 ? 1 / a : 1.0f;
    row.r[x] = usable(row.r[x] * divisor), row.g[x] = usable(row.g[x] * divisor), row.b[x] = usable(row.b[x] * divisor);
  }
}

void luminances(const ColourRow& row, float* out) {
  const float* const r = row.r.data();
  const float* const g = row.g.data();
  const float* const b = row.b.data();
  const std::size_t width = row.r.size();
  for (std::size_t x = 0; x < width; ++x) out[x] = luminance({r[x], g[x], b[x]});
}

LuminanceMap RadianceRows::luminance_map(float scale) const { return measured(scale, true); }
LuminanceMap RadianceRows::statistics(float scale) const { return measured(scale, false); }

LuminanceMap RadianceRows::measured(float scale, bool keep) const {
  LuminanceMap map;
  if (keep) map.luminance = Plane(image_->width(), image_->height());
  std::vector<StatisticsSum> sums(static_cast<std::size_t>(row_blocks(image_->height())));
  for_row_blocks(image_->height(), [&](std::size_t block, int first, int last) {
    ColourRow row(image_->width());
    std::vector<float> line(row.r.size());
    for (int y = first; y < last; ++y) {
      load(y, scale, row);
      float* const l = keep ? map.luminance.row(y).data() : line.data();
      luminances(row, l);
      sums[block].add_row(row.r.data(), row.g.data(), row.b.data(), l, row.r.size());
    }
  });
  for (std::size_t i = 1; i < sums.size(); ++i) sums[0].add(sums[i]);
  map.statistics = sums[0].statistics();
  return map;
}

RgbPlanes RadianceRows::planes(float scale) const {
  const Plane empty(image_->width(), image_->height());
  RgbPlanes planes{empty, empty, empty};
  for_row_blocks(image_->height(), [&](std::size_t, int first, int last) {
    ColourRow row(image_->width());
    for (int y = first; y < last; ++y) {
      load(y, scale, row);
      std::copy(row.r.begin(), row.r.end(), planes.r.row(y).begin());
      std::copy(row.g.begin(), row.g.end(), planes.g.row(y).begin());
      std::copy(row.b.begin(), row.b.end(), planes.b.row(y).begin());
    }
  });
  return planes;
}

}  // namespace lambert::tone
