#include "lambert/polygon/arrangement/boxes.h"

#include <numeric>

namespace lambert::polygon::arrangement {
namespace {

constexpr std::uint32_t longest_run = 16;

/// Which of the four quadrants of direction an edge fits: bit 0 right and up, 1 left and up, 2 right and down, 3 left
/// and down. Edges along an axis fit two.
unsigned quadrants(Vec2d a, Vec2d b) {
  const unsigned right = b.x >= a.x ? 0b0101U : 0U, left = b.x <= a.x ? 0b1010U : 0U;
  const unsigned up = b.y >= a.y ? 0b0011U : 0U, down = b.y <= a.y ? 0b1100U : 0U;
  return (right | left) & (up | down);
}

std::uint64_t spread(std::uint32_t bits) {
  std::uint64_t x = bits;
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  return (x | x << 1) & 0x5555555555555555;
}

/// Rings that lie near each other stand near each other: by the Morton code of their first points.
std::vector<std::uint32_t> ring_order(const Outline& outline) {
  std::vector<std::uint32_t> order(outline.ring_count());
  std::iota(order.begin(), order.end(), 0U);
  if (order.size() <= 2) return order;
  Vec2d low = outline.points[0], high = low;
  for (const std::uint32_t ring : order) {
    const Vec2d p = outline.points[outline.starts[ring]];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto cells = [](double length) { return length > 0 ? 65535 / length : 0; };
  const double scale_x = cells(high.x - low.x), scale_y = cells(high.y - low.y);
  std::vector<std::uint64_t> keys;
  keys.reserve(order.size());
  for (const std::uint32_t ring : order) {
    const Vec2d p = outline.points[outline.starts[ring]];
    const std::uint64_t x = spread(static_cast<std::uint32_t>((p.x - low.x) * scale_x)),
                        y = spread(static_cast<std::uint32_t>((p.y - low.y) * scale_y));
    keys.push_back((x | y << 1) << 32 | ring);
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<std::uint32_t>(keys[i]);
  return order;
}

}  // namespace

BoxTree::BoxTree(const Outline& outline) {
  const Vec2d* const p = outline.points.data();
  runs_.reserve(outline.points.size() / 4);
  for (const std::uint32_t ring : ring_order(outline)) {
    const std::uint32_t end = outline.starts[ring + 1] - 1;
    unsigned fits = 0;
    for (std::uint32_t first = outline.starts[ring]; first < end;) {
      const unsigned before = fits;
      std::uint32_t last = first;
      fits = 0b1111;
      const std::uint32_t limit = std::min(end, first + longest_run);
      for (; last < limit; ++last) {
        const unsigned edge = quadrants(p[last], p[last + 1]);
        if ((fits & edge) == 0) break;
        fits &= edge;
      }
      runs_.push_back({first, last, ring, (before & fits) != 0});
      first = last;
    }
  }

  const std::size_t count = runs_.size();
  boxes_.reserve(2 * count + 40);
  for (const Run& run : runs_) boxes_.push_back(box_of(p[run.first], p[run.last]));
  level_start_ = {0, static_cast<std::uint32_t>(count)};
  for (std::size_t begin = 0, end = count; end - begin > 1;) {
    for (std::size_t i = begin; i < end; i += 2) {
      const Box a = boxes_[i], b = i + 1 < end ? boxes_[i + 1] : a;
      boxes_.push_back({{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
                        {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}});
    }
    begin = end;
    end = boxes_.size();
    level_start_.push_back(static_cast<std::uint32_t>(end));
  }
}

double BoxTree::expected_pairs() const {
  if (runs_.empty()) return 0;
  double width = 0, height = 0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    width += boxes_[i].high.x - boxes_[i].low.x;
    height += boxes_[i].high.y - boxes_[i].low.y;
  }
  const auto share = [](double length, double all) { return all > 0 ? std::min(1.0, length / all) : 1.0; };
  const auto count = static_cast<double>(runs_.size());
  // Two boxes of sizes w, h meet where their corners differ by less than that both ways.
  return 0.5 * count * count * share(2 * width / count, whole().high.x - whole().low.x) *
         share(2 * height / count, whole().high.y - whole().low.y);
}

}  // namespace lambert::polygon::arrangement
