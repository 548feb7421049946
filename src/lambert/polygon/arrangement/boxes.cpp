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

/// Whether two edges in succession, a to b and b to c, let the monotone parts around b meet in b alone: when both go
/// the same way in x, the one before lies left of b and the one after right of it, or the other way round, and on the
/// vertical through b there is no more of one of them; or so in y.
bool parts_at(Vec2d a, Vec2d b, Vec2d c, unsigned before, unsigned after) {
  const bool right = (before & 0b0101U) != 0 && (after & 0b0101U) != 0,
             left = (before & 0b1010U) != 0 && (after & 0b1010U) != 0;
  const bool up = (before & 0b0011U) != 0 && (after & 0b0011U) != 0,
             down = (before & 0b1100U) != 0 && (after & 0b1100U) != 0;
  return ((right || left) && (a.x != b.x || b.x != c.x)) || ((up || down) && (a.y != b.y || b.y != c.y));
}

}  // namespace

BoxTree::BoxTree(const Outline& outline) {
  const Vec2d* const p = outline.points.data();
  std::vector<std::uint8_t> fitting(outline.points.size());
  for (std::size_t i = 0; i + 1 < fitting.size(); ++i)
    fitting[i] = static_cast<std::uint8_t>(quadrants(p[i], p[i + 1]));
  runs_.reserve(outline.points.size() / 2);
  for (const std::uint32_t ring : ring_order(outline)) {
    const std::uint32_t begin = outline.starts[ring], end = outline.starts[ring + 1] - 1;
    unsigned before = 0;
    for (std::uint32_t first = begin; first < end;) {
      unsigned fits = fitting[first];
      std::uint32_t last = first + 1;
      for (const std::uint32_t limit = std::min(end, first + longest_run); last < limit; ++last) {
        const unsigned common = fits & fitting[last];
        if (common == 0) break;
        fits = common;
      }
      runs_.push_back(
          {first, last, ring, first > begin && parts_at(p[first - 1], p[first], p[first + 1], before, fits)});
      before = fits;
      first = last;
    }
  }

  std::size_t count = runs_.size();
  std::vector<FourBoxes>& leaves = levels_.emplace_back((count + 3) / 4);
  for (std::size_t i = 0; i < count; ++i)
    leaves[i / 4].set(static_cast<std::uint32_t>(i % 4), box_of(p[runs_[i].first], p[runs_[i].last]));
  while (levels_.back().size() > 1) {
    count = levels_.back().size();
    std::vector<FourBoxes> parents((count + 3) / 4);
    for (std::size_t i = 0; i < count; ++i)
      parents[i / 4].set(static_cast<std::uint32_t>(i % 4), levels_.back()[i].hull());
    levels_.push_back(std::move(parents));
  }
  whole_ = levels_.back().front().hull();
}

Box FourBoxes::hull() const {
  const auto least = [](const double(&x)[4]) { return std::min(std::min(x[0], x[1]), std::min(x[2], x[3])); };
  const auto most = [](const double(&x)[4]) { return std::max(std::max(x[0], x[1]), std::max(x[2], x[3])); };
  return {{least(low_x), least(low_y)}, {most(high_x), most(high_y)}};
}

bool BoxTree::find_pairs(std::size_t most, std::vector<Pair>& pairs) const {
  struct Meeting {
    std::uint32_t level, i, j;  // nodes whose boxes meet
  };
  std::vector<Meeting> stack;
  std::size_t compared = 0;
  const auto add = [&](std::uint32_t level, std::uint32_t i, std::uint32_t j) {
    if (level > 0) {
      stack.push_back({level, i, j});
    } else if (j != i + 1 || !runs_[j].apart) {
      pairs.push_back({i, j});
    }
  };
  for (std::uint32_t level = 0; level < levels_.size(); ++level) {
    for (std::uint32_t four = 0; four < levels_[level].size(); ++four) {
      const FourBoxes& siblings = levels_[level][four];
      for (std::uint32_t a = 0; a < 3; ++a) {
        for (unsigned hit = siblings.meeting(siblings.box(a)) >> (a + 1) << (a + 1); hit != 0; hit &= hit - 1)
          add(level, 4 * four + a, 4 * four + static_cast<std::uint32_t>(std::countr_zero(hit)));
      }
      while (!stack.empty()) {
        const Meeting m = stack.back();
        stack.pop_back();
        const FourBoxes &left = levels_[m.level - 1][m.i], &right = levels_[m.level - 1][m.j];
        compared += 4;
        for (std::uint32_t a = 0; a < 4; ++a) {
          for (unsigned hit = right.meeting(left.box(a)); hit != 0; hit &= hit - 1)
            add(m.level - 1, 4 * m.i + a, 4 * m.j + static_cast<std::uint32_t>(std::countr_zero(hit)));
        }
      }
      if (pairs.size() > most || compared > 4 * most) return false;
    }
  }
  return true;
}

double BoxTree::expected_pairs() const {
  double width = 0, height = 0;
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    const Box b = box(i);
    width += b.high.x - b.low.x;
    height += b.high.y - b.low.y;
  }
  const auto share = [](double length, double all) { return all > 0 ? std::min(1.0, length / all) : 1.0; };
  const auto count = static_cast<double>(runs_.size());
  // Two boxes of sizes w, h meet where their corners differ by less than that both ways.
  return 0.5 * count * count * share(2 * width / count, whole_.high.x - whole_.low.x) *
         share(2 * height / count, whole_.high.y - whole_.low.y);
}

}  // namespace lambert::polygon::arrangement
