#include "lambert/image/filter/filter_sampler.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

constexpr std::size_t bins = 256;

}  // namespace

FilterSampler::FilterSampler(const FilterSettings& settings)
    : kind_(settings.kind),
      x_{Kernel(settings, Kernel::Axis::x), {}, {}},
      y_{Kernel(settings, Kernel::Axis::y), {}, {}} {
  // Bin values are the filter at bin centres: the tabulated filter is what is sampled, its weights exact for it.
  const auto tabulate = [&](Axis& axis) {
    axis.radius = static_cast<float>(axis.kernel.radius());
    axis.cdf.push_back(0);
    double absolute = 0, plain = 0;
    for (std::size_t i = 0; i < bins; ++i) {
      const double v = axis.kernel(((static_cast<double>(i) + 0.5) / bins * 2 - 1) * axis.kernel.radius());
      axis.value.push_back(static_cast<float>(v));
      absolute += std::abs(v);
      plain += v;
      axis.cdf.push_back(static_cast<float>(absolute));
    }
    for (float& c : axis.cdf) c = static_cast<float>(static_cast<double>(c) / absolute);
    axis.cdf.back() = 1;
    const double width = 2 * axis.kernel.radius() / bins;
    scale_ = static_cast<float>(static_cast<double>(scale_) / (plain * width));
    weight_ = static_cast<float>(static_cast<double>(weight_) * absolute / plain);
  };
  tabulate(x_);
  tabulate(y_);
  radius_ = {x_.radius, y_.radius};
}

FilterSampler::Sample FilterSampler::sample(Vec2 u) const {
  if (kind_ == FilterKind::box) return {(2.0f * u - 1.0f) * radius_, 1};
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
  return scale_ *
         static_cast<float>(x_.kernel(static_cast<double>(offset.x)) * y_.kernel(static_cast<double>(offset.y)));
}

}  // namespace lambert
