#include "vectors.h"

#include "lambert/sampling/distribution.h"
#include "lambert/sampling/inversion.h"
#include "lambert/sampling/quadrature.h"
#include "lambert/sampling/rejection.h"
#include "lambert/sampling/sampling_test_tools.h"
#include "lambert/sampling/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambert {
namespace {

Vec2 vec2(const nlohmann::json& v) { return {v.at(0).get<float>(), v.at(1).get<float>()}; }

// rows: PT-06
const CheckOf quadrature("V-PT-01", [](const Vector& v) {
  const double a = v.input.at("a"), b = v.input.at("b"),
               integral = midpoint_integral([](double x) { return x; }, a, b, v.input.at("n"));
  v.expect_near(integral, v.expected.at("I"));
  v.expect_near(integral / (b - a), v.expected.at("printed_formula"));  // without the factor b - a (E-PT-01)
});

// rows: PT-08
const CheckOf mean_cosine("V-PT-02", [](const Vector& v) {
  const auto mean = [](double end) {
    return midpoint_integral([](double x) { return std::cos(x); }, 0, end, 1 << 19) / end;
  };
  v.expect_near(mean(std::numbers::pi), v.expected.at("full"));
  v.expect_near(mean(std::numbers::pi / 2), v.expected.at("half"));
});

// rows: PT-10 PT-14
const CheckOf estimator("V-PT-03", [](const Vector& v) {
  const auto pdf = [](double x) { return 2 * x / 15; };
  const auto cdf = [](double x) { return (x * x - 1) / 15; };
  for (std::size_t i = 0; i < v.input.at("xi").size(); ++i) {
    const double x = invert_cdf(cdf, v.input.at("xi")[i], 1, 4);
    v.expect_near(x, v.expected.at("X")[i]);
    v.expect_near(x * x / pdf(x), v.expected.at("term")[i]);
  }
  // The mean of the terms over all xi is the integral.
  const auto term = [&](double xi) {
    const double x = invert_cdf(cdf, xi, 1, 4);
    return x * x / pdf(x);
  };
  EXPECT_NEAR(midpoint_integral(term, 0, 1, 2000), v.expected.at("integral").get<double>(), 1e-5);
});

// rows: PT-13
const CheckOf bins("V-PT-04", [](const Vector& v) {
  const DiscreteDistribution d(v.input.at("p").get<std::vector<float>>());
  for (std::size_t i = 0; i < d.size(); ++i) v.expect_near(d.cumulative()[i + 1], v.expected.at("cdf")[i]);
  for (std::size_t i = 0; i < v.input.at("xi").size(); ++i)
    EXPECT_EQ(d.sample(v.input.at("xi")[i].get<float>()).index + 1, v.expected.at("bin")[i].get<std::size_t>())
        << v.input.at("xi")[i];
});

// rows: PT-15
const CheckOf power("V-PT-05", [](const Vector& v) {
  const auto n = v.input.at("n").get<float>();
  for (std::size_t i = 0; i < v.input.at("xi").size(); ++i)
    v.expect_near(square_to_cosine_power({v.input.at("xi")[i].get<float>(), 0}, n).z, v.expected.at("X")[i]);
  const auto x = [n](double xi) {
    return static_cast<double>(square_to_cosine_power({static_cast<float>(xi), 0}, n).z);
  };
  EXPECT_NEAR(midpoint_integral(x, 0, 1, 10000), v.expected.at("mean").get<double>(), 1e-5);
});

// rows: PT-16
const CheckOf rejection("V-PT-06", [](const Vector& v) {
  TestNumbers random(1);
  constexpr int accepted = 30000;
  double tries = 0;
  for (int i = 0; i < accepted; ++i) tries += disk_by_rejection(random)->tries;
  v.expect_near(accepted / tries, v.expected.at("acceptance"));
});

// rows: PT-17
const CheckOf disk("V-PT-07", [](const Vector& v) {
  const Vec2 p = square_to_uniform_disk_polar({v.input.at("xi1").get<float>(), v.input.at("xi2").get<float>()});
  v.expect_near(length(p), v.expected.at("r"));
  v.expect_near(std::atan2(p.y, p.x), v.expected.at("theta"));
  // r does not fall with xi, so the share within 1/2 is where r reaches it.
  v.expect_near(uniform_disk_polar_to_square({0.5f, 0}).x, v.expected.at("fraction_within_half"));
});

// rows: PT-19
const CheckOf whole_sphere("V-PT-08", [](const Vector& v) {
  for (std::size_t i = 0; i < v.input.at("xi").size(); ++i)
    v.expect_near(square_to_uniform_sphere(vec2(v.input.at("xi")[i])), v.expected.at("dir")[i]);
  v.expect_near(uniform_sphere_pdf(), v.expected.at("pdf"));
});

// rows: PT-20
const CheckOf hemisphere("V-PT-09", [](const Vector& v) {
  for (std::size_t i = 0; i < v.input.at("xi").size(); ++i) {
    const Vec3 w = square_to_uniform_hemisphere(vec2(v.input.at("xi")[i]));
    v.expect_near(w, v.expected.at("dir")[i]);
    v.expect_near(uniform_hemisphere_pdf(w), v.expected.at("pdf"));
  }
});

// rows: PT-29
// The cosine hemisphere is the concentric disk lifted; here it is asked for the polar disk's point.
const CheckOf cosine("V-PT-10", [](const Vector& v) {
  const Vec2 p = square_to_uniform_disk_polar({v.input.at("xi1").get<float>(), v.input.at("xi2").get<float>()});
  const Vec3 w = square_to_cosine_hemisphere(uniform_disk_concentric_to_square(p));
  v.expect_near(w, v.expected.at("dir"));
  v.expect_near(cosine_hemisphere_pdf(w), v.expected.at("pdf"));
});

// rows: PT-21
const CheckOf image("V-PT-11", [](const Vector& v) {
  std::vector<float> f;
  for (const auto& row : v.input.at("f"))
    for (const auto& value : row) f.push_back(value.get<float>());
  const PiecewiseConstant2D d(f, 2, 2);
  for (std::size_t y = 0; y < 2; ++y) {
    float row = 0;
    for (std::size_t x = 0; x < 2; ++x) {
      const float pdf = d.pdf({0.25f + 0.5f * static_cast<float>(x), 0.25f + 0.5f * static_cast<float>(y)});
      v.expect_near(pdf, v.expected.at("pdf_cell")[y][x]);
      row += 0.25f * pdf;
    }
    v.expect_near(row, v.expected.at("row_probability")[y]);
  }
  for (std::size_t i = 0; i < v.input.at("xi_row").size(); ++i) {
    const auto s = d.sample({v.input.at("xi_col")[i].get<float>(), v.input.at("xi_row")[i].get<float>()});
    EXPECT_EQ(static_cast<int>(2 * s.uv.y), v.expected.at("row")[i].get<int>());
    EXPECT_EQ(static_cast<int>(2 * s.uv.x), v.expected.at("column")[i].get<int>());
  }
});

}  // namespace
}  // namespace lambert
