#include "lambert/draw/axis_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lambert::draw {

double round_step(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0})
    if (power * factor <= wanted * 1.4) step = power * factor;
  return step;
}

std::string tick_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value + 0.0);  // + 0.0: no "-0"
  return text;
}

AxisScale::AxisScale(const Axis& axis, const std::vector<double>& values, double begin, double end)
    : logarithmic_(axis.logarithmic), low_(INFINITY), high_(-INFINITY), begin_(begin), end_(end) {
  for (const double value : values) {
    const double p = position(value);
    if (!std::isfinite(p)) continue;
    low_ = std::min(low_, p);
    high_ = std::max(high_, p);
  }
  if (low_ > high_) low_ = 0, high_ = 1;
  const double room = 0.04 * (high_ - low_);
  low_ -= room, high_ += room;
  if (!(high_ > low_)) {
    const double reach = logarithmic_ ? 0.5 : std::max(0.5, 0.05 * std::abs(low_));
    low_ -= reach, high_ += reach;
  }
  if (axis.low && std::isfinite(position(*axis.low))) low_ = position(*axis.low);
  if (axis.high && std::isfinite(position(*axis.high))) high_ = position(*axis.high);
  if (!(high_ > low_)) high_ = low_ + 1;
}

double AxisScale::position(double value) const { return logarithmic_ ? std::log10(value) : value; }

double AxisScale::pixel(double value) const {
  return begin_ + (position(value) - low_) / (high_ - low_) * (end_ - begin_);
}

AxisScale::Ticks AxisScale::ticks(double spacing) const {
  if (logarithmic_) return decades(spacing);
  Ticks found;
  const double step = round_step((high_ - low_) * spacing / std::abs(end_ - begin_));
  const double first = std::ceil(low_ / step - 1e-9), last = std::floor(high_ / step + 1e-9);
  if (!(last - first < 1000)) return found;
  for (double k = first; k <= last; ++k) found.emplace_back(pixel(k * step), tick_text(k * step));
  return found;
}

AxisScale::Ticks AxisScale::decades(double spacing) const {
  Ticks found;
  const double per_decade = std::abs(end_ - begin_) / (high_ - low_);
  const double every = std::max(1.0, std::ceil(spacing / per_decade));
  // Where a decade has room for them, 2 and 5 are written as well.
  const bool between = per_decade > 3 * spacing;
  for (double d = std::floor(low_); d <= std::ceil(high_) && high_ - low_ < 700; ++d)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, d), p = std::log10(value);
      if (p < low_ - 1e-9 || p > high_ + 1e-9 || (digit > 1 && every > 1)) continue;
      const bool written = digit == 1 ? std::fmod(d, every) == 0 : between && (digit == 2 || digit == 5);
      found.emplace_back(pixel(value), written ? tick_text(value) : std::string());
    }
  return found;
}

}  // namespace lambert::draw
