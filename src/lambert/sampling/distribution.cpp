#include "lambert/sampling/distribution.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>

namespace lambert {
namespace {

/// The sum, after checking every weight; 0 when all are 0.
double checked_sum(std::span<const float> weights) {
  if (weights.empty()) throw Error("a distribution needs at least one weight");
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(weights[i]) || weights[i] < 0)
      throw Error("weight " + std::to_string(i) + " of a distribution is " + std::to_string(weights[i]) +
                  ", expected a finite number that is not negative");
    sum += static_cast<double>(weights[i]);
  }
  return sum;
}

/// weight / sum, or equal shares when the sum is 0.
double share(std::span<const float> weights, double sum, std::size_t i) {
  return sum > 0 ? static_cast<double>(weights[i]) / sum : 1.0 / static_cast<double>(weights.size());
}

std::vector<float> row_sums(std::span<const float> weights, std::size_t width, std::size_t height) {
  assert(width > 0 && height > 0 && weights.size() == width * height);
  std::vector<float> sums(height);
  for (std::size_t y = 0; y < height; ++y) sums[y] = static_cast<float>(checked_sum(weights.subspan(y * width, width)));
  return sums;
}

}  // namespace

DiscreteDistribution::DiscreteDistribution(std::span<const float> weights) {
  const double sum = checked_sum(weights);
  cumulative_.reserve(weights.size() + 1);
  cumulative_.push_back(0);
  double running = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    running += share(weights, sum, i);
    cumulative_.push_back(static_cast<float>(running));
  }
  // Rounding may leave the end off 1; bins of weight 0 at the end must stay empty.
  const float end = cumulative_.back();
  for (auto last = cumulative_.rbegin(); last != cumulative_.rend() && *last == end; ++last) *last = 1;
}

Bin DiscreteDistribution::sample(float u) const {
  const auto above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u);
  const auto bin = static_cast<std::size_t>(above - cumulative_.begin()) - 1;
  return {bin, probability(bin)};
}

Bin DiscreteDistribution::sample(float u, float& remapped) const {
  const Bin bin = sample(u);
  remapped = std::clamp((u - cumulative_[bin.index]) / bin.probability, 0.0f, one_minus_epsilon);
  return bin;
}

AliasTable::AliasTable(std::span<const float> weights) : entries_(weights.size()) {
  const double sum = checked_sum(weights);
  const auto n = static_cast<double>(weights.size());
  std::vector<double> scaled(weights.size());
  std::vector<std::uint32_t> small, large;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    entries_[i].probability = static_cast<float>(share(weights, sum, i));
    entries_[i].alias = static_cast<std::uint32_t>(i);
    scaled[i] = share(weights, sum, i) * n;
    (scaled[i] < 1 ? small : large).push_back(static_cast<std::uint32_t>(i));
  }
  while (!small.empty() && !large.empty()) {
    const std::uint32_t low = small.back(), high = large.back();
    small.pop_back();
    entries_[low].threshold = static_cast<float>(scaled[low]);
    entries_[low].alias = high;
    scaled[high] -= 1 - scaled[low];
    if (scaled[high] >= 1) continue;
    large.pop_back();
    small.push_back(high);
  }
  // What is left would be exactly 1 but for rounding; a bin without weight must not be drawn all the same.
  for (const std::uint32_t i : small)
    if (weights[i] == 0 && sum > 0) {
      entries_[i].threshold = 0;
      entries_[i].alias =
          static_cast<std::uint32_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    }
}

Bin AliasTable::sample(float u) const {
  const float scaled = u * static_cast<float>(entries_.size());
  const std::size_t i = std::min(static_cast<std::size_t>(scaled), entries_.size() - 1);
  const std::size_t bin = scaled - static_cast<float>(i) < entries_[i].threshold ? i : entries_[i].alias;
  return {bin, entries_[bin].probability};
}

PiecewiseConstant1D::Sample PiecewiseConstant1D::sample(float u) const {
  float within = 0;
  const Bin bin = bins_.sample(u, within);
  const auto n = static_cast<float>(size());
  float x = std::min((static_cast<float>(bin.index) + within) / n, one_minus_epsilon);
  // Rounding may have carried x over an end of its bin, to where the density is another, perhaps 0.
  while (bin_of(x) > bin.index) x = std::nextafter(x, 0.0f);
  while (bin_of(x) < bin.index) x = std::nextafter(x, 1.0f);
  return {x, bin.probability * n, bin.index};
}

std::size_t PiecewiseConstant1D::bin_of(float x) const {
  const float scaled = x * static_cast<float>(size());
  return scaled > 0 ? std::min(static_cast<std::size_t>(scaled), size() - 1) : 0;
}

float PiecewiseConstant1D::pdf(float x) const { return bins_.probability(bin_of(x)) * static_cast<float>(size()); }

float PiecewiseConstant1D::to_uniform(float x) const {
  const std::size_t bin = bin_of(x);
  const float within = x * static_cast<float>(size()) - static_cast<float>(bin);
  return bins_.cumulative()[bin] + within * bins_.probability(bin);
}

PiecewiseConstant2D::PiecewiseConstant2D(std::span<const float> weights, std::size_t width, std::size_t height)
    : marginal_(row_sums(weights, width, height)) {
  rows_.reserve(height);
  for (std::size_t y = 0; y < height; ++y) rows_.emplace_back(weights.subspan(y * width, width));
}

PiecewiseConstant2D::Sample PiecewiseConstant2D::sample(Vec2 u) const {
  const auto row = marginal_.sample(u.y);
  const auto column = rows_[row.bin].sample(u.x);
  return {{column.x, row.x}, column.pdf * row.pdf};
}

float PiecewiseConstant2D::pdf(Vec2 uv) const {
  const auto height = static_cast<float>(rows_.size());
  const auto row = std::min(static_cast<std::size_t>(std::max(0.0f, uv.y * height)), rows_.size() - 1);
  return rows_[row].pdf(uv.x) * marginal_.pdf(uv.y);
}

Vec2 PiecewiseConstant2D::to_square(Vec2 uv) const {
  const auto height = static_cast<float>(rows_.size());
  const auto row = std::min(static_cast<std::size_t>(std::max(0.0f, uv.y * height)), rows_.size() - 1);
  return {rows_[row].to_uniform(uv.x), marginal_.to_uniform(uv.y)};
}

}  // namespace lambert
