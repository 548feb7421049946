#include "lambert/image/filter/nearest_covered.h"

#include "lambert/base/parallel.h"

#include <cstdint>
#include <limits>

namespace lambert {
namespace {

/// The row of the nearest covered pixel in the same column, or -1.
std::vector<int> nearest_rows(const Image& image, std::size_t c) {
  const int w = image.width(), h = image.height();
  std::vector<int> rows(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), -1);
  const auto at = [&](int x, int y) -> int& {
    return rows[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) at(x, y) = image.at(x, y, c) > 0 ? y : y > 0 ? at(x, y - 1) : -1;
  for (int y = h - 2; y >= 0; --y)
    for (int x = 0; x < w; ++x)
      if (const int below = at(x, y + 1), above = at(x, y); below >= 0 && (above < 0 || below - y < y - above))
        at(x, y) = below;
  return rows;
}

/// A column of the envelope: nearest from place `from` on.
struct Parabola {
  int column;
  double from;
};

}  // namespace

std::vector<Vec2i> nearest_covered(const Image& image, std::size_t c) {
  const int w = image.width();
  const std::vector<int> rows = nearest_rows(image, c);
  std::vector<Vec2i> nearest(rows.size(), Vec2i(-1));
  parallel_for(static_cast<std::size_t>(image.height()), [&](std::size_t row) {
    const int* line = &rows[row * static_cast<std::size_t>(w)];
    const auto height_of = [&](int x) {
      const double d = line[x] - static_cast<double>(row);
      return d * d;
    };
    std::vector<Parabola> envelope;
    for (int x = 0; x < w; ++x) {
      if (line[x] < 0) continue;
      double from = -std::numeric_limits<double>::infinity();
      while (!envelope.empty()) {
        const int last = envelope.back().column;
        const double squares = static_cast<double>(x) * x - static_cast<double>(last) * last;
        from = (height_of(x) - height_of(last) + squares) / (2.0 * (x - last));
        if (from > envelope.back().from) break;
        envelope.pop_back();
      }
      envelope.push_back({x, envelope.empty() ? -std::numeric_limits<double>::infinity() : from});
    }
    std::size_t i = 0;
    for (int x = 0; x < w && !envelope.empty(); ++x) {
      while (i + 1 < envelope.size() && envelope[i + 1].from < x) ++i;
      const int column = envelope[i].column;
      nearest[row * static_cast<std::size_t>(w) + static_cast<std::size_t>(x)] = {column, line[column]};
    }
  });
  return nearest;
}

}  // namespace lambert
