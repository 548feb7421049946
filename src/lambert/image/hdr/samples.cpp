#include "lambert/image/hdr/samples.h"

#include "lambert/base/hash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_set>

namespace lambert::hdr {
namespace {

constexpr int most_candidates = 80000;
constexpr std::size_t bins = 64, enough_of_a_bin = 500;

int code_at(const ExposureStack& stack, std::size_t frame, std::size_t channel, int x, int y) {
  return stack.row(frame, y)[static_cast<std::size_t>(x) * stack.channels + channel];
}

/// Central differences; at the border to the one neighbour.
float slope_at(const ExposureStack& stack, std::size_t frame, std::size_t channel, int x, int y) {
  const auto along = [&](int dx, int dy) {
    const int x0 = std::max(x - dx, 0), y0 = std::max(y - dy, 0);
    const int x1 = std::min(x + dx, stack.width - 1), y1 = std::min(y + dy, stack.height - 1);
    const int steps = std::max(1, (x1 - x0) + (y1 - y0));
    return static_cast<float>(code_at(stack, frame, channel, x1, y1) - code_at(stack, frame, channel, x0, y0)) /
           static_cast<float>(steps);
  };
  return std::hypot(along(1, 0), along(0, 1));
}

/// Cells of a grid, one candidate in each.
struct Grid {
  int step, columns, rows;
  explicit Grid(const ExposureStack& s)
      : step(std::max(
            1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(s.width) * s.height / most_candidates))))),
        columns((s.width + step - 1) / step),
        rows((s.height + step - 1) / step) {}
  std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

}  // namespace

UsableCodes usable_codes(const ExposureStack& stack, std::size_t channel) {
  const int top = stack.levels - 1, near = std::max(1, stack.levels / 256);
  const auto largest = [&](const Frame& frame) {
    int most = 0;
    for (std::size_t i = channel; i < frame.codes.size() && most < top; i += stack.channels)
      most = std::max<int>(most, frame.codes[i]);
    return most;
  };
  const std::size_t n = stack.frames.size();
  if (n < 2) return {0, top};
  const int clip = largest(stack.frames[n - 1]);
  if (clip == top || clip < stack.levels / 2 || std::abs(largest(stack.frames[n - 2]) - clip) > near) return {0, top};
  for (std::size_t j = n - 2; j < n; ++j) {
    const auto& codes = stack.frames[j].codes;
    std::size_t clipped = 0;
    for (std::size_t i = channel; i < codes.size(); i += stack.channels) clipped += codes[i] >= clip - near;
    if (clipped * 200 * stack.channels < codes.size()) return {0, top};
  }
  return {0, clip - near};
}

Samples select_samples(const ExposureStack& stack, std::size_t channel) {
  const std::size_t n = stack.frames.size();
  Samples samples{.frames = n, .usable = usable_codes(stack, channel)};
  for (const Frame& frame : stack.frames) samples.log_exposures.push_back(std::log(frame.exposure));
  const Grid grid(stack);
  // A step prime to the number of cells visits them all, far apart one after the other.
  std::size_t step = static_cast<std::size_t>(0.618033988749895 * static_cast<double>(grid.count())) | 1;
  while (std::gcd(step, grid.count()) != 1) step += 2;
  std::array<std::size_t, bins> taken{};
  const std::size_t codes_per_bin = static_cast<std::size_t>(stack.levels) / bins;
  std::vector<std::uint16_t> codes(n);
  std::unordered_set<std::uint64_t> seen;
  std::size_t cell = 0;
  for (std::size_t i = 0; i < grid.count(); ++i, cell = (cell + step) % grid.count()) {
    const std::uint64_t jitter = hash_values(cell);
    const int s = grid.step, column = static_cast<int>(cell % static_cast<std::size_t>(grid.columns));
    const int row = static_cast<int>(cell / static_cast<std::size_t>(grid.columns));
    const int x = std::min(column * s + static_cast<int>(jitter % static_cast<std::uint64_t>(s)), stack.width - 1);
    const int y =
        std::min(row * s + static_cast<int>((jitter >> 32) % static_cast<std::uint64_t>(s)), stack.height - 1);
    int usable = 0;
    bool rare = false;
    for (std::size_t j = 0; j < n; ++j) {
      const Span covered = stack.covered(j, y);
      const int code = x >= covered.begin && x < covered.end ? code_at(stack, j, channel, x, y) : 0;
      codes[j] = static_cast<std::uint16_t>(code);
      if (!samples.usable.contains(code)) continue;
      ++usable;
      rare |= taken[static_cast<std::size_t>(code) / codes_per_bin] < enough_of_a_bin;
    }
    if (usable < 2 || !rare) continue;
    std::uint64_t together = 0;
    for (const std::uint16_t code : codes) together = hash_values(together, code);
    if (!seen.insert(together).second) continue;
    for (std::size_t j = 0; j < n; ++j) {
      if (samples.usable.contains(codes[j])) ++taken[codes[j] / codes_per_bin];
      samples.codes.push_back(codes[j]);
      samples.slopes.push_back(slope_at(stack, j, channel, x, y));
    }
  }
  return samples;
}

}  // namespace lambert::hdr
