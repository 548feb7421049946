#include "lambert/image/hdr/transfer.h"

#include "lambert/image/hdr/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lambert::hdr {
namespace {

struct Sample {
  float value, dx, dy;  // code and its slopes
};

/// Bilinear; none outside.
std::optional<Sample> sample(const Grey& g, double x, double y) {
  if (!(x >= 0 && y >= 0 && x < g.width - 1 && y < g.height - 1)) return std::nullopt;
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const float u = static_cast<float>(x - ix), v = static_cast<float>(y - iy);
  const float a = g.at(ix, iy), b = g.at(ix + 1, iy), c = g.at(ix, iy + 1), d = g.at(ix + 1, iy + 1);
  const float top = a + (b - a) * u, bottom = c + (d - c) * u;
  return Sample{top + (bottom - top) * v, (b - a) + ((d - c) - (b - a)) * v, bottom - top};
}

int stride(const Grey& g) {
  return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(g.width) * g.height / 200000)));
}

/// Where `motion` sees the pixels of a picture.
class Map {
 public:
  Map(const Grey& g, const Motion& m)
      : cx_(0.5 * (g.width - 1)),
        cy_(0.5 * (g.height - 1)),
        c_(std::cos(m.turn)),
        s_(std::sin(m.turn)),
        shift_(m.shift) {}
  Vec2d centred(int x, int y) const { return {x - cx_, y - cy_}; }
  Vec2d seen(Vec2d p) const { return {cx_ + c_ * p.x - s_ * p.y + shift_.x, cy_ + s_ * p.x + c_ * p.y + shift_.y}; }
  /// By the turn.
  Vec2d turned(Vec2d p) const { return {-s_ * p.x - c_ * p.y, c_ * p.x - s_ * p.y}; }

 private:
  double cx_, cy_, c_, s_;
  Vec2d shift_;
};

constexpr float black = 4, white = 250;

bool step(const Grey& reference, const Grey& other, Motion& motion) {
  const Transfer t = transfer(reference, other, motion);
  const Map map(reference, motion);
  const float scale = static_cast<float>(std::max(t.spread, 1.0));
  SymmetricMatrix a(3);
  std::vector<double> b(3);
  const int every = stride(reference);
  for (int y = 0; y < reference.height; y += every)
    for (int x = 0; x < reference.width; x += every) {
      const float expected = t.mean[reference.at(x, y)];
      if (std::isnan(expected)) continue;
      const Vec2d p = map.centred(x, y), at = map.seen(p);
      const auto s = sample(other, at.x, at.y);
      if (!s || s->value <= black || s->value >= white) continue;
      const float r = s->value - expected;
      const double w = static_cast<double>(1 / (1 + r * r / scale));
      const Vec2d turned = map.turned(p);
      const double j[3] = {static_cast<double>(s->dx), static_cast<double>(s->dy),
                           static_cast<double>(s->dx) * turned.x + static_cast<double>(s->dy) * turned.y};
      for (std::size_t i = 0; i < 3; ++i) {
        b[i] -= w * j[i] * static_cast<double>(r);
        for (std::size_t k = 0; k <= i; ++k) a.at(i, k) += w * j[i] * j[k];
      }
    }
  const auto d = solve_positive(std::move(a), std::move(b));
  if (!d) return false;
  const double limit = 2, turn_limit = 2.0 / std::max(reference.width, reference.height) * 2;
  motion.shift += glm::clamp(Vec2d((*d)[0], (*d)[1]), Vec2d(-limit), Vec2d(limit));
  motion.turn += std::clamp((*d)[2], -turn_limit, turn_limit);
  return std::abs((*d)[0]) + std::abs((*d)[1]) + std::abs((*d)[2]) * reference.width > 0.01;
}

}  // namespace

Transfer transfer(const Grey& reference, const Grey& other, const Motion& motion) {
  std::array<double, 256> count{}, sum{}, squares{};
  const Map map(reference, motion);
  const int every = stride(reference);
  const bool whole = motion.whole();
  const Vec2i shift = Vec2i(glm::round(motion.shift));
  const auto add = [&](std::uint8_t z, float value) {
    const auto v = static_cast<double>(value);
    ++count[z], sum[z] += v, squares[z] += v * v;
  };
  for (int y = 0; y < reference.height; y += every)
    for (int x = 0; x < reference.width; x += every) {
      const std::uint8_t z = reference.at(x, y);
      if (z <= black || z >= white) continue;
      if (whole) {
        const int ox = x + shift.x, oy = y + shift.y;
        if (ox >= 0 && oy >= 0 && ox < other.width && oy < other.height) add(z, other.at(ox, oy));
      } else {
        const Vec2d at = map.seen(map.centred(x, y));
        if (const auto s = sample(other, at.x, at.y)) add(z, s->value);
      }
    }
  Transfer t;
  double variance = 0;
  for (std::size_t z = 0; z < 256; ++z) {
    t.mean[z] = std::numeric_limits<float>::quiet_NaN();
    if (count[z] < 8) continue;
    const double mean = sum[z] / count[z];
    variance += squares[z] - sum[z] * mean;
    t.pixels += static_cast<std::size_t>(count[z]);
    if (mean > static_cast<double>(black) && mean < static_cast<double>(white)) t.mean[z] = static_cast<float>(mean);
  }
  t.spread = t.pixels ? std::max(variance, 0.0) / static_cast<double>(t.pixels) : 0;
  return t;
}

Motion refined(const std::vector<Grey>& reference, const std::vector<Grey>& other, const Motion& start) {
  Motion motion = start;
  const std::size_t levels = std::min<std::size_t>(5, reference.size());
  for (std::size_t level = levels; level-- > 0;) {
    const double scale = std::exp2(-static_cast<double>(level));
    Motion here{motion.shift * scale, motion.turn};
    for (int turn = 0; turn < 8 && step(reference[level], other[level], here); ++turn) {
    }
    motion = {here.shift / scale, here.turn};
  }
  return motion;
}

}  // namespace lambert::hdr
