#include "lambert/image/hdr/expose.h"

#include "lambert/base/hash.h"
#include "lambert/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambert::hdr {
namespace {

/// Numbers that depend on the seed and the place alone.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t place) : state_(hash_values(seed, place)) {}
  double uniform() {  // in (0, 1)
    state_ += 0x9e3779b97f4a7c15ull;
    return (static_cast<double>(mix_bits(state_) >> 11) + 0.5) * 0x1p-53;
  }
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); }
  double poisson(double mean) {
    if (mean > 40) return std::max(0.0, std::round(mean + std::sqrt(mean) * normal()));
    double product = uniform();
    int count = 0;
    for (const double stop = std::exp(-mean); product > stop; ++count) product *= uniform();
    return count;
  }

 private:
  std::uint64_t state_;
};

double with_noise(double exposure, const SensorNoise& noise, std::uint64_t seed, std::uint64_t place) {
  if (!(noise.full_well > 0)) return exposure;
  Random random(seed, place);
  const double electrons = random.poisson(std::min(exposure, 4.0) * noise.full_well);
  return (electrons + noise.read_noise * random.normal()) / noise.full_well;
}

/// The map where picture point (x, y), whose whole numbers are centres, looks.
class Lens {
 public:
  Lens(const Image& map, const ExposeSettings& s)
      : map_(map),
        still_(s.move == Vec2d(0) && s.turn == 0),
        move_(s.move),
        cos_(std::cos(s.turn)),
        sin_(std::sin(s.turn)) {}
  double at(int x, int y, std::size_t c) const {
    if (still_) return static_cast<double>(map_.at(x, y, c));
    const double cx = 0.5 * (map_.width() - 1), cy = 0.5 * (map_.height() - 1);
    const double px = x - cx, py = y - cy;
    const double u = std::clamp(cx + cos_ * px - sin_ * py + move_.x, 0.0, map_.width() - 1.0);
    const double v = std::clamp(cy + sin_ * px + cos_ * py + move_.y, 0.0, map_.height() - 1.0);
    const int x0 = static_cast<int>(u), y0 = static_cast<int>(v);
    const int x1 = std::min(x0 + 1, map_.width() - 1), y1 = std::min(y0 + 1, map_.height() - 1);
    const auto value = [&](int px0, int py0) { return static_cast<double>(map_.at(px0, py0, c)); };
    const double top = std::lerp(value(x0, y0), value(x1, y0), u - x0);
    return std::lerp(top, std::lerp(value(x0, y1), value(x1, y1), u - x0), v - y0);
  }

 private:
  const Image& map_;
  bool still_;
  Vec2d move_;
  double cos_, sin_;
};

}  // namespace

DisplayImage expose(const Image& map, const Response& response, const ExposeSettings& settings) {
  const std::size_t channels = map.has_colour() ? 3 : 1;
  DisplayImage d{.width = map.width(), .height = map.height(), .channels = static_cast<int>(channels)};
  const std::size_t row = static_cast<std::size_t>(map.width()) * channels;
  const std::size_t count = row * static_cast<std::size_t>(map.height());
  if (settings.bits == 8)
    d.bytes.resize(count);
  else
    d.words.resize(count);
  const double top = std::exp2(settings.bits) - 1, levels = static_cast<double>(response.levels() - 1);
  const Lens lens(map, settings);
  parallel_for(static_cast<std::size_t>(map.height()), [&](std::size_t y) {
    for (std::size_t i = 0; i < row; ++i) {
      const std::size_t c = i % channels, place = y * row + i;
      const double light = lens.at(static_cast<int>(i / channels), static_cast<int>(y), c) * settings.exposure;
      const double exposure = with_noise(light > 0 ? light : 0, settings.noise, settings.seed, place);
      const double code = std::floor(encode(response.channel(c), exposure) / levels * top + 0.5);
      if (settings.bits == 8)
        d.bytes[place] = static_cast<std::uint8_t>(code);
      else
        d.words[place] = static_cast<std::uint16_t>(code);
    }
  });
  return d;
}

}  // namespace lambert::hdr
