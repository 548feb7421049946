#include "lambert/image/probe/spherical_harmonics.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/probe/linear_radiance.h"
#include "lambert/image/probe/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace lambert::probe {
namespace {

constexpr std::size_t most_coefficients = sh_count(highest_sh_order);

int order_of(std::size_t coefficients) {
  int order = 0;
  while (sh_count(order + 1) <= coefficients) ++order;
  return order;
}

/// K_lm = √((2l+1)/4π (l-m)!/(l+m)!), √2 of it for m > 0.
const std::array<double, most_coefficients>& factors() {
  static const auto table = [] {
    std::array<double, most_coefficients> k{};
    for (int l = 0; l <= highest_sh_order; ++l)
      for (int m = 0; m <= l; ++m) {
        double v = (2 * l + 1) / (4 * std::numbers::pi) * (m > 0 ? 2 : 1);
        for (int i = l - m + 1; i <= l + m; ++i) v /= i;
        k[static_cast<std::size_t>(l * l + l + m)] = std::sqrt(v);
      }
    return k;
  }();
  return table;
}

}  // namespace

/// P_mm / sin^m θ = (2m-1)!!, (l-m) P_lm = (2l-1) z P_l-1,m - (l+m-1) P_l-2,m; sin^m θ cos mφ and sin^m θ sin mφ are
/// the parts of (x + iy)^m.
void sh_basis(int order, Vec3 d, std::span<double> values) {
  const auto& k = factors();
  const double x = static_cast<double>(d.x), y = static_cast<double>(d.y), z = static_cast<double>(d.z);
  double cosine = 1, sine = 0, p_mm = 1;
  for (int m = 0; m <= order; ++m) {
    double before = 0, p = p_mm;
    for (int l = m; l <= order; ++l) {
      if (l > m) {
        const double next = ((2 * l - 1) * z * p - (l + m - 1) * before) / (l - m);
        before = p, p = next;
      }
      const auto middle = static_cast<std::size_t>(l * l + l), um = static_cast<std::size_t>(m);
      const double scaled = k[middle + um] * p;
      values[middle + um] = scaled * cosine;
      if (m > 0) values[middle - um] = scaled * sine;
    }
    p_mm *= 2 * m + 1;
    const double c = cosine * x - sine * y;
    sine = cosine * y + sine * x, cosine = c;
  }
}

namespace {

/// Adds up L Y_lm dω over texels.
class Projector {
 public:
  Projector(const Probe& probe, int order)
      : probe_(probe), order_(order), count_(sh_count(order)), disk_(has_disk(probe.projection)), sum_(count_) {}

  void add(const Texel& texel, double solid_angle) {
    const Rgb colour = probe_.charts[static_cast<std::size_t>(texel.chart)].rgb(texel.x, texel.y);
    const Cell cell = texel_cell(probe_, texel.x, texel.y);
    if (!add_narrow(texel.chart, cell, solid_angle, colour)) add_wide(texel, cell);
  }
  std::vector<ShColour> sum() && { return std::move(sum_); }

 private:
  struct Point {
    Vec3 direction;
    double weight;  // their sum is 1
  };

  /// Gauss' rule; none where a point lies out of the disk.
  std::optional<std::array<Point, 4>> gauss_points(int chart, const Cell& c) const {
    constexpr double gauss = 0.5 / std::numbers::sqrt3;
    std::array<Point, 4> points;
    double total = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const MapPoint at{chart, Vec2(std::lerp(c.u0, c.u1, 0.5 + ((k & 1) ? gauss : -gauss)),
                                    std::lerp(c.v0, c.v1, 0.5 + ((k & 2) ? gauss : -gauss)))};
      const auto d = direction(probe_.projection, at);
      if (!d) return std::nullopt;
      points[k] = {*d, static_cast<double>(density(probe_.projection, at))};
      total += points[k].weight;
    }
    if (!(total > 0)) return std::nullopt;
    for (Point& p : points) p.weight /= total;
    return points;
  }

  /// False for texels that one colour is not enough for, and for some at rims.
  bool add_narrow(int chart, const Cell& cell, double solid_angle, Rgb colour) {
    // The mean of a basis function over a square of side s differs by l (l + 1) s² / 24 of it from the middle's.
    if (!disk_ && order_ * (order_ + 1) * solid_angle < 24e-5) {
      const MapPoint middle{chart, Vec2(Vec2d(cell.u0 + cell.u1, cell.v0 + cell.v1) * 0.5)};
      add(*direction(probe_.projection, middle), solid_angle, colour);
      return true;
    }
    const auto points = gauss_points(chart, cell);
    if (!points) return false;
    const auto apart = [&](std::size_t i, std::size_t k) {
      return length((*points)[i].direction - (*points)[k].direction);
    };
    // Corners are √3 times as far apart.
    if (0.5f * std::numbers::sqrt3_v<float> * std::max(apart(0, 3), apart(1, 2)) > widest_part) return false;
    for (const Point& p : *points) add(p.direction, solid_angle * p.weight, colour);
    return true;
  }

  void add_wide(const Texel& texel, const Cell& cell) {
    const LinearRadiance radiance = linear_radiance(probe_, texel);
    for_each_part(probe_.projection, texel.chart, cell, [&](const Cell& part, const CellIntegrals& i) {
      const auto points = disk_ ? std::nullopt : gauss_points(texel.chart, part);
      if (!points) return add(Vec3(normalize(i.moment)), i.solid_angle, radiance(i.moment / i.solid_angle));
      for (const Point& p : *points) add(p.direction, i.solid_angle * p.weight, radiance(Vec3d(p.direction)));
    });
  }

  void add(Vec3 d, double solid_angle, Rgb colour) {
    sh_basis(order_, d, basis_);
    const double r = solid_angle * static_cast<double>(colour.r), g = solid_angle * static_cast<double>(colour.g),
                 b = solid_angle * static_cast<double>(colour.b);
    for (std::size_t j = 0; j < count_; ++j)
      sum_[j].r += r * basis_[j], sum_[j].g += g * basis_[j], sum_[j].b += b * basis_[j];
  }

  const Probe& probe_;
  int order_;
  std::size_t count_;
  bool disk_;
  std::array<double, most_coefficients> basis_;
  std::vector<ShColour> sum_;
};

}  // namespace

std::vector<ShColour> sh_project(const Probe& probe, int order) {
  if (order < 0 || order > highest_sh_order)
    throw Error("spherical harmonics: the order must be from 0 to " + std::to_string(highest_sh_order));
  const TexelMeasure measure = texel_measure(probe);
  const auto width = static_cast<std::size_t>(probe.width()), height = static_cast<std::size_t>(probe.height());
  // Sums of rows, added up in their order: the same for any number of threads.
  std::vector<std::vector<ShColour>> rows(probe.charts.size() * height);
  parallel_for(rows.size(), [&](std::size_t i) {
    const std::size_t chart = i / height, y = i % height;
    Projector projector(probe, order);
    for (std::size_t x = 0; x < width; ++x)
      projector.add({static_cast<int>(chart), static_cast<int>(x), static_cast<int>(y)},
                    static_cast<double>(measure.solid_angle[y * width + x]));
    rows[i] = std::move(projector).sum();
  });
  std::vector<ShColour> total(sh_count(order));
  for (const auto& row : rows)
    for (std::size_t j = 0; j < total.size(); ++j)
      total[j].r += row[j].r, total[j].g += row[j].g, total[j].b += row[j].b;
  return total;
}

Rgb sh_radiance(std::span<const ShColour> coefficients, Vec3 d) {
  std::array<double, most_coefficients> basis;
  sh_basis(order_of(coefficients.size()), d, basis);
  ShColour sum;
  for (std::size_t j = 0; j < coefficients.size(); ++j)
    sum.r += basis[j] * coefficients[j].r, sum.g += basis[j] * coefficients[j].g, sum.b += basis[j] * coefficients[j].b;
  return {static_cast<float>(sum.r), static_cast<float>(sum.g), static_cast<float>(sum.b)};
}

/// A_l = 2π (-1)^(l/2-1) / ((l+2)(l-1)) · l! / (2^l (l/2)!²) for even l.
double cosine_lobe(int l) {
  if (l == 1) return 2 * std::numbers::pi / 3;
  if (l % 2 != 0) return 0;
  if (l == 0) return std::numbers::pi;
  double ratio = 1;
  for (int i = 1; i <= l / 2; ++i) ratio *= (l / 2.0 + i) / (4.0 * i);
  return 2 * std::numbers::pi * (l / 2 % 2 == 0 ? -1 : 1) / ((l + 2.0) * (l - 1.0)) * ratio;
}

std::vector<ShColour> sh_irradiance(std::span<const ShColour> radiance) {
  std::vector<ShColour> result;
  for (int l = 0; sh_count(l) <= radiance.size(); ++l)
    for (std::size_t j = sh_count(l - 1); j < sh_count(l); ++j) {
      const double a = cosine_lobe(l);
      result.push_back({a * radiance[j].r, a * radiance[j].g, a * radiance[j].b});
    }
  return result;
}

Probe sh_map(std::span<const ShColour> coefficients, const AnyProjection& projection, TexelRule texels, int rows) {
  const Vec2i size = chart_size(projection, rows);
  Probe result{projection, texels, {}};
  for (int i = 0; i < chart_count(projection); ++i) result.charts.emplace_back(size.x, size.y, rgb_channels());
  for (int i = 0; i < chart_count(projection); ++i) {
    Image& chart = result.charts[static_cast<std::size_t>(i)];
    parallel_for(static_cast<std::size_t>(size.y), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < size.x; ++x)
        if (const auto d = direction(projection, {i, uv_of(result, Vec2(x, y) + 0.5f)}))
          chart.set_rgb(x, y, sh_radiance(coefficients, *d));
    });
  }
  return result;
}

}  // namespace lambert::probe
