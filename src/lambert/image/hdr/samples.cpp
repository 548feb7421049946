#include "lambert/image/hdr/samples.h"

#include "lambert/base/hash.h"
#include "lambert/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <unordered_set>

namespace lambert::hdr {
namespace {

constexpr int most_candidates = 80000;
constexpr std::size_t bins = 64, enough_of_a_bin = 500;

/// Cells of a grid, one candidate in each, somewhere in it.
struct Grid {
  int step, columns, rows, width, height;
  explicit Grid(const ExposureStack& s)
      : step(std::max(
            1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(s.width) * s.height / most_candidates))))),
        columns((s.width + step - 1) / step),
        rows((s.height + step - 1) / step),
        width(s.width),
        height(s.height) {}
  std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  Vec2i candidate(std::size_t cell) const {
    const std::uint64_t jitter = hash_values(cell), s = static_cast<std::uint64_t>(step);
    const int column = static_cast<int>(cell % static_cast<std::size_t>(columns));
    const int row = static_cast<int>(cell / static_cast<std::size_t>(columns));
    return {std::min(column * step + static_cast<int>(jitter % s), width - 1),
            std::min(row * step + static_cast<int>((jitter >> 32) % s), height - 1)};
  }
};

/// The codes of all candidates, as [(cell * channels + channel) * frames + frame]; 0 where a frame does not cover one.
/// Collected row after row, as the selection's own order would wait for memory at each.
template <class Code>
std::vector<Code> candidate_codes(const ExposureStack& stack, const Grid& grid) {
  const std::size_t n = stack.frames.size(), channels = stack.channels;
  std::vector<Code> codes(grid.count() * channels * n);
  parallel_for(static_cast<std::size_t>(grid.rows), [&](std::size_t row) {
    const auto columns = static_cast<std::size_t>(grid.columns);
    for (std::size_t cell = row * columns; cell < (row + 1) * columns; ++cell) {
      const Vec2i at = grid.candidate(cell);
      for (std::size_t j = 0; j < n; ++j) {
        const Span covered = stack.covered(j, at.y);
        if (at.x < covered.begin || at.x >= covered.end) continue;
        const Code* from = stack.row<Code>(j, at.y) + static_cast<std::size_t>(at.x) * channels;
        for (std::size_t c = 0; c < channels; ++c) codes[(cell * channels + c) * n + j] = from[c];
      }
    }
  });
  return codes;
}

/// Central differences; at the border to the one neighbour.
template <class Code>
float slope_at(const ExposureStack& stack, std::size_t frame, std::size_t channel, Vec2i at) {
  const int x0 = std::max(at.x - 1, 0), x1 = std::min(at.x + 1, stack.width - 1);
  const int y0 = std::max(at.y - 1, 0), y1 = std::min(at.y + 1, stack.height - 1);
  const auto code = [&](int x, int y) {
    return static_cast<int>(stack.row<Code>(frame, y)[static_cast<std::size_t>(x) * stack.channels + channel]);
  };
  const float dx = static_cast<float>(code(x1, at.y) - code(x0, at.y)) / static_cast<float>(std::max(1, x1 - x0));
  const float dy = static_cast<float>(code(at.x, y1) - code(at.x, y0)) / static_cast<float>(std::max(1, y1 - y0));
  return std::sqrt(dx * dx + dy * dy);
}

/// A sample is where `cells` says.
struct Selection {
  Samples samples;
  std::vector<std::size_t> cells;
};

template <class Code>
Selection select(const ExposureStack& stack, const Grid& grid, const std::vector<Code>& candidates,
                 std::size_t channel) {
  const std::size_t n = stack.frames.size();
  Selection selection{.samples = {.frames = n, .usable = usable_codes(stack, channel)}};
  Samples& samples = selection.samples;
  for (const Frame& frame : stack.frames) samples.log_exposures.push_back(std::log(frame.exposure));
  // A step prime to the number of cells visits them all, far apart one after the other.
  std::size_t step = static_cast<std::size_t>(0.618033988749895 * static_cast<double>(grid.count())) | 1;
  while (std::gcd(step, grid.count()) != 1) step += 2;
  step %= grid.count();
  std::array<std::size_t, bins> taken{};
  constexpr std::size_t codes_per_bin = (std::size_t{std::numeric_limits<Code>::max()} + 1) / bins;
  std::unordered_set<std::uint64_t> seen(grid.count());
  std::size_t cell = 0;
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const std::span<const Code> codes(candidates.data() + (cell * stack.channels + channel) * n, n);
    const std::size_t here = cell;
    if ((cell += step) >= grid.count()) cell -= grid.count();
    int usable = 0;
    bool rare = false;
    for (const Code code : codes) {
      if (!samples.usable.contains(code)) continue;
      ++usable;
      rare |= taken[code / codes_per_bin] < enough_of_a_bin;
    }
    if (usable < 2 || !rare) continue;
    std::uint64_t together = 0;
    for (const Code code : codes) together = hash_values(together, code);
    if (!seen.insert(together).second) continue;
    selection.cells.push_back(here);
    for (const Code code : codes) {
      if (samples.usable.contains(code)) ++taken[code / codes_per_bin];
      samples.codes.push_back(code);
    }
  }
  return selection;
}

/// In the order of the image, as that of the selection would wait for memory at each sample.
template <class Code>
void find_slopes(const ExposureStack& stack, const Grid& grid, std::vector<Selection>& selections) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> sample_of(grid.count() * stack.channels, none);
  for (std::size_t c = 0; c < stack.channels; ++c) {
    const std::vector<std::size_t>& cells = selections[c].cells;
    for (std::size_t i = 0; i < cells.size(); ++i)
      sample_of[cells[i] * stack.channels + c] = static_cast<std::uint32_t>(i);
    selections[c].samples.slopes.resize(selections[c].samples.codes.size());
  }
  parallel_for(static_cast<std::size_t>(grid.rows), [&](std::size_t row) {
    const auto columns = static_cast<std::size_t>(grid.columns);
    for (std::size_t cell = row * columns; cell < (row + 1) * columns; ++cell)
      for (std::size_t c = 0; c < stack.channels; ++c) {
        const std::size_t i = sample_of[cell * stack.channels + c];
        if (i == none) continue;
        for (std::size_t j = 0; j < stack.frames.size(); ++j)
          selections[c].samples.slopes[i * stack.frames.size() + j] = slope_at<Code>(stack, j, c, grid.candidate(cell));
      }
  });
}

/// The code at which the two longest exposures both end with many pixels, if they do below the top one.
template <class Code>
int clipping_code(const ExposureStack& stack, std::size_t channel) {
  const int top = stack.levels - 1, near = std::max(1, stack.levels / 256);
  const auto largest = [&](std::size_t frame) {
    const std::span<const Code> codes = stack.codes<Code>(frame);
    int most = 0;
    for (std::size_t i = channel; i < codes.size() && most < top; i += stack.channels)
      most = std::max<int>(most, codes[i]);
    return most;
  };
  const std::size_t n = stack.frames.size();
  if (n < 2) return top;
  const int clip = largest(n - 1);
  if (clip == top || clip < stack.levels / 2 || std::abs(largest(n - 2) - clip) > near) return top;
  for (std::size_t j = n - 2; j < n; ++j) {
    const std::span<const Code> codes = stack.codes<Code>(j);
    std::size_t clipped = 0;
    for (std::size_t i = channel; i < codes.size(); i += stack.channels) clipped += codes[i] >= clip - near;
    if (clipped * 200 * stack.channels < codes.size()) return top;
  }
  return clip - near;
}

/// The least code, of 199 in 200, that pixels have which are at `clip` or above it in a clearly shorter exposure.
template <class Code>
int scattered_to(const ExposureStack& stack, std::size_t channel, int clip) {
  const std::size_t codes_per_bin = std::max<std::size_t>(1, static_cast<std::size_t>(stack.levels) / 256);
  std::vector<std::size_t> found(static_cast<std::size_t>(clip) / codes_per_bin + 1);
  std::size_t count = 0;
  for (std::size_t j = 0; j + 1 < stack.frames.size(); ++j) {
    if (stack.frames[j + 1].exposure < 1.3 * stack.frames[j].exposure) continue;
    for (int y = 0; y < stack.height; y += static_cast<int>(stack.row_step(500000))) {
      const Span a = stack.covered(j, y), b = stack.covered(j + 1, y);
      const Code *shorter = stack.row<Code>(j, y), *longer = stack.row<Code>(j + 1, y);
      for (int x = std::max(a.begin, b.begin); x < std::min(a.end, b.end); ++x) {
        const std::size_t i = static_cast<std::size_t>(x) * stack.channels + channel;
        if (shorter[i] < clip) continue;
        ++found[std::min<std::size_t>(longer[i] / codes_per_bin, found.size() - 1)], ++count;
      }
    }
  }
  if (count < 64) return clip;
  std::size_t bin = 0;
  for (std::size_t below = found[0]; below * 200 < count && bin + 1 < found.size(); below += found[++bin]) {
  }
  return bin + 1 < found.size() ? static_cast<int>(bin * codes_per_bin) : clip;
}

}  // namespace

UsableCodes usable_codes(const ExposureStack& stack, std::size_t channel) {
  return stack.with_code_type([&]<class Code>(Code) {
    const int clip = clipping_code<Code>(stack, channel);
    const int reached = scattered_to<Code>(stack, channel, clip);
    return UsableCodes{0, std::max(reached, clip - stack.levels / 8), reached < clip};
  });
}

std::vector<Samples> select_samples(const ExposureStack& stack) {
  const Grid grid(stack);
  std::vector<Selection> selections(stack.channels);
  stack.with_code_type([&]<class Code>(Code) {
    const std::vector<Code> candidates = candidate_codes<Code>(stack, grid);
    parallel_for(stack.channels, [&](std::size_t c) { selections[c] = select<Code>(stack, grid, candidates, c); });
    find_slopes<Code>(stack, grid, selections);
  });
  std::vector<Samples> samples;
  for (Selection& selection : selections) samples.push_back(std::move(selection.samples));
  return samples;
}

}  // namespace lambert::hdr
