#pragma once
/// Exact arithmetic on sums of doubles that do not overlap, smallest first (Shewchuk, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates", 1997). Exact while no intermediate overflows or
/// falls below 2^-1022; needs round-to-nearest and no contraction.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace lambert::polygon {

struct RoundedSum {
  double value, error;  ///< value + error is the exact result
};

inline RoundedSum two_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a, a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

inline RoundedSum two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// Up to `capacity` components; zeros are dropped, so that size() is often far smaller.
template <std::size_t capacity>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(RoundedSum sum) {
    push(sum.error);
    push(sum.value);
  }
  Expansion(const Expansion& other) { *this = other; }
  Expansion& operator=(const Expansion& other) {
    size_ = other.size_;
    std::copy_n(other.components_.begin(), size_, components_.begin());  // not the unused rest, which may be large
    return *this;
  }

  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return components_[i]; }
  void push(double component) {
    if (component != 0) components_[size_++] = component;
  }

  /// -1, 0 or 1: the last component outweighs all others.
  int sign() const { return size_ == 0 ? 0 : (components_[size_ - 1] > 0 ? 1 : -1); }
  /// Within one rounding or so of the exact value.
  double estimate() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += components_[i];
    return sum;
  }

  Expansion operator-() const {
    Expansion negative;
    for (std::size_t i = 0; i < size_; ++i) negative.push(-components_[i]);
    return negative;
  }

 private:
  std::array<double, capacity> components_;
  std::size_t size_ = 0;
};

/// `sum` + `component`; `sum` has room for it (Shewchuk's fig. 6, Grow-Expansion).
template <std::size_t n>
void grow(Expansion<n>& sum, double component) {
  Expansion<n> grown;
  double carry = component;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const RoundedSum s = two_sum(carry, sum[i]);
    grown.push(s.error);
    carry = s.value;
  }
  grown.push(carry);
  sum = grown;
}

template <std::size_t n, std::size_t m>
Expansion<n + m> operator+(const Expansion<n>& a, const Expansion<m>& b) {
  Expansion<n + m> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.push(a[i]);
  for (std::size_t j = 0; j < b.size(); ++j) grow(sum, b[j]);
  return sum;
}

template <std::size_t n, std::size_t m>
Expansion<n + m> operator-(const Expansion<n>& a, const Expansion<m>& b) {
  return a + -b;
}

/// Shewchuk's fig. 13, Scale-Expansion. Never more than 2n components, whatever overflows.
template <std::size_t n>
Expansion<2 * n> operator*(const Expansion<n>& a, double factor) {
  Expansion<2 * n> scaled;
  if (a.size() == 0) return scaled;
  // The first component apart, so that there are at most two a component, NaN or not.
  const RoundedSum first = two_product(a[0], factor);
  scaled.push(first.error);
  double carry = first.value;
  for (std::size_t i = 1; i < a.size(); ++i) {
    const RoundedSum product = two_product(a[i], factor);
    const RoundedSum low = two_sum(carry, product.error);
    scaled.push(low.error);
    const RoundedSum high = two_sum(product.value, low.value);
    scaled.push(high.error);
    carry = high.value;
  }
  scaled.push(carry);
  return scaled;
}

template <std::size_t n, std::size_t m>
Expansion<2 * n * m> operator*(const Expansion<n>& a, const Expansion<m>& b) {
  Expansion<2 * n * m> product;
  for (std::size_t j = 0; j < b.size(); ++j) {
    const Expansion<2 * n> part = a * b[j];
    for (std::size_t k = 0; k < part.size(); ++k) grow(product, part[k]);
  }
  return product;
}

}  // namespace lambert::polygon
