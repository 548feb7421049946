#include "lambert/image/composite/elements.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::composite {
namespace {

struct Point {
  double x, y;
};

Window box_of(const std::vector<Point>& points) {
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
  for (const Point& p : points)
    x0 = std::min(x0, p.x), y0 = std::min(y0, p.y), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
  const auto floor = [](double v) { return static_cast<int>(std::floor(v)); };
  return {floor(x0), floor(y0), floor(std::ceil(x1)) - floor(x0), floor(std::ceil(y1)) - floor(y0)};
}

/// A part of an edge within one row of pixels: `height` (with the edge's sign) from x0 to x1. Adds the area that lies
/// right of it in each column as differences along the row: `row[i]` is what pixel i has more than pixel i - 1.
void add_piece(std::vector<double>& row, double height, double x0, double x1) {
  if (x0 > x1) std::swap(x0, x1);
  const double last = static_cast<double>(row.size() - 2);
  if (x0 >= last) return;  // right of all that is asked for
  if (x1 <= 0) {
    row[0] += height;
    return;
  }
  const double width = x1 - x0;
  if (x0 < 0) {
    add_piece(row, height * (0 - x0) / width, 0, 0);
    return add_piece(row, height * x1 / width, 0, x1);
  }
  if (x1 > last) return add_piece(row, height * (last - x0) / width, x0, last);
  // Cut at the columns; a piece between columns i and i + 1 of height h and middle m covers i + 1 - m of pixel i.
  for (double x = x0;;) {
    const double column = std::floor(x), end = std::min(column + 1, x1);
    const double h = width > 0 ? height * (end - x) / width : height, m = 0.5 * (x + end) - column;
    const auto i = static_cast<std::size_t>(column);
    row[i] += h * (1 - m);
    row[i + 1] += h * m;
    if (end >= x1) return;
    x = end;
  }
}

void add_edge(std::vector<double>& row, Point a, Point b, double y) {
  const double sign = a.y < b.y ? 1 : -1;
  if (a.y > b.y) std::swap(a, b);
  const double top = std::max(a.y, y), bottom = std::min(b.y, y + 1);
  if (!(top < bottom)) return;
  const double slope = (b.x - a.x) / (b.y - a.y);
  add_piece(row, sign * (bottom - top), a.x + (top - a.y) * slope, a.x + (bottom - a.y) * slope);
}

class PolygonElement final : public Element {
 public:
  explicit PolygonElement(std::vector<Point> points) : Element({}), points_(std::move(points)) {
    shape_.data = box_of(points_);
  }
  Band pull(const Window& region, BandPool& pool) override {
    Band band = pool.take(region, shape_.channels.size());
    const Window inside = covered(shape_, region);
    std::vector<double> steps;
    for (int y = inside.y; y < inside.y + inside.height; ++y) {
      steps.assign(static_cast<std::size_t>(inside.width) + 2, 0.0);
      for (std::size_t i = 0; i < points_.size(); ++i) {
        Point a = points_[i], b = points_[i + 1 < points_.size() ? i + 1 : 0];
        a.x -= inside.x, b.x -= inside.x;
        add_edge(steps, a, b, y);
      }
      double sum = 0;
      for (int x = inside.x; x < inside.x + inside.width; ++x) {
        sum += steps[static_cast<std::size_t>(x - inside.x)];
        const auto value = static_cast<float>(std::min(std::abs(sum), 1.0));
        for (std::size_t c = 0; c < first_extra; ++c) band.row(c, y)[static_cast<std::size_t>(x - region.x)] = value;
      }
    }
    clear_outside(shape_, band);
    return band;
  }

 private:
  std::vector<Point> points_;
};

}  // namespace

ElementPtr polygon_matte(const std::vector<float>& points) {
  std::vector<Point> all;
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    all.push_back({static_cast<double>(points[i]), static_cast<double>(points[i + 1])});
  return std::make_unique<PolygonElement>(std::move(all));
}

}  // namespace lambert::composite
