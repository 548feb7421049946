#include "lambert/image/tonemap/luminance_map.h"

#include "lambert/image/tonemap/fast_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lambert::tone {
namespace {

bool counts(float luminance) { return luminance >= least_luminance && luminance < infinite_radiance; }

/// Sums in eight lanes: the order of adding is fixed, and the loop runs in vector registers.
struct Lanes {
  static constexpr std::size_t count = 8;
  std::array<float, count> counted{}, log2{}, sum{}, r{}, g{}, b{}, largest{}, smallest{};
};

double total(const std::array<float, Lanes::count>& lanes) {
  double sum = 0;
  for (const float v : lanes) sum += static_cast<double>(v);
  return sum;
}

}  // namespace

LuminanceStatistics LuminanceStatistics::scaled(float factor) const {
  return {.log_average = log_average * factor,
          .average = average * factor,
          .smallest = smallest * factor,
          .largest = largest * factor,
          .average_colour = average_colour * factor};
}

float LuminanceMap::percentile(float percent) const {
  std::vector<float> sorted;
  sorted.reserve(luminance.values.size());
  std::copy_if(luminance.values.begin(), luminance.values.end(), std::back_inserter(sorted), counts);
  if (sorted.empty()) return 1;
  const double share = std::clamp(static_cast<double>(percent), 0.0, 100.0) / 100.0;
  // Whole numbers that rounding lifted are still whole.
  const double rank = std::ceil(share * static_cast<double>(sorted.size()) * (1 - 1e-6));
  const auto nth = static_cast<std::ptrdiff_t>(std::max(0.0, rank - 1));
  std::nth_element(sorted.begin(), sorted.begin() + nth, sorted.end());
  return sorted[static_cast<std::size_t>(nth)];
}

void StatisticsSum::add_row(const float* r, const float* g, const float* b, const float* luminance, std::size_t count) {
  Lanes lanes;
  lanes.smallest.fill(infinite_radiance);
  const auto add = [&](std::size_t lane, std::size_t x) {
    const float l = luminance[x];
    const bool in = (l >= least_luminance) & (l < infinite_radiance);
    const float one = chosen(in, 1.0f, 0.0f);
    lanes.counted[lane] += one;
    lanes.log2[lane] += fast_log2(chosen(in, l, 1.0f));
    lanes.sum[lane] += one * l;
    lanes.r[lane] += one * r[x];
    lanes.g[lane] += one * g[x];
    lanes.b[lane] += one * b[x];
    const float high = one * l, low = chosen(in, l, infinite_radiance);
    lanes.largest[lane] = lanes.largest[lane] > high ? lanes.largest[lane] : high;
    lanes.smallest[lane] = lanes.smallest[lane] < low ? lanes.smallest[lane] : low;
  };
  std::size_t x = 0;
  for (; x + Lanes::count <= count; x += Lanes::count)
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) add(lane, x + lane);
  for (; x < count; ++x) add(0, x);
  counted_ += total(lanes.counted);
  log2_ += total(lanes.log2);
  sum_ += total(lanes.sum);
  r_ += total(lanes.r);
  g_ += total(lanes.g);
  b_ += total(lanes.b);
  largest_ = std::max(largest_, *std::max_element(lanes.largest.begin(), lanes.largest.end()));
  smallest_ = std::min(smallest_, *std::min_element(lanes.smallest.begin(), lanes.smallest.end()));
}

void StatisticsSum::add(const StatisticsSum& o) {
  counted_ += o.counted_, log2_ += o.log2_, sum_ += o.sum_, r_ += o.r_, g_ += o.g_, b_ += o.b_;
  smallest_ = std::min(smallest_, o.smallest_), largest_ = std::max(largest_, o.largest_);
}

LuminanceStatistics StatisticsSum::statistics() const {
  if (counted_ == 0) return {};
  const auto mean = [&](double sum) { return static_cast<float>(sum / counted_); };
  return {.log_average = static_cast<float>(std::exp2(log2_ / counted_)),
          .average = mean(sum_),
          .smallest = smallest_,
          .largest = largest_,
          .average_colour = {mean(r_), mean(g_), mean(b_)}};
}

}  // namespace lambert::tone
