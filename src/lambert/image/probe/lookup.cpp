#include "lambert/image/probe/lookup.h"

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
  values_.resize(probe.charts.size() * static_cast<std::size_t>(width_ + 2) * static_cast<std::size_t>(height_ + 2) *
                 stride_);
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

const float* Lookup::texel(int chart, int x, int y) const {
  const auto row = static_cast<std::size_t>(chart * (height_ + 2) + y + 1);
  return &values_[(row * static_cast<std::size_t>(width_ + 2) + static_cast<std::size_t>(x + 1)) * stride_];
}

void Lookup::build_chart(int chart) {
  const Image& image = probe_->charts[static_cast<std::size_t>(chart)];
  const bool lat_long = std::holds_alternative<LatLong>(probe_->projection);
  parallel_for(static_cast<std::size_t>(height_), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    float* out = const_cast<float*>(texel(chart, 0, y));
    const float* in = image.row(y).data();
    for (int x = 0; x < width_; ++x)
      for (std::size_t c = 0; c < channels_; ++c)
        out[static_cast<std::size_t>(x) * stride_ + c] = in[static_cast<std::size_t>(x) * channels_ + c];
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
  float* out = const_cast<float*>(texel(chart, x, y));
  for (std::size_t k = 0; k < channels_; ++k)
    out[k] = (1 - t) * ((1 - s) * a[k] + s * b[k]) + t * ((1 - s) * c[k] + s * d[k]);
}

template <class P>
void Lookup::add_all(const P& projection, std::span<const Vec3> directions, std::span<const float> weights,
                     float* sums) const {
  const std::size_t row = static_cast<std::size_t>(width_ + 2) * stride_;
  const std::size_t chart = row * static_cast<std::size_t>(height_ + 2);
  const auto last_x = static_cast<float>(width_ + 1), last_y = static_cast<float>(height_ + 1);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto p = projection.point(directions[i]);
    if (!p) continue;
    const float x = std::clamp(p->uv.x * scale_.x + shift_.x, 0.0f, last_x);
    const float y = std::clamp(p->uv.y * scale_.y + shift_.y, 0.0f, last_y);
    const int x0 = std::min(static_cast<int>(x), width_), y0 = std::min(static_cast<int>(y), height_);
    const float s = x - static_cast<float>(x0), t = y - static_cast<float>(y0), w = weights[i];
    const float* top = &values_[static_cast<std::size_t>(p->chart) * chart + static_cast<std::size_t>(y0) * row +
                                static_cast<std::size_t>(x0) * stride_];
    const float* bottom = top + row;
    const float a = w * (1 - s) * (1 - t), b = w * s * (1 - t), c = w * (1 - s) * t, d = w * s * t;
    for (std::size_t k = 0; k < stride_; k += 4)
      for (std::size_t m = k; m < k + 4; ++m)
        sums[m] += a * top[m] + b * top[m + stride_] + c * bottom[m] + d * bottom[m + stride_];
  }
}

void Lookup::add(std::span<const Vec3> directions, std::span<const float> weights, std::span<float> sums) const {
  std::visit([&](const auto& p) { add_all(p, directions, weights, sums.data()); }, probe_->projection);
}

void Lookup::read(Vec3 d, std::span<float> values) const {
  std::vector<float> sums(stride_, 0.0f);
  const float one = 1;
  add({&d, 1}, {&one, 1}, sums);
  std::copy_n(sums.begin(), channels_, values.begin());
}

Rgb Lookup::rgb(Vec3 d) const {
  if (stride_ > 4) {
    std::vector<float> values(channels_);
    read(d, values);
    return colour_ ? Rgb(values[0], values[1], values[2]) : Rgb(values[0]);
  }
  float sums[4] = {};
  const float one = 1;
  add({&d, 1}, {&one, 1}, sums);
  return colour_ ? Rgb(sums[0], sums[1], sums[2]) : Rgb(sums[0]);
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
