#include "lambert/image/composite/porter_duff.h"

#include <utility>

namespace lambert::composite {
namespace {

constexpr std::size_t operator_count = all_operators.size();

struct Line {
  std::string_view name;
  Factors factors;
};
/// In the order of Operator.
constexpr std::array<Line, operator_count> table = {{
    {"clear", {Factor::zero, Factor::zero}},
    {"a", {Factor::one, Factor::zero}},
    {"b", {Factor::zero, Factor::one}},
    {"over", {Factor::one, Factor::complement}},
    {"rover", {Factor::complement, Factor::one}},
    {"in", {Factor::other, Factor::zero}},
    {"rin", {Factor::zero, Factor::other}},
    {"out", {Factor::complement, Factor::zero}},
    {"rout", {Factor::zero, Factor::complement}},
    {"atop", {Factor::other, Factor::complement}},
    {"ratop", {Factor::complement, Factor::other}},
    {"xor", {Factor::complement, Factor::complement}},
    {"plus", {Factor::one, Factor::one}},
}};

/// Of an alpha in the result: what is no coverage, negative or not a number, makes no hole in the other element.
constexpr float kept(float alpha) { return std::max(0.0f, alpha); }

/// The product is taken even where it does not count, so that the loops below have no branches.
template <Factor f>
float part(float value, float alpha) {
  if constexpr (f == Factor::zero) return 0;
  if constexpr (f == Factor::one) return value;
  const float weight = f == Factor::other ? coverage(alpha) : 1 - coverage(alpha), product = weight * value;
  return weight > 0 ? product : 0.0f;
}

template <std::size_t i>
void row(std::size_t n, const float* __restrict a, const float* __restrict alpha_a, const float* __restrict alpha_b,
         float* __restrict b) {
  constexpr Factors f = table[i].factors;
  for (std::size_t x = 0; x < n; ++x) b[x] = part<f.a>(a[x], alpha_b[x]) + part<f.b>(b[x], alpha_a[x]);
}

template <std::size_t i>
void alpha_row(std::size_t n, const float* __restrict alpha_a, float* __restrict alpha_b) {
  constexpr Factors f = table[i].factors;
  for (std::size_t x = 0; x < n; ++x)
    alpha_b[x] = part<f.a>(kept(alpha_a[x]), alpha_b[x]) + part<f.b>(kept(alpha_b[x]), alpha_a[x]);
}

template <std::size_t i>
void choice_row(std::size_t n, const float* __restrict a, const float* __restrict alpha_a,
                const float* __restrict alpha_b, float nothing, float* __restrict b) {
  constexpr Factors f = table[i].factors;
  for (std::size_t x = 0; x < n; ++x) {
    const float otherwise = value_of(f.b, alpha_a[x]) > 0 ? b[x] : nothing;
    b[x] = value_of(f.a, alpha_b[x]) * coverage(alpha_a[x]) > 0 ? a[x] : otherwise;
  }
}

template <std::size_t... i>
constexpr auto rows(std::index_sequence<i...>) {
  return std::array{row<i>...};
}
template <std::size_t... i>
constexpr auto alpha_rows(std::index_sequence<i...>) {
  return std::array{alpha_row<i>...};
}
template <std::size_t... i>
constexpr auto choice_rows(std::index_sequence<i...>) {
  return std::array{choice_row<i>...};
}

constexpr auto each = std::make_index_sequence<operator_count>();

const Line& line(Operator op) { return table[static_cast<std::size_t>(op)]; }

}  // namespace

CoverageAreas coverage_areas(float alpha_a, float alpha_b) {
  const float a = coverage(alpha_a), b = coverage(alpha_b);
  return {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
}

std::string_view name_of(Operator op) { return line(op).name; }
Factors factors(Operator op) { return line(op).factors; }

Pixel combine(Operator op, Pixel a, Pixel b) {
  const float fa = value_of(factors(op).a, b.a), fb = value_of(factors(op).b, a.a);
  a.a = kept(a.a), b.a = kept(b.a);
  return (fa > 0 ? fa * a : clear_pixel) + (fb > 0 ? fb * b : clear_pixel);
}

void combine_row(Operator op, std::span<const float> a, std::span<const float> alpha_a, std::span<const float> alpha_b,
                 std::span<float> b) {
  static constexpr auto functions = rows(each);
  functions[static_cast<std::size_t>(op)](b.size(), a.data(), alpha_a.data(), alpha_b.data(), b.data());
}

void combine_alpha_row(Operator op, std::span<const float> alpha_a, std::span<float> alpha_b) {
  static constexpr auto functions = alpha_rows(each);
  functions[static_cast<std::size_t>(op)](alpha_b.size(), alpha_a.data(), alpha_b.data());
}

void choose_row(Operator op, std::span<const float> a, std::span<const float> alpha_a, std::span<const float> alpha_b,
                float nothing, std::span<float> b) {
  static constexpr auto functions = choice_rows(each);
  functions[static_cast<std::size_t>(op)](b.size(), a.data(), alpha_a.data(), alpha_b.data(), nothing, b.data());
}

}  // namespace lambert::composite
