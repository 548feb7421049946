#include "lambert/image/probe/resample.h"

#include "lambert/image/probe/lookup.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <vector>

namespace lambert::probe {
namespace {

bool has_rim(const AnyProjection& p) {
  return std::holds_alternative<MirrorBall>(p) || std::holds_alternative<Fisheye>(p);
}

/// A row of samples across a tile.
struct Row {
  std::vector<float> u;
  Directions equator;  // of lat-long targets: of each column, at v = 1/2
  Directions directions;
  std::vector<float> density;  // 0 where the target shows nothing
  Places places;
};

class Resampler {
 public:
  Resampler(const Probe& source, Probe& target, const ResampleSettings& settings)
      : lookup_(source),
        target_(target),
        settings_(settings),
        to_source_(glm::transpose(settings.rotation)),
        turned_(settings.rotation != Mat3(1)),
        rim_(has_rim(target.projection)),
        tile_(rim_ ? Vec2i(2) : Vec2i(32, 8)) {}

  void run() {
    const Vec2i tiles = (Vec2i(target_.width(), target_.height()) + tile_ - 1) / tile_;
    parallel_for(target_.charts.size() * static_cast<std::size_t>(tiles.y), settings_.progress, [&](std::size_t i) {
      const auto chart = static_cast<int>(i / static_cast<std::size_t>(tiles.y));
      const auto row = static_cast<int>(i % static_cast<std::size_t>(tiles.y));
      Row samples;
      for (int column = 0; column < tiles.x; ++column)
        std::visit([&](const auto& p) { do_tile(p, chart, Vec2i(column, row) * tile_, samples); }, target_.projection);
    });
  }

 private:
  /// How many samples a texel of the tile needs along each axis.
  template <class P>
  Vec2i sample_counts(const P& projection, int chart, Vec2i corner, Vec2i size) const {
    Vec2 most(0);
    bool whole = true;
    const auto at = [&](Vec2 pixel) { return projection.direction({chart, uv_of(target_, pixel)}); };
    const Vec2 first(corner), last(corner + size);
    for (const Vec2 place : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1), Vec2(0.5f)}) {
      if (rim_ && !at(glm::mix(first, last, place))) whole = false;
      const Vec2 p = glm::mix(first + 0.5f, last - 0.5f, place);
      const auto here = at(p);
      if (!here) continue;
      const float angle = lookup_.texel_angle(to_source_ * *here);
      const auto extent = [&](Vec2 step) {
        const auto a = at(p - step), b = at(p + step);
        return a && b ? length(*b - *a) : a ? 2 * length(*here - *a) : b ? 2 * length(*b - *here) : 0.0f;
      };
      most = glm::max(most, Vec2(extent({0.5f, 0}), extent({0, 0.5f})) / angle);
    }
    const int least = whole ? 1 : 8;  // of some texels at the rim little is seen
    const auto count = [&](float ratio) {
      return std::clamp(static_cast<int>(std::ceil(settings_.quality * ratio - 0.05f)), least, settings_.most_per_axis);
    };
    return {count(most.x), count(most.y)};
  }

  template <class P>
  void do_tile(const P& projection, int chart, Vec2i corner, Row& row) const {
    Image& image = target_.charts[static_cast<std::size_t>(chart)];
    const Vec2i size = glm::min(tile_, Vec2i(image.width(), image.height()) - corner);
    const Vec2i n = sample_counts(projection, chart, corner, size);
    const std::size_t count = static_cast<std::size_t>(n.x) * static_cast<std::size_t>(size.x);
    row.u.resize(count), row.directions.resize(count), row.density.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const float column = (static_cast<float>(i) + 0.5f) / static_cast<float>(n.x);
      row.u[i] = uv_of(target_, {static_cast<float>(corner.x) + column, 0}).x;
    }
    if constexpr (std::same_as<P, LatLong>) {
      row.equator.resize(count);
      for (std::size_t i = 0; i < count; ++i) row.equator.set(i, *projection.direction({0, {row.u[i], 0.5f}}));
    }
    const auto columns = static_cast<std::size_t>(size.x), samples = static_cast<std::size_t>(n.x);
    const std::size_t stride = lookup_.stride();
    std::vector<float> sums(columns * stride), total(columns);
    for (int y = corner.y; y < corner.y + size.y; ++y) {
      std::fill(sums.begin(), sums.end(), 0.0f), std::fill(total.begin(), total.end(), 0.0f);
      for (int j = 0; j < n.y; ++j) {
        const float line = static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / static_cast<float>(n.y);
        take_samples(projection, chart, uv_of(target_, {0, line}).y, row);
        if (turned_) turn(row.directions);
        lookup_.find(row.directions, row.places);
        for (std::size_t x = 0; x < columns; ++x) {
          const std::span<const float> weights(&row.density[x * samples], samples);
          for (const float w : weights) total[x] += w;
          lookup_.add(row.places, x * samples, weights, {&sums[x * stride], stride});
        }
      }
      for (std::size_t x = 0; x < columns; ++x)
        for (std::size_t c = 0; total[x] > 0 && c < image.channel_count(); ++c)
          image.at(corner.x + static_cast<int>(x), y, c) = sums[x * stride + c] / total[x];
    }
  }

  template <class P>
  static void take_samples(const P& projection, int chart, float v, Row& row) {
    const float* __restrict u = row.u.data();
    float* __restrict x = row.directions.x.data();
    float* __restrict y = row.directions.y.data();
    float* __restrict z = row.directions.z.data();
    float* __restrict density = row.density.data();
    const P map = projection;
    const std::size_t count = row.u.size();
    for (std::size_t i = 0; i < count; ++i) {
      const MapPoint at{chart, {u[i], v}};
      const auto seen = map.direction(at);
      const Vec3 d = seen ? *seen : Vec3(0, 0, 1);
      x[i] = d.x, y[i] = d.y, z[i] = d.z;
      density[i] = seen ? map.density(at) : 0;
    }
  }

  /// Only the ring and the height change from row to row.
  static void take_samples(const LatLong& projection, int, float v, Row& row) {
    const float ring = std::sin(pi * v), height = std::cos(pi * v), density = projection.density({0, {0, v}});
    for (std::size_t i = 0; i < row.u.size(); ++i) {
      row.directions.x[i] = ring * row.equator.x[i];
      row.directions.y[i] = height;
      row.directions.z[i] = ring * row.equator.z[i];
      row.density[i] = density;
    }
  }

  void turn(Directions& directions) const {
    float *x = directions.x.data(), *y = directions.y.data(), *z = directions.z.data();
    const Mat3 m = to_source_;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec3 d = m * Vec3(x[i], y[i], z[i]);
      x[i] = d.x, y[i] = d.y, z[i] = d.z;
    }
  }

  Lookup lookup_;
  Probe& target_;
  ResampleSettings settings_;
  Mat3 to_source_;
  bool turned_, rim_;
  Vec2i tile_;  // texels that share a number of samples; balls change fast at their rim
};

}  // namespace

Probe resample(const Probe& source, const AnyProjection& projection, TexelRule texels, Vec2i size,
               const ResampleSettings& settings) {
  if (source.projection == projection && source.texels == texels && settings.rotation == Mat3(1) &&
      size == Vec2i(source.width(), source.height()))
    return source;
  Probe target{projection, texels, {}};
  for (int i = 0; i < chart_count(projection); ++i)
    target.charts.emplace_back(size.x, size.y, source.charts.front().channels());
  target.charts.front().metadata = source.charts.front().metadata;
  target.charts.front().attributes = source.charts.front().attributes;
  Resampler(source, target, settings).run();
  return target;
}

Vec2i similar_size(const Probe& source, const AnyProjection& projection) {
  const float around = texels_around(source.projection, source.width());
  const float size = around / texels_around(projection, 1) / (std::holds_alternative<LatLong>(projection) ? 2.0f : 1);
  return chart_size(projection, std::max(1, static_cast<int>(std::lround(size))));
}

}  // namespace lambert::probe
