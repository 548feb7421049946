#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace lambert::hdr {

/// A symmetric matrix, of which the lower triangle is used, by rows.
struct SymmetricMatrix {
  std::size_t size = 0;
  std::vector<double> entries;
  explicit SymmetricMatrix(std::size_t n) : size(n), entries(n * n) {}
  double& at(std::size_t row, std::size_t column) { return entries[row * size + column]; }  ///< row >= column
  double at(std::size_t row, std::size_t column) const { return entries[row * size + column]; }
  double full(std::size_t i, std::size_t j) const { return i >= j ? at(i, j) : at(j, i); }
  std::vector<double> times(const std::vector<double>& x) const;
};

/// The x of a x = b by Cholesky's decomposition; none when `a` is not positive definite as far as doubles can tell.
std::optional<std::vector<double>> solve_positive(SymmetricMatrix a, std::vector<double> b);

/// The nearest sequence that never falls, in the weighted sense of least squares (pool adjacent violators).
std::vector<double> never_falling(const std::vector<double>& values, const std::vector<double>& weights);

}  // namespace lambert::hdr
