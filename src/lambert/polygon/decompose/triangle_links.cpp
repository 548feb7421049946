#include "lambert/polygon/decompose/triangle_links.h"

#include <algorithm>
#include <cstddef>

namespace lambert::polygon {

std::vector<std::uint32_t> opposite_sides(std::span<const Triangle> triangles, std::size_t vertex_count) {
  struct Half {
    std::uint32_t to, side;
  };
  // Sorted into the lower of the two corners.
  std::vector<std::uint32_t> start(vertex_count + 1, 0);
  const auto each = [&](const auto& act) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t s = 0; s < 3; ++s) act(triangles[t][s], triangles[t][(s + 1) % 3], 3 * t + s);
  };
  each([&](std::uint32_t a, std::uint32_t b, std::uint32_t) { ++start[std::min(a, b) + 1]; });
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<Half> halves(3 * triangles.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  each([&](std::uint32_t a, std::uint32_t b, std::uint32_t side) {
    halves[next[std::min(a, b)]++] = {std::max(a, b), side};
  });

  std::vector<std::uint32_t> opposite(3 * triangles.size(), no_index);
  const auto forward = [&](std::uint32_t side) {
    const Triangle& t = triangles[side / 3];
    return t[side % 3] < t[(side % 3 + 1) % 3];
  };
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto begin = halves.begin() + start[v], end = halves.begin() + start[v + 1];
    std::sort(begin, end, [](const Half& a, const Half& b) { return a.to != b.to ? a.to < b.to : a.side < b.side; });
    for (auto run = begin; run != end;) {
      auto run_end = run;
      while (run_end != end && run_end->to == run->to) ++run_end;
      auto other = run;
      for (auto half = run; half != run_end; ++half) {
        if (!forward(half->side)) continue;
        while (other != run_end && forward(other->side)) ++other;
        if (other == run_end) break;
        opposite[half->side] = other->side;
        opposite[other->side] = half->side;
        ++other;
      }
      run = run_end;
    }
  }
  return opposite;
}

}  // namespace lambert::polygon
