#include "lambert/polygon/point_locator.h"

#include "lambert/polygon/scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::polygon {
namespace {

constexpr double crossings_per_edge = 4, cells_per_edge = 2;
constexpr std::uint32_t crowded = 12;
constexpr int candidates = 8;

std::uint32_t at_most(double value, std::uint32_t limit) {
  return static_cast<std::uint32_t>(value > 0 ? std::min(value, static_cast<double>(limit)) : 0.0);
}

}  // namespace

PointLocator::PointLocator(const Rings& rings)
    : scale_(safe_scale(sizes_of(rings))), box_(box_of(rings)), edges_(rings, scale_) {
  box_.min *= scale_, box_.max *= scale_;

  choose_grid();
  list_edges();
  find_windings();
  divide_crowded_cells();
}

void PointLocator::choose_grid() {
  const Vec2d size = box_.size();
  const auto n = static_cast<double>(edges_.numbers.size());
  Vec2d length(0);
  for (const std::uint32_t e : edges_.numbers) length += glm::abs(edges_.points[e + 1] - edges_.points[e]);
  // Coordinates computed with the size of cells are off by less than this; cells must be far larger.
  slack_ = 0x1p-48 * (glm::abs(box_.min) + glm::abs(box_.max)) + 0x1p-1060;
  Vec2d counts(1);
  for (int axis = 0; axis < 2; ++axis)
    if (size[axis] > 0 && std::isfinite(length[axis]))
      counts[axis] =
          std::max(1.0, std::min(crossings_per_edge * n * size[axis] / length[axis], size[axis] / (64 * slack_[axis])));
  for (const int axis : {0, 1}) {
    const double too_many = counts.x * counts.y / (cells_per_edge * n);
    if (too_many > 1) counts[axis] = std::max(1.0, counts[axis] / (axis == 0 ? std::sqrt(too_many) : too_many));
  }
  columns_ = at_most(counts.x, 1 << 15), rows_ = at_most(counts.y, 1 << 15);
  columns_ = std::max(columns_, 1u), rows_ = std::max(rows_, 1u);
  cell_size_ = size / Vec2d(columns_, rows_);
  per_cell_ = {cell_size_.x > 0 ? 1 / cell_size_.x : 0, cell_size_.y > 0 ? 1 / cell_size_.y : 0};
}

std::uint32_t PointLocator::column(double x) const { return at_most((x - box_.min.x) * per_cell_.x, columns_ - 1); }
std::uint32_t PointLocator::row(double y) const { return at_most((y - box_.min.y) * per_cell_.y, rows_ - 1); }

/// Those the edge comes near within the row. column() and row() only grow with their argument, so that all points of
/// the edge fall between what its ends, moved apart by the slack, fall into.
PointLocator::Range PointLocator::columns_in_row(std::uint32_t edge, std::uint32_t r) const {
  Vec2d a = edges_.points[edge], b = edges_.points[edge + 1];
  if (a.y > b.y) std::swap(a, b);
  const double low = box_.min.y + r * cell_size_.y - slack_.y, high = low + cell_size_.y + 2 * slack_.y;
  const auto x_at = [&](double y) { return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x); };
  const double x0 = a.y < low ? x_at(low) : a.x, x1 = b.y > high ? x_at(high) : b.x;
  return {column(std::min(x0, x1) - slack_.x), column(std::max(x0, x1) + slack_.x)};
}

void PointLocator::list_edges() {
  const std::size_t count = static_cast<std::size_t>(columns_) * rows_;
  const auto for_each_cell = [&](auto&& use) {
    for (const std::uint32_t edge : edges_.numbers) {
      const auto [low, high] = std::minmax(edges_.points[edge].y, edges_.points[edge + 1].y);
      const std::uint32_t last_row = row(high + slack_.y);
      for (std::uint32_t r = row(low - slack_.y); r <= last_row; ++r) {
        const Range columns = columns_in_row(edge, r);
        for (std::uint32_t c = columns.first; c <= columns.last; ++c)
          use(static_cast<std::size_t>(r) * columns_ + c, edge);
      }
    }
  };
  cells_.assign(count, {0, 0, 0});
  for_each_cell([&](std::size_t cell, std::uint32_t) { ++cells_[cell].last; });
  std::uint32_t sum = 0;
  for (Cell& cell : cells_) sum += cell.last, cell.first = cell.last = sum;
  listed_.resize(sum);
  // Filled from the back of each cell, so that `first` ends where it should.
  for_each_cell([&](std::size_t cell, std::uint32_t edge) { listed_[--cells_[cell].first] = edge; });
}

/// Points of a cell, away from its sides; the first is its middle.
Vec2d PointLocator::candidate(std::uint32_t cell, int k) const {
  const Vec2d corner(cell % columns_, cell / columns_);
  const Vec2d within(0.5 + 0.11 * (k % 3) * (k % 2 ? 1 : -1), 0.5 + 0.07 * (k % 5) * (k % 4 < 2 ? 1 : -1));
  return box_.min + (corner + within) * cell_size_;
}

/// Along each row from outside the box, where the winding number is 0.
void PointLocator::find_windings() {
  references_.assign(cells_.size(), Vec2d(0));
  std::vector<std::uint32_t> near;
  for (std::uint32_t r = 0; r < rows_; ++r) {
    const std::uint32_t begin = r * columns_;
    std::uint32_t known = begin;
    int winding = 0;
    Vec2d reference(std::nextafter(box_.min.x - slack_.x, -std::numeric_limits<double>::infinity()),
                    candidate(begin, 0).y);
    for (std::uint32_t cell = begin; cell < begin + columns_; ++cell) {
      near.assign(listed_.begin() + cells_[known].first, listed_.begin() + cells_[cell].last);
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      cells_[cell].winding = unknown;
      for (int k = 0; k < candidates && cells_[cell].winding == unknown; ++k) {
        const Vec2d p = candidate(cell, k);
        const Winding w = edges_.winding_from(reference, winding, p, near);
        if (w.on) continue;
        cells_[cell].winding = winding = w.number;
        references_[cell] = reference = p;
        known = cell;
      }
    }
  }
}

void PointLocator::divide_crowded_cells() {
  for (std::uint32_t i = 0; i < cells_.size(); ++i) {
    Cell& cell = cells_[i];
    if (cell.last - cell.first < crowded || cell.winding == unknown) continue;
    const Vec2d low = box_.min + Vec2d(i % columns_, i / columns_) * cell_size_;
    const auto division =
        strips_.divide(edges_, {low, low + cell_size_}, slack_.x + slack_.y,
                       {listed_.data() + cell.first, listed_.data() + cell.last}, references_[i], cell.winding);
    if (division) cell = {*division, 0, divided};
  }
}

Winding PointLocator::winding_of_all(Vec2d p) const {
  const Vec2d outside(std::nextafter(box_.min.x, -std::numeric_limits<double>::infinity()), p.y);
  return edges_.winding_from(outside, 0, p, edges_.numbers);
}

Winding PointLocator::winding(Vec2d p) const {
  if (scale_ == 1) return winding_of_scaled(p);
  if (keeps(scale_, p)) return winding_of_scaled(scale_ * p);
  // Scaled, the point would be another one: the edges come to it.
  EdgeList edges = edges_;
  for (Vec2d& q : edges.points) q /= scale_;
  const Vec2d outside(std::nextafter(box().min.x, -std::numeric_limits<double>::infinity()), p.y);
  return box().contains(p) ? edges.winding_from(outside, 0, p, edges.numbers) : Winding{};
}

Winding PointLocator::winding_of_scaled(Vec2d p) const {
  if (!box_.contains(p)) return {};
  const std::size_t i = static_cast<std::size_t>(row(p.y)) * columns_ + column(p.x);
  const Cell& cell = cells_[i];
  if (cell.winding == divided) {
    const Winding w = strips_.winding(edges_, cell.first, p);
    return w.number == unknown ? winding_of_all(p) : w;
  }
  if (cell.winding == unknown) return winding_of_all(p);
  if (cell.first == cell.last) return {cell.winding, false};
  return edges_.winding_from(references_[i], cell.winding, p,
                             {listed_.data() + cell.first, listed_.data() + cell.last});
}

}  // namespace lambert::polygon
