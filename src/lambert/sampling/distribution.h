#pragma once
/// Distributions given by tables of weights. Weights must be finite and not negative (throws Error otherwise); if all
/// are 0 they count as equal. Sums are taken in double.

#include "lambert/base/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lambert {

/// A bin drawn from a table, and how probable it was.
struct Bin {
  std::size_t index = 0;
  float probability = 0;
};

/// Bins by their cumulative weights: sample() is a binary search (row PT-13).
class DiscreteDistribution {
 public:
  explicit DiscreteDistribution(std::span<const float> weights);
  Bin sample(float u) const;
  /// The same, and the place of u within the bin, in [0,1): to be used as a fresh number.
  Bin sample(float u, float& remapped) const;
  float probability(std::size_t bin) const { return cumulative_[bin + 1] - cumulative_[bin]; }
  std::size_t size() const { return cumulative_.size() - 1; }
  std::span<const float> cumulative() const { return cumulative_; }  ///< 0, …, 1

 private:
  std::vector<float> cumulative_;
};

/// Bins in constant time (Walker 1974; Vose's construction 1991).
class AliasTable {
 public:
  AliasTable() = default;
  explicit AliasTable(std::span<const float> weights);
  Bin sample(float u) const;
  float probability(std::size_t bin) const { return entries_[bin].probability; }
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    float threshold = 1;  // below it the bin itself, above it the alias
    float probability = 0;
    std::uint32_t alias = 0;
  };
  std::vector<Entry> entries_;
};

/// A step function over [0,1] as a density, by inversion (row PT-14).
class PiecewiseConstant1D {
 public:
  explicit PiecewiseConstant1D(std::span<const float> weights) : bins_(weights) {}
  struct Sample {
    float x = 0;
    float pdf = 0;
    std::size_t bin = 0;
  };
  Sample sample(float u) const;  ///< pdf(x) at its x is its pdf: rounding never moves x into another bin
  float pdf(float x) const;
  float to_uniform(float x) const;  ///< the inverse of sample: the cumulative density at x
  std::size_t size() const { return bins_.size(); }

 private:
  std::size_t bin_of(float x) const;
  DiscreteDistribution bins_;
};

/// A step function over the unit square as a density: a row by the marginal, then a place in it by the conditional
/// (row PT-21). `weights` are rows from v = 0, `width` values each.
class PiecewiseConstant2D {
 public:
  PiecewiseConstant2D(std::span<const float> weights, std::size_t width, std::size_t height);
  struct Sample {
    Vec2 uv{0};
    float pdf = 0;
  };
  Sample sample(Vec2 u) const;
  float pdf(Vec2 uv) const;
  Vec2 to_square(Vec2 uv) const;  ///< the inverse of sample

 private:
  std::vector<PiecewiseConstant1D> rows_;
  PiecewiseConstant1D marginal_;
};

}  // namespace lambert
