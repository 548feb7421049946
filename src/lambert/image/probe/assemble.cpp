#include "lambert/image/probe/assemble.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/probe/lookup.h"
#include "lambert/image/probe/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace lambert::probe {
namespace {

float smooth(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// How far a view is to be trusted along `d` of its ball's frame; never quite 0 where it sees anything.
float trust(Vec3 d, const AssembleSettings& s, const AnyProjection& ball) {
  if (!point(ball, d)) return 0;
  const float theta = std::acos(std::clamp(d.z, -1.0f, 1.0f)), feather = std::max(s.feather.radians(), 1e-4f);
  const float centre = smooth((theta - s.camera_radius.radians()) / feather);
  const float rim = smooth((s.rim.radians() + feather - theta) / feather);
  const float resolution = 0.5f * (1 + d.z);
  // The least bad: far from the camera first, then the rim.
  return std::max(centre * rim * resolution, 1e-6f * centre * (0.01f + resolution) + 1e-12f);
}

/// Directions spread evenly over the sphere (a Fibonacci spiral).
std::vector<Vec3> spread_directions(int count) {
  std::vector<Vec3> directions;
  constexpr double golden = 2.399963229728653;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, ring = std::sqrt(1 - z * z);
    directions.push_back(Vec3(Vec3d(ring * std::cos(golden * i), z, ring * std::sin(golden * i))));
  }
  return directions;
}

Probe lat_long_of(const Probe& ball, const Mat3& rotation, int rows) {
  return resample(ball, LatLong{}, TexelRule::cells, chart_size(LatLong{}, rows), {.rotation = rotation});
}

/// Log luminance of a view, coarse and fine, in the ball's frame.
struct Pattern {
  explicit Pattern(const Probe& ball, int rows) : map(lat_long_of(ball, Mat3(1), rows)) {
    Image grey(map.width(), map.height(), {"Y"});
    float low = 0;
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) low += std::max(0.0f, luminance(map.charts[0].rgb(x, y)));
    low = std::max(1e-3f * low / static_cast<float>(map.width() * map.height()), 1e-12f);
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x)
        grey.at(x, y, 0) = std::log(std::max(luminance(map.charts[0].rgb(x, y)), 0.0f) + low);
    map.charts = {std::move(grey)};
    lookup = std::make_unique<Lookup>(map);
  }
  float at(Vec3 d) const { return lookup->rgb(d).r; }
  Probe map;
  std::unique_ptr<Lookup> lookup;
};

/// The weighted correlation of two patterns, b turned by `rotation`.
double correlation(const Pattern& a, const Mat3& a_rotation, const Probe& a_ball, const Pattern& b,
                   const Mat3& b_rotation, const Probe& b_ball, const std::vector<Vec3>& directions,
                   const AssembleSettings& s) {
  double n = 0, sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
  const Mat3 to_a = glm::transpose(a_rotation), to_b = glm::transpose(b_rotation);
  for (const Vec3 d : directions) {
    const Vec3 da = to_a * d, db = to_b * d;
    const float both = trust(da, s, a_ball.projection) * trust(db, s, b_ball.projection);
    if (!(both > 1e-4f)) continue;
    const auto w = static_cast<double>(std::sqrt(both));
    const auto va = static_cast<double>(a.at(da)), vb = static_cast<double>(b.at(db));
    n += w, sum_a += w * va, sum_b += w * vb, aa += w * va * va, bb += w * vb * vb, ab += w * va * vb;
  }
  if (!(n > 0)) return 0;
  const double mean_a = sum_a / n, mean_b = sum_b / n;
  const double cov = ab / n - mean_a * mean_b, var_a = aa / n - mean_a * mean_a, var_b = bb / n - mean_b * mean_b;
  return var_a > 1e-9 && var_b > 1e-9 ? cov / std::sqrt(var_a * var_b) : 0;
}

Mat3 small_turn(const std::array<float, 3>& angles) {
  return rotation(degrees(angles[0]), degrees(angles[1]), degrees(angles[2]));
}

struct Alignment {
  Mat3 rotation;
  double correlation;
};

/// Coarse to fine: a grid about all three axes, then steps that halve.
Alignment align(const Pattern* const (&coarse)[2], const Pattern* const (&fine)[2], const Mat3& first,
                const Probe& first_ball, const Mat3& guess, const Probe& ball, const AssembleSettings& s) {
  const std::vector<Vec3> few = spread_directions(1500), many = spread_directions(12000);
  std::array<float, 3> best{};
  const auto score = [&](const std::array<float, 3>& angles, bool exact) {
    const auto& p = exact ? fine : coarse;
    return correlation(*p[0], first, first_ball, *p[1], small_turn(angles) * guess, ball, exact ? many : few, s);
  };
  double top = score(best, false);
  const float reach = s.search.degrees(), step = 0.5f * reach;
  std::vector<std::array<float, 3>> tries;
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b)
      for (int c = -2; c <= 2; ++c)
        tries.push_back({step * static_cast<float>(a), step * static_cast<float>(b), step * static_cast<float>(c)});
  std::vector<double> scores(tries.size());
  parallel_for(tries.size(), [&](std::size_t i) { scores[i] = score(tries[i], false); });
  for (std::size_t i = 0; i < tries.size(); ++i)
    if (scores[i] > top) top = scores[i], best = tries[i];
  bool exact = false;
  for (float h = 0.5f * step; h > 0.02f; h *= 0.5f) {
    if (!exact && h < 1) exact = true, top = score(best, true);
    for (int round = 0; round < 4; ++round) {
      std::vector<std::array<float, 3>> around;
      for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f}) {
          around.push_back(best);
          around.back()[static_cast<std::size_t>(axis)] += sign * h;
        }
      std::vector<double> found(around.size());
      parallel_for(around.size(), [&](std::size_t i) { found[i] = score(around[i], exact); });
      const auto k = static_cast<std::size_t>(std::max_element(found.begin(), found.end()) - found.begin());
      if (!(found[k] > top)) break;
      top = found[k], best = around[k];
    }
  }
  return {small_turn(best) * guess, score(best, true)};
}

/// The median ratio of what both views see well.
Rgb exposure_ratio(const Lookup& a, const Mat3& a_rotation, const Lookup& b, const Mat3& b_rotation,
                   const AssembleSettings& s) {
  const Mat3 to_a = glm::transpose(a_rotation), to_b = glm::transpose(b_rotation);
  std::vector<float> ratios[3];
  for (const Vec3 d : spread_directions(20000)) {
    const Vec3 da = to_a * d, db = to_b * d;
    const float both = trust(da, s, a.probe().projection) * trust(db, s, b.probe().projection);
    if (!(both > 1e-3f)) continue;
    const Rgb ca = a.rgb(da), cb = b.rgb(db);
    for (int k = 0; k < 3; ++k)
      if (ca[k] > 0 && cb[k] > 0) ratios[k].push_back(ca[k] / cb[k]);
  }
  float median[3] = {1, 1, 1};
  for (int k = 0; k < 3; ++k) {
    if (ratios[k].size() < 16) continue;
    const auto middle = ratios[k].begin() + static_cast<std::ptrdiff_t>(ratios[k].size() / 2);
    std::nth_element(ratios[k].begin(), middle, ratios[k].end());
    median[k] = *middle;
  }
  return {median[0], median[1], median[2]};
}

}  // namespace

Assembly assemble(const std::vector<BallView>& views, int rows, const AssembleSettings& settings) {
  if (views.size() < 2) throw Error("an assembly needs photographs from at least two directions");
  for (const BallView& v : views) {
    if (!std::holds_alternative<MirrorBall>(v.ball.projection)) throw Error("an assembly needs mirror balls");
    if (!std::isfinite(v.azimuth.radians())) throw Error("an assembly needs angles that are numbers");
    if (v.ball.charts.front().channels() != views.front().ball.charts.front().channels())
      throw Error("the photographs have different channels");
  }
  Assembly result;
  std::vector<std::unique_ptr<Pattern>> coarse, fine;
  std::vector<std::unique_ptr<Lookup>> lookups;
  for (const BallView& v : views) {
    lookups.push_back(std::make_unique<Lookup>(v.ball));
    if (!settings.align) continue;
    coarse.push_back(std::make_unique<Pattern>(v.ball, 48));
    fine.push_back(std::make_unique<Pattern>(v.ball, 256));
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Angle turn = views[i].azimuth - views.front().azimuth;
    Alignment found{rotation(turn, degrees(0), degrees(0)), 1};
    if (i > 0 && settings.align) {
      const Pattern* const c[2] = {coarse[0].get(), coarse[i].get()};
      const Pattern* const f[2] = {fine[0].get(), fine[i].get()};
      found = align(c, f, result.rotations[0], views[0].ball, found.rotation, views[i].ball, settings);
    }
    result.rotations.push_back(found.rotation);
    result.correlations.push_back(static_cast<float>(found.correlation));
    const bool match = i > 0 && settings.match_exposure;
    result.exposures.push_back(
        match ? exposure_ratio(*lookups[0], result.rotations[0], *lookups[i], found.rotation, settings) : Rgb(1));
  }

  std::vector<Probe> maps;
  for (std::size_t i = 0; i < views.size(); ++i) maps.push_back(lat_long_of(views[i].ball, result.rotations[i], rows));
  result.probe = maps.front();
  Image& out = result.probe.charts.front();
  const std::size_t channels = out.channel_count();
  const bool colour = out.has_colour();
  parallel_for(static_cast<std::size_t>(out.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    std::vector<float> weights(views.size());
    for (int x = 0; x < out.width(); ++x) {
      const Vec2 uv = (Vec2(x, y) + 0.5f) / Vec2(out.width(), out.height());
      const Vec3 d = *LatLong{}.direction({0, uv});
      float total = 0;
      for (std::size_t i = 0; i < views.size(); ++i)
        total += weights[i] = trust(glm::transpose(result.rotations[i]) * d, settings, views[i].ball.projection);
      for (std::size_t c = 0; c < channels; ++c) {
        float sum = 0;
        for (std::size_t i = 0; i < views.size(); ++i) {
          const float scale = colour && c < 3 ? result.exposures[i][static_cast<int>(c)]
                              : c == 0        ? result.exposures[i].r
                                              : 1;
          sum += weights[i] * scale * maps[i].charts.front().at(x, y, c);
        }
        out.at(x, y, c) = total > 0 ? sum / total : 0;
      }
    }
  });
  return result;
}

}  // namespace lambert::probe
