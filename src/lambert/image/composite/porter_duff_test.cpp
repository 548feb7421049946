#include "lambert/image/composite/porter_duff.h"

#include "lambert/base/hash.h"
#include "lambert/image/composite/adjust.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambert::composite {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

/// Premultiplied, the same ones every time; every fourth opaque, every fourth clear.
Pixel pixel(std::uint64_t i) {
  const auto u = [&](std::uint64_t k) { return hash_to_float(hash_values(i, k)); };
  const float a = i % 4 == 0 ? 1.0f : (i % 4 == 1 ? 0.0f : u(3));
  return {u(0) * a, u(1) * a, 3 * u(2) * a, a};
}

void expect_near(Pixel p, Pixel q, float tolerance = 2e-6f) {
  EXPECT_NEAR(p.r, q.r, tolerance);
  EXPECT_NEAR(p.g, q.g, tolerance);
  EXPECT_NEAR(p.b, q.b, tolerance);
  EXPECT_NEAR(p.a, q.a, tolerance);
}

// rows: AA-28
TEST(PorterDuff, TheFourAreasFillThePixel) {
  for (std::uint64_t i = 0; i < 400; ++i) {
    const float a = pixel(i).a, b = pixel(i * 7 + 2).a;
    const CoverageAreas areas = coverage_areas(a, b);
    EXPECT_NEAR(areas.neither + areas.a_only + areas.b_only + areas.both, 1, 1e-6f);
    EXPECT_NEAR(areas.a_only + areas.both, a, 1e-6f);
    EXPECT_NEAR(areas.b_only + areas.both, b, 1e-6f);
  }
}

/// Who shows in the areas (A alone, B alone, both): 0 nobody, 1 A, 2 B. By Porter and Duff's table.
struct Shown {
  int a_only, b_only, both;
};
constexpr std::array<Shown, 12> shown = {{{0, 0, 0},
                                          {1, 0, 1},
                                          {0, 2, 2},
                                          {1, 2, 1},
                                          {1, 2, 2},
                                          {0, 0, 1},
                                          {0, 0, 2},
                                          {1, 0, 0},
                                          {0, 2, 0},
                                          {0, 2, 1},
                                          {1, 0, 2},
                                          {1, 2, 0}}};

// rows: AA-29
// Each operator is the sum over the areas of what shows there, in the straight colour of whoever it is.
TEST(PorterDuff, EveryOperatorIsTheSumOfItsAreas) {
  for (std::size_t op = 0; op < shown.size(); ++op)
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Pixel a = pixel(i), b = pixel(i * 5 + 3);
      const CoverageAreas areas = coverage_areas(a.a, b.a);
      Pixel sum;
      const auto add = [&](int who, float area) {
        const Pixel& p = who == 1 ? a : b;
        if (who != 0 && p.a > 0) sum = sum + (area / p.a) * p;
      };
      add(shown[op].a_only, areas.a_only);
      add(shown[op].b_only, areas.b_only);
      add(shown[op].both, areas.both);
      SCOPED_TRACE(name_of(all_operators[op]));
      expect_near(combine(all_operators[op], a, b), sum);
    }
}

// rows: AA-29
TEST(PorterDuff, Identities) {
  using enum Operator;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Pixel a = pixel(i), b = pixel(i * 3 + 1), c = pixel(i * 11 + 2);
    expect_near(combine(over, combine(over, a, b), c), combine(over, a, combine(over, b, c)), 1e-5f);
    expect_near(combine(in, combine(in, a, b), c), combine(in, a, combine(in, b, c)));
    EXPECT_EQ(combine(plus, a, b), combine(plus, b, a));
    expect_near(combine(in, a, b) + combine(out, a, b), a);
    expect_near(combine(exclusive_or, a, b), combine(exclusive_or, b, a));
    expect_near(combine(exclusive_or, a, b), combine(out, a, b) + combine(out, b, a));
    expect_near(combine(atop, a, b), combine(in, a, b) + combine(out, b, a));
    expect_near(combine(over, a, b), combine(atop, a, b) + combine(out, a, b));
    expect_near(combine(rover, a, b), combine(over, b, a));
    expect_near(combine(rin, a, b), combine(in, b, a));
    expect_near(combine(rout, a, b), combine(out, b, a));
    expect_near(combine(ratop, a, b), combine(atop, b, a));
    EXPECT_EQ(combine(clear, a, b), clear_pixel);
    EXPECT_EQ(combine(over, a, clear_pixel), a);
    EXPECT_EQ(combine(over, clear_pixel, a), a);
    expect_near(combine(atop, a, b), {combine(atop, a, b).r, combine(atop, a, b).g, combine(atop, a, b).b, b.a});
  }
}

TEST(PorterDuff, CoverageAndColourStayInRange) {
  for (const Operator op : all_operators) {
    if (op == Operator::plus) continue;
    for (std::uint64_t i = 0; i < 400; ++i) {
      const Pixel p = combine(op, pixel(i), pixel(i * 13 + 5));
      EXPECT_GE(p.a, 0);
      EXPECT_LE(p.a, 1 + 1e-6f);
      EXPECT_LE(p.r, p.a + 1e-6f) << "colours of at most 1 stay at most alpha";
    }
  }
}

TEST(PorterDuff, WhatIsHiddenDoesNotCount) {
  const Pixel hidden{inf, nan, -inf, 1};
  EXPECT_EQ(combine(Operator::over, black_pixel, hidden), black_pixel);
  EXPECT_EQ(combine(Operator::out, hidden, black_pixel), clear_pixel);
  EXPECT_EQ(combine(Operator::in, hidden, clear_pixel), clear_pixel);
  EXPECT_EQ(combine(Operator::over, {0, 0, 0, 7}, hidden).r, 0) << "an alpha above 1 covers as 1 does";
  for (const float none : {nan, -1.0f}) {
    EXPECT_EQ(combine(Operator::over, {0, 0, 0, none}, {1, 2, 3, 1}), (Pixel{1, 2, 3, 1})) << "covers nothing";
    std::array alpha_b = {1.0f, 0.25f};
    combine_alpha_row(Operator::over, std::array{none, none}, alpha_b);
    EXPECT_EQ(alpha_b, (std::array{1.0f, 0.25f})) << "and makes no hole";
  }
}

TEST(PorterDuff, RowsAreAsPixels) {
  constexpr std::size_t n = 37;
  for (const Operator op : all_operators) {
    std::array<std::array<float, n>, 4> a, b;
    for (std::size_t x = 0; x < n; ++x) {
      const Pixel p = pixel(x), q = pixel(x * 3 + 2);
      a[0][x] = p.r, a[1][x] = p.g, a[2][x] = p.b, a[3][x] = p.a;
      b[0][x] = q.r, b[1][x] = q.g, b[2][x] = q.b, b[3][x] = q.a;
    }
    b[0][5] = inf;
    const auto before = b;
    for (std::size_t c = 0; c < 3; ++c) combine_row(op, a[c], a[3], b[3], b[c]);
    auto ids = before[2];
    choose_row(op, a[2], a[3], b[3], -1, ids);
    combine_alpha_row(op, a[3], b[3]);
    for (std::size_t x = 0; x < n; ++x) {
      const Pixel p{a[0][x], a[1][x], a[2][x], a[3][x]}, q{before[0][x], before[1][x], before[2][x], before[3][x]};
      const Pixel expected = combine(op, p, q);
      if (x != 5) expect_near({b[0][x], b[1][x], b[2][x], b[3][x]}, expected, 1e-6f);
      const float fa = value_of(factors(op).a, q.a), fb = value_of(factors(op).b, p.a);
      EXPECT_EQ(ids[x], fa * p.a > 0 ? p.b : (fb > 0 ? q.b : -1)) << name_of(op) << x;
    }
  }
}

// rows: AA-32
TEST(Adjust, DarkenDissolveOpaque) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Pixel a = pixel(i);
    const float t = hash_to_float(hash_values(i, 99u));
    expect_near(dissolve(a, t) + dissolve(a, 1 - t), a);
    EXPECT_EQ(darken(a, 1), a);
    EXPECT_EQ(darken(a, 0), (Pixel{0, 0, 0, a.a})) << "black, not gone";
    EXPECT_EQ(dissolve(a, 0), clear_pixel);
    EXPECT_EQ(opaque(a, 1), a);
    EXPECT_EQ(combine(Operator::over, opaque(a, 0), {0, 0, 1, 1}), (Pixel{a.r, a.g, a.b + 1, 1})) << "adds its light";
    if (a.a > 0) expect_near(premultiply(unpremultiply(a)), a);
  }
  EXPECT_EQ(clamp({2, -1, nan, 0.5f}), (Pixel{1, 0, 0, 0.5f}));
}

TEST(Adjust, ScreenIsSymmetricAndNeverFalls) {
  EXPECT_FLOAT_EQ(screen(0.3f, 0.6f), 1 - 0.7f * 0.4f);
  for (float a = 0; a < 3; a += 0.25f)
    for (float b = 0; b < 3; b += 0.25f) {
      EXPECT_FLOAT_EQ(screen(a, b), screen(b, a));
      EXPECT_GE(screen(a + 0.1f, b), screen(a, b) - 1e-6f);
      EXPECT_GE(screen(a, b), std::max(a, b) - 1e-6f);
    }
}

}  // namespace
}  // namespace lambert::composite
