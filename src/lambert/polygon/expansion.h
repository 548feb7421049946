#pragma once
/// Exact arithmetic on sums of floating-point numbers that do not overlap, smallest first (Shewchuk, "Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates", 1997). Exact while no intermediate leaves
/// the range of the numbers, roundings included; needs round-to-nearest and no contraction.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace lambert::polygon {

template <class Real>
struct Rounded {
  Real value, error;  ///< value + error is the exact result
};
using RoundedSum = Rounded<double>;

template <class Real = double>
Rounded<Real> two_sum(std::type_identity_t<Real> a, std::type_identity_t<Real> b) {
  const Real sum = a + b, b_part = sum - a, a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

template <class Real = double>
Rounded<Real> two_product(std::type_identity_t<Real> a, std::type_identity_t<Real> b) {
  const Real product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// Up to `capacity` components; zeros are dropped, so that size() is often far smaller.
template <std::size_t capacity, class Real = double>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(Rounded<Real> sum) {
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
  Real operator[](std::size_t i) const { return components_[i]; }
  void push(Real component) {
    if (component != 0) components_[size_++] = component;
  }

  /// -1, 0 or 1: the last component outweighs all others.
  int sign() const { return size_ == 0 ? 0 : (components_[size_ - 1] > 0 ? 1 : -1); }
  /// Within one rounding or so of the exact value.
  Real estimate() const {
    Real sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += components_[i];
    return sum;
  }

  Expansion operator-() const {
    Expansion negative;
    for (std::size_t i = 0; i < size_; ++i) negative.push(-components_[i]);
    return negative;
  }

 private:
  std::array<Real, capacity> components_;
  std::size_t size_ = 0;
};

/// `sum` + `component`; `sum` has room for it (Shewchuk's fig. 6, Grow-Expansion).
template <std::size_t n, class Real>
void grow(Expansion<n, Real>& sum, std::type_identity_t<Real> component) {
  Expansion<n, Real> grown;
  Real carry = component;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const Rounded<Real> s = two_sum<Real>(carry, sum[i]);
    grown.push(s.error);
    carry = s.value;
  }
  grown.push(carry);
  sum = grown;
}

template <std::size_t n, std::size_t m, class Real>
Expansion<n + m, Real> operator+(const Expansion<n, Real>& a, const Expansion<m, Real>& b) {
  Expansion<n + m, Real> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.push(a[i]);
  for (std::size_t j = 0; j < b.size(); ++j) grow(sum, b[j]);
  return sum;
}

template <std::size_t n, std::size_t m, class Real>
Expansion<n + m, Real> operator-(const Expansion<n, Real>& a, const Expansion<m, Real>& b) {
  return a + -b;
}

/// Shewchuk's fig. 13, Scale-Expansion. Never more than 2n components, whatever overflows.
template <std::size_t n, class Real>
Expansion<2 * n, Real> operator*(const Expansion<n, Real>& a, std::type_identity_t<Real> factor) {
  Expansion<2 * n, Real> scaled;
  if (a.size() == 0) return scaled;
  // The first component apart, so that there are at most two a component, NaN or not.
  const Rounded<Real> first = two_product<Real>(a[0], factor);
  scaled.push(first.error);
  Real carry = first.value;
  for (std::size_t i = 1; i < a.size(); ++i) {
    const Rounded<Real> product = two_product<Real>(a[i], factor);
    const Rounded<Real> low = two_sum<Real>(carry, product.error);
    scaled.push(low.error);
    const Rounded<Real> high = two_sum<Real>(product.value, low.value);
    scaled.push(high.error);
    carry = high.value;
  }
  scaled.push(carry);
  return scaled;
}

template <std::size_t n, std::size_t m, class Real>
Expansion<2 * n * m, Real> operator*(const Expansion<n, Real>& a, const Expansion<m, Real>& b) {
  Expansion<2 * n * m, Real> product;
  for (std::size_t j = 0; j < b.size(); ++j) {
    const Expansion<2 * n, Real> part = a * b[j];
    for (std::size_t k = 0; k < part.size(); ++k) grow(product, part[k]);
  }
  return product;
}

}  // namespace lambert::polygon
