#include "lambert/polygon/scan_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>

namespace lambert::polygon {
namespace {

void check_reach(double coordinate) {
  if (!(std::abs(coordinate) <= scan_table_reach)) throw std::out_of_range("scan_table: a coordinate is beyond 2^20");
}

long floor_divide(long a, long b) { return a / b - (a % b < 0 ? 1 : 0); }

/// An entry of the table: a crossing that holds just above its scan line, just below it, or a horizontal edge's end.
struct Entry {
  enum class Side : std::uint8_t { above, below, along };
  int y;
  Side side;
  int x, winding;
};

void add_edge(Vec2i a, Vec2i b, std::vector<Entry>& entries) {
  if (a.y == b.y) {
    entries.push_back({a.y, Entry::Side::along, std::min(a.x, b.x), 0});
    entries.push_back({a.y, Entry::Side::along, std::max(a.x, b.x), 0});
    return;
  }
  const int winding = a.y < b.y ? -1 : 1;
  const Vec2i low = a.y < b.y ? a : b, high = a.y < b.y ? b : a;
  EdgeDda dda(low, high);
  for (int y = low.y; y <= high.y; ++y, dda.step()) {
    if (y < high.y) entries.push_back({y, Entry::Side::above, dda.x(), winding});
    if (y > low.y) entries.push_back({y, Entry::Side::below, dda.x(), winding});
  }
}

/// The spans of one row from its entries, sorted by side and x.
template <class Rule>
void add_row(std::span<const Entry> row, const Rule& inside, std::vector<PixelSpan>& table) {
  std::vector<PixelSpan> pieces;
  int winding = 0, first = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].side == Entry::Side::along) {
      pieces.push_back({row[i].y, row[i].x, row[i + 1].x});
      ++i;
      continue;
    }
    const bool was_inside = inside(winding);
    winding += row[i].winding;
    if (!was_inside && inside(winding)) first = row[i].x;
    if (was_inside && !inside(winding)) pieces.push_back({row[i].y, first, row[i].x});
  }
  std::sort(pieces.begin(), pieces.end(), [](const PixelSpan& a, const PixelSpan& b) { return a.first < b.first; });
  const std::size_t begin = table.size();
  for (const PixelSpan& piece : pieces) {
    if (table.size() > begin && piece.first <= table.back().last + 1)
      table.back().last = std::max(table.back().last, piece.last);
    else
      table.push_back(piece);
  }
}

}  // namespace

EdgeDda::EdgeDda(Vec2i low, Vec2i high) : denominator_(2 * (static_cast<long>(high.y) - low.y)) {
  const long run = 2 * (static_cast<long>(high.x) - low.x), half = denominator_ / 2;
  step_ = floor_divide(run, denominator_);
  rest_ = run - step_ * denominator_;
  x_ = low.x;
  remainder_ = half;
}

void EdgeDda::step() {
  x_ += step_;
  remainder_ += rest_;
  if (remainder_ >= denominator_) {
    remainder_ -= denominator_;
    ++x_;
  }
}

std::vector<PixelSpan> scan_table(const std::vector<std::vector<Vec2i>>& rings, FillRule rule) {
  std::vector<Entry> entries;
  for (const auto& ring : rings)
    for (const Vec2i p : ring) check_reach(p.x), check_reach(p.y);
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) add_edge(ring[i], ring[next_index(i, ring.size())], entries);
  // Ends of horizontal edges stay in the order in which they were added, two by two.
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    if (a.y != b.y) return a.y < b.y;
    if (a.side != b.side) return a.side < b.side;
    return a.side != Entry::Side::along && a.x < b.x;
  });
  std::vector<PixelSpan> table;
  for (std::size_t first = 0, end = 0; first < entries.size(); first = end) {
    while (end < entries.size() && entries[end].y == entries[first].y) ++end;
    const std::span<const Entry> row(entries.data() + first, end - first);
    if (rule == FillRule::even_odd)
      add_row(
          row, [](int winding) { return winding % 2 != 0; }, table);
    else
      add_row(
          row, [](int winding) { return winding != 0; }, table);
  }
  return table;
}

std::vector<PixelSpan> scan_table(const Rings& rings, FillRule rule) {
  const auto nearest = [](double v) {
    check_reach(v);
    return static_cast<int>(std::floor(v + 0.5));
  };
  std::vector<std::vector<Vec2i>> whole;
  for (const Ring& ring : rings) {
    auto& vertices = whole.emplace_back();
    for (const Vec2d p : ring) vertices.emplace_back(nearest(p.x), nearest(p.y));
  }
  return scan_table(whole, rule);
}

}  // namespace lambert::polygon
