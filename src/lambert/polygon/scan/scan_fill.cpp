#include "lambert/polygon/scan/scan_fill.h"

#include "lambert/polygon/predicates/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::polygon {
namespace {

/// The least whole number n in [least, most] with n + 1/2 >= v, or most. Exact.
int first_centre_from(double v, int least, int most) {
  const double whole = std::floor(v), n = v <= whole + 0.5 ? whole : whole + 1;
  if (!(n > least)) return least;
  return n < most ? static_cast<int>(n) : most;
}

}  // namespace

PixelWindow pixel_window(const Rings& rings) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  Vec2d min(infinity), max(-infinity);
  for (const Ring& ring : rings)
    for (const Vec2d p : ring) {
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
  if (!(min.x <= max.x)) return {};
  return {first_centre_from(min.x, least, most), first_centre_from(max.x, least, most),
          first_centre_from(min.y, least, most), first_centre_from(max.y, least, most)};
}

ScanRows::ScanRows(const Rings& rings, const PixelWindow& window) : window_(window) {
  if (window.x_begin >= window.x_end || window.y_begin >= window.y_end) return;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      if (a.y == b.y) continue;
      const bool up = a.y < b.y;
      const Vec2d low = up ? a : b, high = up ? b : a;
      const int first = first_centre_from(low.y, window.y_begin, window.y_end);
      const int last = first_centre_from(high.y, window.y_begin, window.y_end);
      if (first >= last) continue;
      const double slope = (high.x - low.x) / (high.y - low.y);
      // Slope, height above the low end, their product and the sum are each off by half a unit in the last place at
      // most; none of their values exceeds the edge's width, or its largest coordinate, by more than that.
      const double size = std::max(std::abs(low.x), std::abs(high.x));
      // Travelling up, an edge has the larger winding number on its left, towards -x.
      edges_.push_back({low, high, up ? -1 : 1, first, last - 1, slope, 0x1p-49 * size + 0x1p-1000});
    }
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.first_row < b.first_row; });
}

bool ScanRows::next() {
  crossings_.clear();
  std::erase_if(active_, [&](const Edge& edge) { return edge.last_row <= y_; });
  if (active_.empty()) {
    if (waiting_ == edges_.size()) return false;
    y_ = edges_[waiting_].first_row;
  } else {
    ++y_;
  }
  for (; waiting_ < edges_.size() && edges_[waiting_].first_row == y_; ++waiting_) active_.push_back(edges_[waiting_]);
  const double centre_y = y_ + 0.5;
  for (const Edge& edge : active_) crossings_.push_back({column(edge, centre_y), edge.winding});
  sort_crossings();
  return true;
}

/// By columns when there are many crossings for each: then those of one column become one, with the sum of their gains.
void ScanRows::sort_crossings() {
  const auto columns = static_cast<std::size_t>(static_cast<long>(window_.x_end) - window_.x_begin) + 1;
  if (columns > 4 * crossings_.size()) {
    std::sort(crossings_.begin(), crossings_.end(), [](RowCrossing a, RowCrossing b) { return a.x < b.x; });
    return;
  }
  gains_.assign(columns, 0);
  for (const RowCrossing crossing : crossings_)
    gains_[static_cast<std::size_t>(static_cast<long>(crossing.x) - window_.x_begin)] += crossing.winding;
  crossings_.clear();
  for (std::size_t i = 0; i < columns; ++i)
    if (gains_[i] != 0) crossings_.push_back({static_cast<int>(window_.x_begin + static_cast<long>(i)), gains_[i]});
}

/// The first column whose centre lies on the edge or towards +x of it.
int ScanRows::column(const Edge& edge, double centre_y) const {
  const double x = edge.low.x + (centre_y - edge.low.y) * edge.slope;
  const double from_centre = x - 0.5, next = std::ceil(from_centre);
  if (next - from_centre > edge.margin && from_centre - (next - 1) > edge.margin)
    return static_cast<int>(std::clamp<double>(next, window_.x_begin, window_.x_end));
  int low = window_.x_begin, high = window_.x_end;
  if (std::isfinite(x)) {
    low = first_centre_from(x - edge.margin, window_.x_begin, window_.x_end);
    high = first_centre_from(x + edge.margin, window_.x_begin, window_.x_end);
  }
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (orientation(edge.low, edge.high, {middle + 0.5, centre_y}) <= 0)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

}  // namespace lambert::polygon
