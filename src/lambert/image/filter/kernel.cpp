#include "lambert/image/filter/kernel.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lambert {
namespace {

struct KindInfo {
  std::string_view name;
  FilterKind kind;
  float radius;
};
constexpr std::array<KindInfo, 7> kinds{{
    {"box", FilterKind::box, 0.5f},
    {"triangle", FilterKind::triangle, 1},
    {"gaussian", FilterKind::gaussian, 1.5f},
    {"mitchell", FilterKind::mitchell, 2},
    {"catmull-rom", FilterKind::catmull_rom, 2},
    {"lanczos", FilterKind::lanczos, 3},
    {"blackman-harris", FilterKind::blackman_harris, 1.5f},
}};

constexpr double full_pi = std::numbers::pi;

double sinc(double x) { return std::abs(x) < 1e-8 ? 1 : std::sin(full_pi * x) / (full_pi * x); }

}  // namespace

double box_kernel(double x, double radius) { return std::abs(x) <= radius ? 1 : 0; }

double triangle_kernel(double x, double radius) { return std::max(0.0, 1 - std::abs(x) / radius); }

double gaussian_kernel(double x, double sigma) { return std::exp(-x * x / (2 * sigma * sigma)); }

double cubic_kernel(double x, double b, double c) {
  x = std::abs(x);
  if (x >= 2) return 0;
  if (x > 1)
    return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) / 6;
  return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
}

double lanczos_kernel(double x, double lobes) { return std::abs(x) < lobes ? sinc(x) * sinc(x / lobes) : 0; }

double blackman_harris_kernel(double x, double radius) {
  if (std::abs(x) >= radius) return 0;
  const double t = full_pi * (x / radius + 1);
  return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
}

FilterKind filter_kind(std::string_view name) {
  if (name == "bartlett") return FilterKind::triangle;
  for (const KindInfo& k : kinds)
    if (k.name == name) return k.kind;
  throw Error("unknown filter " + unknown_word(name, filter_names()));
}

std::vector<std::string> filter_names() {
  std::vector<std::string> names;
  for (const KindInfo& k : kinds) names.emplace_back(k.name);
  return names;
}

Kernel::Kernel(const FilterSettings& settings, Axis axis) : settings_(settings) {
  const float asked = axis == Axis::x ? settings.radius.x : settings.radius.y;
  const auto info =
      std::find_if(kinds.begin(), kinds.end(), [&](const KindInfo& k) { return k.kind == settings.kind; });
  radius_ = static_cast<double>(asked > 0 ? asked : info->radius);
  if (!std::isfinite(asked) || !(settings.sigma > 0) || !std::isfinite(settings.sigma))
    throw Error("a filter's radius and sigma must be positive and finite");
  if (settings.kind == FilterKind::gaussian && !settings.truncated)
    pedestal_ = gaussian_kernel(radius_, static_cast<double>(settings.sigma));
}

double Kernel::operator()(double x) const {
  if (std::abs(x) > radius_) return 0;
  switch (settings_.kind) {
    case FilterKind::box: return box_kernel(x, radius_);
    case FilterKind::triangle: return triangle_kernel(x, radius_);
    case FilterKind::gaussian:
      return std::max(0.0, gaussian_kernel(x, static_cast<double>(settings_.sigma)) - pedestal_);
    case FilterKind::mitchell:
      return cubic_kernel(2 * x / radius_, static_cast<double>(settings_.b), static_cast<double>(settings_.c));
    case FilterKind::catmull_rom: return cubic_kernel(2 * x / radius_, 0, 0.5);
    case FilterKind::lanczos: return lanczos_kernel(x, radius_);
    case FilterKind::blackman_harris: return blackman_harris_kernel(x, radius_);
  }
  return 0;
}

}  // namespace lambert
