#include "lambert/image/probe/resample.h"

#include "lambert/base/parallel.h"
#include "lambert/image/probe/lookup.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lambert::probe {
namespace {

struct Work {
  std::vector<Vec3> directions;
  std::vector<float> weights, sums;
};

class Resampler {
 public:
  Resampler(const Probe& source, Probe& target, const ResampleSettings& settings)
      : lookup_(source),
        target_(target),
        settings_(settings),
        to_source_(glm::transpose(settings.rotation)),
        turned_(settings.rotation != Mat3(1)),
        tile_(std::holds_alternative<MirrorBall>(target.projection) ||
                      std::holds_alternative<Fisheye>(target.projection)
                  ? 2
                  : 8) {}

  void run() {
    const int columns = (target_.width() + tile_ - 1) / tile_, rows = (target_.height() + tile_ - 1) / tile_;
    const std::size_t charts = target_.charts.size();
    parallel_for(charts * static_cast<std::size_t>(rows), [&](std::size_t i) {
      Work work;
      work.sums.resize(lookup_.stride());
      const int chart = static_cast<int>(i / static_cast<std::size_t>(rows));
      const int y = static_cast<int>(i % static_cast<std::size_t>(rows)) * tile_;
      for (int c = 0; c < columns; ++c) do_tile(work, chart, c * tile_, y);
    });
  }

 private:
  /// How many samples a texel of the tile needs along each axis.
  Vec2i sample_counts(int chart, int x, int y) const {
    Vec2 most(0);
    const auto at = [&](Vec2 pixel) { return direction(target_.projection, {chart, uv_of(target_, pixel)}); };
    const auto t = static_cast<float>(tile_);
    for (const Vec2 corner :
         {Vec2(0.5f, 0.5f), Vec2(t - 0.5f, 0.5f), Vec2(0.5f, t - 0.5f), Vec2(t - 0.5f), Vec2(0.5f * t)}) {
      const Vec2 p = glm::min(Vec2(x, y) + corner, Vec2(target_.width(), target_.height()) - 0.5f);
      const auto here = at(p);
      if (!here) continue;
      const float angle = lookup_.texel_angle(to_source_ * *here);
      const auto extent = [&](Vec2 step) {
        const auto a = at(p - step), b = at(p + step);
        return a && b ? length(*b - *a) : a ? 2 * length(*here - *a) : b ? 2 * length(*b - *here) : 0.0f;
      };
      most = glm::max(most, Vec2(extent({0.5f, 0}), extent({0, 0.5f})) / angle);
    }
    const auto count = [&](float ratio) {
      return std::clamp(static_cast<int>(std::ceil(settings_.quality * ratio - 0.05f)), 1, settings_.most_per_axis);
    };
    return {count(most.x), count(most.y)};
  }

  template <class P>
  void take_samples(const P& projection, int chart, Vec2 corner, Vec2i n, Work& work) const {
    const auto most = static_cast<std::size_t>(n.x * n.y);
    work.directions.resize(most), work.weights.resize(most);
    std::size_t count = 0;
    const bool single = most == 1;
    const Vec2 step = 1.0f / Vec2(n);
    for (int j = 0; j < n.y; ++j)
      for (int i = 0; i < n.x; ++i) {
        const Vec2 pixel = corner + (Vec2(i, j) + 0.5f) * step;
        const MapPoint p{chart, uv_of(target_, pixel)};
        const auto d = projection.direction(p);
        if (!d) continue;
        work.directions[count] = turned_ ? to_source_ * *d : *d;
        work.weights[count++] = single ? 1 : projection.density(p);
      }
    work.directions.resize(count), work.weights.resize(count);
  }

  void do_tile(Work& work, int chart, int left, int top) {
    const Vec2i n = sample_counts(chart, left, top);
    Image& image = target_.charts[static_cast<std::size_t>(chart)];
    for (int y = top; y < std::min(top + tile_, image.height()); ++y)
      for (int x = left; x < std::min(left + tile_, image.width()); ++x) {
        const auto take = [&](Vec2i counts) {
          std::visit([&](const auto& p) { take_samples(p, chart, Vec2(x, y), counts, work); }, target_.projection);
        };
        take(n);
        if (work.directions.size() != static_cast<std::size_t>(n.x * n.y)) take(glm::max(n, Vec2i(4)));  // on the rim
        float total = 0;
        for (const float w : work.weights) total += w;
        if (!(total > 0)) continue;
        for (float& w : work.weights) w /= total;
        std::fill(work.sums.begin(), work.sums.end(), 0.0f);
        lookup_.add(work.directions, work.weights, work.sums);
        for (std::size_t c = 0; c < image.channel_count(); ++c) image.at(x, y, c) = work.sums[c];
      }
  }

  Lookup lookup_;
  Probe& target_;
  ResampleSettings settings_;
  Mat3 to_source_;
  bool turned_;
  int tile_;  // texels along a side that share a number of samples; balls change fast at their rim
};

bool same(const AnyProjection& a, const AnyProjection& b) {
  if (a.index() != b.index()) return false;
  if (const auto* f = std::get_if<Fisheye>(&a)) {
    const auto& g = std::get<Fisheye>(b);
    return f->lens == g.lens && f->field_of_view == g.field_of_view;
  }
  if (const auto* f = std::get_if<MirrorBall>(&a)) return f->distance == std::get<MirrorBall>(b).distance;
  if (const auto* f = std::get_if<Cube>(&a)) return f->opengl == std::get<Cube>(b).opengl;
  if (const auto* f = std::get_if<LatLong>(&a)) return f->centre_is_plus_z == std::get<LatLong>(b).centre_is_plus_z;
  return true;
}

}  // namespace

Probe resample(const Probe& source, const AnyProjection& projection, TexelRule texels, Vec2i size,
               const ResampleSettings& settings) {
  if (same(source.projection, projection) && source.texels == texels && settings.rotation == Mat3(1) &&
      size == Vec2i(source.width(), source.height()))
    return source;
  Probe target{projection, texels, {}};
  for (int i = 0; i < chart_count(projection); ++i)
    target.charts.emplace_back(size.x, size.y, source.charts.front().channels());
  target.charts.front().metadata = source.charts.front().metadata;
  target.charts.front().metadata.erase("probe.layout");
  Resampler(source, target, settings).run();
  return target;
}

Vec2i similar_size(const Probe& source, const AnyProjection& projection) {
  const float around = texels_around(source.projection, source.width());
  const float size = around / texels_around(projection, 1) / (std::holds_alternative<LatLong>(projection) ? 2.0f : 1);
  return chart_size(projection, std::max(1, static_cast<int>(std::lround(size))));
}

}  // namespace lambert::probe
