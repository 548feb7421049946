#include "lambert/image/hdr/least_squares.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {
namespace {

/// In eight sums, so that it is done several at a time.
double dot(const double* a, const double* b, std::size_t n) {
  double sums[8] = {};
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8)
    for (std::size_t k = 0; k < 8; ++k) sums[k] += a[i + k] * b[i + k];
  for (; i < n; ++i) sums[0] += a[i] * b[i];
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

}  // namespace

std::vector<double> SymmetricMatrix::times(const std::vector<double>& x) const {
  std::vector<double> product(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double* row = &entries[i * size];
    product[i] += dot(row, x.data(), i + 1);
    for (std::size_t j = 0; j < i; ++j) product[j] += row[j] * x[i];
  }
  return product;
}

std::optional<std::vector<double>> solve_positive(SymmetricMatrix a, std::vector<double> b) {
  const std::size_t n = a.size;
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, a.at(i, i));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double sum = a.at(i, j) - dot(&a.at(i, 0), &a.at(j, 0), j);
      if (i != j)
        a.at(i, j) = sum / a.at(j, j);
      else if (sum > 1e-15 * largest)
        a.at(i, i) = std::sqrt(sum);
      else
        return std::nullopt;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a.at(i, k) * b[k];
    b[i] /= a.at(i, i);
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a.at(k, i) * b[k];
    b[i] /= a.at(i, i);
  }
  return b;
}

std::vector<double> never_falling(const std::vector<double>& values, const std::vector<double>& weights) {
  struct Block {
    double mean, weight;
    std::size_t count;
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < values.size(); ++i) {
    blocks.push_back({values[i], weights[i], 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean > blocks.back().mean) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& into = blocks.back();
      into.mean = (into.mean * into.weight + last.mean * last.weight) / (into.weight + last.weight);
      into.weight += last.weight, into.count += last.count;
    }
  }
  std::vector<double> result;
  for (const Block& block : blocks) result.insert(result.end(), block.count, block.mean);
  return result;
}

}  // namespace lambert::hdr
