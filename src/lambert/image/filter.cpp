#include "lambert/image/filter.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lambert {
namespace {

constexpr std::size_t bins = 256;

struct KindInfo {
  std::string_view name;
  FilterKind kind;
  float radius;
};
constexpr std::array<KindInfo, 6> kinds{{
    {"box", FilterKind::box, 0.5f},
    {"triangle", FilterKind::triangle, 1},
    {"gaussian", FilterKind::gaussian, 1.5f},
    {"mitchell", FilterKind::mitchell, 2},
    {"lanczos", FilterKind::lanczos, 3},
    {"blackman-harris", FilterKind::blackman_harris, 1.5f},
}};

float gaussian(float x, float sigma) { return std::exp(-x * x / (2 * sigma * sigma)); }

/// Mitchell and Netravali 1988, for |x| in [0,2].
float mitchell(float x, float b, float c) {
  x = std::abs(x);
  if (x > 2) return 0;
  if (x > 1)
    return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) / 6;
  return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
}

float sinc(float x) { return std::abs(x) < 1e-5f ? 1 : std::sin(pi * x) / (pi * x); }

/// The four-term window, its peak 1 (Harris 1978).
float blackman_harris(float x, float radius) {
  const float t = 2 * pi * (x / (2 * radius) + 0.5f);
  return 0.35875f - 0.48829f * std::cos(t) + 0.14128f * std::cos(2 * t) - 0.01168f * std::cos(3 * t);
}

/// One axis, not normalised; 0 beyond the radius.
float axis_value(const FilterSettings& s, float x, float radius) {
  if (std::abs(x) > radius) return 0;
  switch (s.kind) {
    case FilterKind::box: return 1;
    case FilterKind::triangle: return std::max(0.0f, radius - std::abs(x));
    case FilterKind::gaussian: return std::max(0.0f, gaussian(x, s.sigma) - gaussian(radius, s.sigma));
    case FilterKind::mitchell: return mitchell(2 * x / radius, s.b, s.c);
    case FilterKind::lanczos: return sinc(x) * sinc(x / radius);
    case FilterKind::blackman_harris: return std::max(0.0f, blackman_harris(x, radius));
  }
  return 0;
}

float default_radius(FilterKind kind) {
  return std::find_if(kinds.begin(), kinds.end(), [&](const KindInfo& k) { return k.kind == kind; })->radius;
}

}  // namespace

FilterKind filter_kind(std::string_view name) {
  for (const KindInfo& k : kinds)
    if (k.name == name) return k.kind;
  throw Error("unknown filter " + unknown_word(name, filter_names()));
}

std::vector<std::string> filter_names() {
  std::vector<std::string> names;
  for (const KindInfo& k : kinds) names.emplace_back(k.name);
  return names;
}

FilterSampler::FilterSampler(const FilterSettings& settings) : settings_(settings) {
  const float standard = default_radius(settings.kind);
  radius_ = {settings.radius.x > 0 ? settings.radius.x : standard,
             settings.radius.y > 0 ? settings.radius.y : standard};
  if (!std::isfinite(radius_.x) || !std::isfinite(radius_.y) || !(settings.sigma > 0))
    throw Error("a filter's radius and sigma must be positive and finite");
  // Bin values are the filter at bin centres: the tabulated filter is what is sampled, its weights exact for it.
  const auto tabulate = [&](Axis& axis, float radius) {
    axis.radius = radius;
    axis.cdf.push_back(0);
    double absolute = 0, plain = 0;
    for (std::size_t i = 0; i < bins; ++i) {
      const float x = ((static_cast<float>(i) + 0.5f) / bins * 2 - 1) * radius;
      axis.value.push_back(axis_value(settings_, x, radius));
      absolute += std::abs(static_cast<double>(axis.value.back()));
      plain += static_cast<double>(axis.value.back());
      axis.cdf.push_back(static_cast<float>(absolute));
    }
    for (float& c : axis.cdf) c = static_cast<float>(static_cast<double>(c) / absolute);
    axis.cdf.back() = 1;
    const double width = 2 * static_cast<double>(radius) / bins;
    scale_ = static_cast<float>(static_cast<double>(scale_) / (plain * width));
    weight_ = static_cast<float>(static_cast<double>(weight_) * absolute / plain);
  };
  tabulate(x_, radius_.x);
  tabulate(y_, radius_.y);
}

FilterSampler::Sample FilterSampler::sample(Vec2 u) const {
  if (settings_.kind == FilterKind::box) return {(2.0f * u - 1.0f) * radius_, 1};
  const auto draw = [](const Axis& axis, float v, float& sign) {
    const auto above = std::upper_bound(axis.cdf.begin() + 1, axis.cdf.end() - 1, v);
    const auto bin = static_cast<std::size_t>(above - axis.cdf.begin()) - 1;
    const float share = axis.cdf[bin + 1] - axis.cdf[bin];
    const float within = share > 0 ? (v - axis.cdf[bin]) / share : 0.5f;
    if (axis.value[bin] < 0) sign = -sign;
    return ((static_cast<float>(bin) + within) / bins * 2 - 1) * axis.radius;
  };
  float sign = 1;
  const float x = draw(x_, u.x, sign), y = draw(y_, u.y, sign);
  return {{x, y}, sign * weight_};
}

float FilterSampler::eval(Vec2 offset) const {
  return scale_ * axis_value(settings_, offset.x, radius_.x) * axis_value(settings_, offset.y, radius_.y);
}

}  // namespace lambert
