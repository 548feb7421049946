#include "lambert/image/hdr/threshold_bitmap.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lambert::hdr {
namespace {

using Histogram = std::array<std::size_t, 256>;

Histogram histogram(const Grey& grey) {
  Histogram h{};
  for (const std::uint8_t z : grey.pixels) ++h[z];
  return h;
}

int percentile(const Histogram& h, std::size_t count, double share) {
  std::size_t below = 0;
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(count));
  for (int z = 0; z < 255; ++z)
    if ((below += h[static_cast<std::size_t>(z)]) > wanted) return z;
  return 255;
}

/// Bit 0: brighter than the threshold; bit 1: far enough from it to count.
std::vector<std::uint8_t> bitmap(const Grey& grey, int threshold) {
  std::vector<std::uint8_t> bits(grey.pixels.size());
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const int z = grey.pixels[i];
    bits[i] = static_cast<std::uint8_t>((z > threshold ? 1 : 0) | (z > threshold + 4 || z < threshold - 4 ? 2 : 0));
  }
  return bits;
}

/// The share of overlapping pixels that count in both and differ.
double difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, int width, int height,
                  Vec2i shift) {
  const int x0 = std::max(0, -shift.x), x1 = std::min(width, width - shift.x);
  const int y0 = std::max(0, -shift.y), y1 = std::min(height, height - shift.y);
  if (x1 - x0 < width / 4 || y1 - y0 < height / 4) return std::numeric_limits<double>::infinity();
  std::size_t differing = 0;
  for (int y = y0; y < y1; ++y) {
    const std::uint8_t* p = a.data() + static_cast<std::ptrdiff_t>(y) * width;
    const std::uint8_t* q = b.data() + static_cast<std::ptrdiff_t>(y + shift.y) * width + shift.x;
    std::uint32_t row = 0;
    for (int x = x0; x < x1; ++x) row += ((p[x] ^ q[x]) & ((p[x] & q[x]) >> 1)) & 1u;
    differing += row;
  }
  return static_cast<double>(differing) / (static_cast<double>(x1 - x0) * (y1 - y0));
}

/// The percentile at which both pictures are farthest from black and white; the median when it is good enough.
double best_percentile(const Grey& a, const Grey& b) {
  const Histogram ha = histogram(a), hb = histogram(b);
  double best = 0.5;
  int most = -1;
  for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9, 0.05, 0.95, 0.02, 0.98}) {
    const int za = percentile(ha, a.pixels.size(), share), zb = percentile(hb, b.pixels.size(), share);
    const int room = std::min({za, zb, 255 - za, 255 - zb, 24});
    if (room > most) most = room, best = share;
  }
  return best;
}

}  // namespace

Vec2i bitmap_shift(const std::vector<Grey>& reference, const std::vector<Grey>& other, int largest) {
  int levels = 1;
  while ((1 << levels) <= largest) ++levels;
  levels = std::min(levels, static_cast<int>(reference.size()));
  const double share = best_percentile(reference[0], other[0]);
  Vec2i shift(0);
  for (int level = levels - 1; level >= 0; --level) {
    const Grey &a = reference[static_cast<std::size_t>(level)], &b = other[static_cast<std::size_t>(level)];
    const auto bits_a = bitmap(a, percentile(histogram(a), a.pixels.size(), share)),
               bits_b = bitmap(b, percentile(histogram(b), b.pixels.size(), share));
    shift *= 2;
    std::array<Vec2i, 9> candidates;
    for (int i = 0; i < 9; ++i) candidates[static_cast<std::size_t>(i)] = shift + Vec2i(i % 3 - 1, i / 3 - 1);
    std::swap(candidates[0], candidates[4]);  // of equals the one that moves least
    std::array<double, 9> differences{};
    parallel_for(9,
                 [&](std::size_t i) { differences[i] = difference(bits_a, bits_b, a.width, a.height, candidates[i]); });
    shift = candidates[static_cast<std::size_t>(std::min_element(differences.begin(), differences.end()) -
                                                differences.begin())];
  }
  return shift;
}

}  // namespace lambert::hdr
