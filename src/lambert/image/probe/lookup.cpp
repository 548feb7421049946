#include "lambert/image/probe/lookup.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/probe/disk.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::probe {
namespace {

/// A running mean over `width` (at least 1) columns of a row that goes round, texels being constant.
void average_row(std::vector<double>& prefix, float* row, int columns, std::size_t stride, std::size_t channel,
                 double width) {
  width = std::min(width, static_cast<double>(columns));
  prefix[0] = 0;
  for (int x = 0; x < columns; ++x) {
    const auto i = static_cast<std::size_t>(x);
    prefix[i + 1] = prefix[i] + static_cast<double>(row[i * stride + channel]);
  }
  const double total = prefix[static_cast<std::size_t>(columns)];
  const auto upto = [&](double x) {  // ∫ from 0 to x
    const double turns = x < 0 ? -1 : x >= columns ? 1 : 0, rest = x - turns * columns;
    const auto i = std::min(static_cast<std::size_t>(rest), static_cast<std::size_t>(columns) - 1);
    return turns * total + prefix[i] + (rest - static_cast<double>(i)) * (prefix[i + 1] - prefix[i]);
  };
  for (int x = 0; x < columns; ++x) {
    const double centre = x + 0.5;
    row[static_cast<std::size_t>(x) * stride + channel] =
        static_cast<float>((upto(centre + 0.5 * width) - upto(centre - 0.5 * width)) / width);
  }
}

bool is_disk(const AnyProjection& p) {
  return std::holds_alternative<MirrorBall>(p) || std::holds_alternative<Fisheye>(p);
}

}  // namespace

Lookup::Lookup(const Probe& probe)
    : probe_(&probe),
      width_(probe.width()),
      height_(probe.height()),
      channels_(probe.charts.front().channel_count()),
      stride_((channels_ + 3) / 4 * 4),
      colour_(probe.charts.front().has_colour()) {
  // Texel centres lie at whole numbers of the bordered chart.
  shift_ = pixel_of(probe, Vec2(0)) + 0.5f;
  scale_ = pixel_of(probe, Vec2(1)) + 0.5f - shift_;
  row_ = static_cast<std::uint32_t>(width_ + 2);
  const std::size_t texels = probe.charts.size() * row_ * static_cast<std::size_t>(height_ + 2);
  if (texels + row_ + 2 > INT32_MAX) throw Error("the map is too large to be looked up");
  dark_ = static_cast<std::uint32_t>(texels);
  values_ = std::make_unique_for_overwrite<float[]>((texels + row_ + 2) * stride_);
  std::fill_n(&values_[texels * stride_], (row_ + 2) * stride_, 0.0f);
  const int charts = static_cast<int>(probe.charts.size());
  for (int chart = 0; chart < charts; ++chart) build_chart(chart);
  // Borders come from other charts; these must stand. Corners of cubes read edges of neighbours within their texels.
  for (int chart = 0; chart < charts; ++chart) {
    for (int x = -1; x <= width_; ++x) extend(chart, x, -1), extend(chart, x, height_);
    for (int y = 0; y < height_; ++y) extend(chart, -1, y), extend(chart, width_, y);
  }
  if (!is_disk(probe.projection)) return;
  parallel_for(static_cast<std::size_t>(height_), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width_; ++x) {
      const Vec2 p = disk_point(uv_of(probe, Vec2(x, y) + 0.5f));
      if (dot(p, p) > 1) extend(0, x, y);
    }
  });
}

float* Lookup::texel(int chart, int x, int y) const {
  const auto row = static_cast<std::size_t>(chart * (height_ + 2) + y + 1);
  return &values_[(row * row_ + static_cast<std::size_t>(x + 1)) * stride_];
}

void Lookup::build_chart(int chart) {
  const Image& image = probe_->charts[static_cast<std::size_t>(chart)];
  const bool lat_long = std::holds_alternative<LatLong>(probe_->projection);
  parallel_for(static_cast<std::size_t>(height_), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    float* out = texel(chart, 0, y);
    const float* in = image.row(y).data();
    for (std::size_t x = 0; x < static_cast<std::size_t>(width_); ++x)
      for (std::size_t c = 0; c < stride_; ++c) out[x * stride_ + c] = c < channels_ ? in[x * channels_ + c] : 0;
    if (!lat_long) return;
    // Edge to edge, the last column is the first one again.
    const int columns = probe_->texels == TexelRule::cells ? width_ : std::max(1, width_ - 1);
    const float v = uv_of(*probe_, Vec2(0, static_cast<float>(y) + 0.5f)).y;
    const double aspect = static_cast<double>(columns) / (2.0 * height_);
    const double wanted = 0.5 * aspect / std::max(1e-9, std::abs(std::sin(static_cast<double>(pi * v))));
    if (wanted <= 1) return;
    std::vector<double> prefix(static_cast<std::size_t>(columns) + 1);
    for (std::size_t c = 0; c < channels_; ++c) average_row(prefix, out, columns, stride_, c, wanted);
    if (columns < width_) std::copy_n(out, channels_, out + static_cast<std::size_t>(columns) * stride_);
  });
}

/// Fills a stored texel that lies outside of its chart by what is there on the sphere, or, for disks, further in.
void Lookup::extend(int chart, int x, int y) {
  const Vec2 centre = Vec2(x, y) + 0.5f;
  MapPoint from{chart, glm::clamp(uv_of(*probe_, centre), 0.0f, 1.0f)};
  if (is_disk(probe_->projection)) {
    const Vec2 p = disk_point(uv_of(*probe_, centre));
    const float inside = std::max(0.0f, 1 - 2.0f / static_cast<float>(width_));
    from.uv = disk_uv(p * (inside / std::max(length(p), 1e-6f)));
  } else if (const auto d = direction(probe_->projection, {chart, uv_of(*probe_, centre)})) {
    if (const auto there = point(probe_->projection, *d)) from = *there;
  }
  const Vec2 at = pixel_of(*probe_, from.uv) - 0.5f;
  const auto split = [](float a, int n, int& i, float& t) {
    const float inside = std::clamp(a, 0.0f, static_cast<float>(n - 1));
    i = std::min(static_cast<int>(inside), std::max(0, n - 2));
    t = inside - static_cast<float>(i);
  };
  int i = 0, j = 0;
  float s = 0, t = 0;
  split(at.x, width_, i, s), split(at.y, height_, j, t);
  const int i1 = std::min(i + 1, width_ - 1), j1 = std::min(j + 1, height_ - 1);
  const float *a = texel(from.chart, i, j), *b = texel(from.chart, i1, j), *c = texel(from.chart, i, j1),
              *d = texel(from.chart, i1, j1);
  float* out = texel(chart, x, y);
  for (std::size_t k = 0; k < stride_; ++k)
    out[k] = (1 - t) * ((1 - s) * a[k] + s * b[k]) + t * ((1 - s) * c[k] + s * d[k]);
}

template <class P>
void Lookup::find_all(const P& projection, std::size_t count, const float* __restrict dx, const float* __restrict dy,
                      const float* __restrict dz, std::uint32_t* __restrict texels, float* __restrict across,
                      float* __restrict down) const {
  const auto last_x = static_cast<float>(width_), last_y = static_cast<float>(height_);
  const Vec2 scale = scale_, shift = shift_;
  const int row = static_cast<int>(row_), chart = row * (height_ + 2);
  const std::uint32_t dark = dark_;
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = projection.point({dx[i], dy[i], dz[i]});
    const MapPoint at = p ? *p : MapPoint{};
    // The last texel that has a right and a lower neighbour is the last but one.
    const float x = std::max(0.0f, at.uv.x * scale.x + shift.x), y = std::max(0.0f, at.uv.y * scale.y + shift.y);
    const int left = static_cast<int>(std::min(x, last_x)), top = static_cast<int>(std::min(y, last_y));
    texels[i] = p ? static_cast<std::uint32_t>(at.chart * chart + top * row + left) : dark;
    across[i] = std::min(x - static_cast<float>(left), 1.0f);
    down[i] = std::min(y - static_cast<float>(top), 1.0f);
  }
}

void Lookup::find(const Directions& directions, Places& places) const {
  const std::size_t count = directions.size();
  places.texel.resize(count), places.across.resize(count), places.down.resize(count);
  std::visit(
      [&](const auto& p) {
        find_all(p, count, directions.x.data(), directions.y.data(), directions.z.data(), places.texel.data(),
                 places.across.data(), places.down.data());
      },
      probe_->projection);
}

void Lookup::add(const Places& places, std::size_t first, std::span<const float> weights, std::span<float> sums) const {
  for (std::size_t k = 0; k < stride_; k += 4) {
    float sum[4] = {sums[k], sums[k + 1], sums[k + 2], sums[k + 3]};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const float* top = &values_[places.texel[first + i] * stride_ + k];
      const float* bottom = top + row_ * stride_;
      const float right = weights[i] * places.across[first + i], left = weights[i] - right;
      const float d = right * places.down[first + i], b = right - d, c = left * places.down[first + i], a = left - c;
      for (std::size_t m = 0; m < 4; ++m)
        sum[m] += a * top[m] + b * top[m + stride_] + c * bottom[m] + d * bottom[m + stride_];
    }
    std::copy_n(sum, 4, &sums[k]);
  }
}

Rgb Lookup::rgb(Vec3 d) const {
  std::uint32_t at = 0;
  float s = 0, t = 0;
  std::visit([&](const auto& p) { find_all(p, 1, &d.x, &d.y, &d.z, &at, &s, &t); }, probe_->projection);
  const float *top = &values_[at * stride_], *bottom = top + row_ * stride_;
  const auto value = [&](std::size_t c) {
    return (1 - t) * ((1 - s) * top[c] + s * top[c + stride_]) + t * ((1 - s) * bottom[c] + s * bottom[c + stride_]);
  };
  return colour_ ? Rgb(value(0), value(1), value(2)) : Rgb(value(0));
}

float Lookup::texel_angle(Vec3 d) const {
  const auto p = point(probe_->projection, d);
  if (!p) return std::numeric_limits<float>::infinity();
  const auto step = [&](Vec2 along) {
    const auto a = direction(probe_->projection, {p->chart, p->uv + along});
    const auto b = direction(probe_->projection, {p->chart, p->uv - along});
    return a && b ? length(*a - *b) : a ? 2 * length(*a - d) : b ? 2 * length(*b - d) : 0.0f;
  };
  const float u = step({0.5f / std::abs(scale_.x), 0}), v = step({0, 0.5f / std::abs(scale_.y)});
  const float coarse = std::max(u, v), fine = std::min(u, v);
  return std::max({std::sqrt(coarse * std::max(fine, 0.25f * coarse)), 1e-6f});
}

}  // namespace lambert::probe
