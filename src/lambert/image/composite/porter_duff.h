#pragma once
/// The algebra of premultiplied pictures (Porter and Duff, "Compositing Digital Images", SIGGRAPH 1984): how two
/// elements A and B that each cover a part of a pixel join there, when nothing is known of the shapes of these parts
/// but that they are independent.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::composite {

/// Colour times coverage, and the coverage: half covered by full red is (0.5, 0, 0, 0.5). Colours are linear and
/// unbounded; where alpha is 0 they are 0, but for light that hides nothing (`opaque`).
struct Pixel {
  float r = 0, g = 0, b = 0, a = 0;
  constexpr bool operator==(const Pixel&) const = default;
};
constexpr Pixel operator+(Pixel p, Pixel q) { return {p.r + q.r, p.g + q.g, p.b + q.b, p.a + q.a}; }
constexpr Pixel operator*(float s, Pixel p) { return {s * p.r, s * p.g, s * p.b, s * p.a}; }

inline constexpr Pixel clear_pixel{}, black_pixel{0, 0, 0, 1};

/// An alpha as coverage: in [0, 1], NaN as 0.
constexpr float coverage(float alpha) { return std::min(std::max(0.0f, alpha), 1.0f); }

/// The four parts of a pixel that two elements make; they add up to 1.
struct CoverageAreas {
  float neither = 1, a_only = 0, b_only = 0, both = 0;
};
CoverageAreas coverage_areas(float alpha_a, float alpha_b);

/// `rover` is B over A, and so on; `plus` adds without regard to coverage.
enum class Operator { clear, a, b, over, rover, in, rin, out, rout, atop, ratop, exclusive_or, plus };
inline constexpr std::array all_operators = {Operator::clear, Operator::a,    Operator::b,     Operator::over,
                                             Operator::rover, Operator::in,   Operator::rin,   Operator::out,
                                             Operator::rout,  Operator::atop, Operator::ratop, Operator::exclusive_or,
                                             Operator::plus};
/// "over", "xor"
std::string_view name_of(Operator op);

/// How much of an element's own coverage is kept, by the coverage of the other one.
enum class Factor { zero, one, other, complement };
struct Factors {
  Factor a, b;
};
/// The table F_A, F_B of all operators.
Factors factors(Operator op);
/// `alpha` is the other element's. In [0, 1].
constexpr float value_of(Factor factor, float alpha) {
  switch (factor) {
    case Factor::zero: return 0;
    case Factor::one: return 1;
    case Factor::other: return coverage(alpha);
    case Factor::complement: return 1 - coverage(alpha);
  }
  return 0;
}

/// F_A A + F_B B in all four channels, alpha among them, of which what is negative or not a number counts as 0. What
/// has a factor of 0 does not count, even if it is infinite or not a number.
Pixel combine(Operator op, Pixel a, Pixel b);

/// A row of one channel: b = F_A a + F_B b. All spans have one length; `alpha_a`, `alpha_b` are the coverages of the
/// channel; `b` must overlap no other span.
void combine_row(Operator op, std::span<const float> a, std::span<const float> alpha_a, std::span<const float> alpha_b,
                 std::span<float> b);
/// The same of the coverages themselves: alpha_b = F_A alpha_a + F_B alpha_b; the last thing to do to a row.
void combine_alpha_row(Operator op, std::span<const float> alpha_a, std::span<float> alpha_b);
/// The same of values that cannot be mixed (depths, numbers of objects): b = a where A contributes (F_A alpha_a > 0),
/// else b where F_B > 0, else `nothing`.
void choose_row(Operator op, std::span<const float> a, std::span<const float> alpha_a, std::span<const float> alpha_b,
                float nothing, std::span<float> b);

}  // namespace lambert::composite
