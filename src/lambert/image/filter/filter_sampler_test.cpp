#include "lambert/image/filter/filter_sampler.h"

#include "damage.h"
#include "lambert/base/hash.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace lambert {
namespace {

/// Along one axis, from the literature, up to a factor.
using Curve = std::function<double(double)>;
double sinc(double x) { return x == 0 ? 1 : std::sin(M_PI * x) / (M_PI * x); }
const std::map<std::string, Curve>& curves() {
  static const std::map<std::string, Curve> table = {
      {"box", [](double) { return 1.0; }},
      {"triangle", [](double x) { return 1 - std::abs(x); }},
      {"gaussian", [](double x) { return std::exp(-2 * x * x) - std::exp(-4.5); }},
      // Mitchell and Netravali 1988, B = C = 1/3.
      {"mitchell",
       [](double x) {
         x = std::abs(x);
         return x < 1 ? (7 * x * x * x - 12 * x * x + 16 / 3.0) / 6
                      : (-7 / 3.0 * x * x * x + 12 * x * x - 20 * x + 32 / 3.0) / 6;
       }},
      // Keys 1981, a = -1/2.
      {"catmull-rom",
       [](double x) {
         x = std::abs(x);
         return x < 1 ? 1.5 * x * x * x - 2.5 * x * x + 1 : -0.5 * x * x * x + 2.5 * x * x - 4 * x + 2;
       }},
      {"lanczos", [](double x) { return sinc(x) * sinc(x / 3); }},
      // Harris 1978, the minimum four-term window over [-1.5, 1.5].
      {"blackman-harris",
       [](double x) {
         const double t = 2 * M_PI * (x + 1.5) / 3;
         return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
       }},
  };
  return table;
}
const std::map<std::string, float> radii = {
    {"box", 0.5f},      {"triangle", 1}, {"gaussian", 1.5f},       {"mitchell", 2},
    {"catmull-rom", 2}, {"lanczos", 3},  {"blackman-harris", 1.5f}};

FilterSampler filter(const std::string& name) { return FilterSampler({.kind = filter_kind(name)}); }

/// Midpoint rule over the filter's square.
double integral(
    const FilterSampler& f, const std::function<double(double)>& of = [](double v) { return v; }) {
  constexpr int n = 300;
  double sum = 0;
  const Vec2 step = 2.0f / n * f.radius();
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Vec2 at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      sum += of(static_cast<double>(f.eval(at * step - f.radius())));
    }
  }
  return sum * static_cast<double>(step.x) * static_cast<double>(step.y);
}

TEST(Filter, HasTheLiteraturesShapeAndUnitIntegral) {
  for (const std::string& name : filter_names()) {
    const FilterSampler f = filter(name);
    const Curve& curve = curves().at(name);
    EXPECT_EQ(f.radius(), Vec2(radii.at(name))) << name;
    EXPECT_NEAR(integral(f), 1, 2e-3) << name;
    const double scale = static_cast<double>(f.eval(Vec2(0))) / (curve(0) * curve(0));
    for (const float x : {0.0f, 0.2f, 0.45f, 0.8f, 1.0f, 1.4f, 2.5f}) {
      if (x > f.radius().x) continue;
      for (const float y : {-0.4f, 0.1f}) {
        const double expected = scale * curve(static_cast<double>(x)) * curve(static_cast<double>(y));
        EXPECT_NEAR(f.eval({x, y}), expected, 1e-5) << name << " " << x;
        EXPECT_NEAR(f.eval({-x, -y}), expected, 1e-5) << name << " " << x;
      }
    }
  }
}

TEST(Filter, IsZeroBeyondItsRadius) {
  for (const std::string& name : filter_names()) {
    const FilterSampler f = filter(name);
    EXPECT_EQ(f.eval({f.radius().x + 1e-3f, 0}), 0) << name;
    EXPECT_EQ(f.eval({0, -f.radius().y - 1e-3f}), 0) << name;
  }
}

TEST(Filter, OffsetsFollowItsMagnitude) {
  for (const std::string& name : filter_names()) {
    const FilterSampler f = filter(name);
    const double absolute = integral(f, [](double v) { return std::abs(v); });
    const Vec2 extent = 2.0f * f.radius();
    const double area = static_cast<double>(extent.x) * static_cast<double>(extent.y);
    const auto result = statistics::chi_square_square(
        [&](Vec2 u) { return (f.sample(u).offset + f.radius()) / extent; },
        [&](Vec2 p) { return std::abs(static_cast<double>(f.eval(p * extent - f.radius()))) / absolute * area; },
        {.tests = static_cast<int>(filter_names().size())});
    EXPECT_TRUE(result) << name << ": " << result.message;
  }
}

// The sign is the filter's and the magnitude ∫|f|, so that Σ weight g(offset) / n estimates ∫ f g.
TEST(Filter, WeightsMakeItsIntegral) {
  for (const std::string& name : filter_names()) {
    const FilterSampler f = filter(name);
    const double absolute = integral(f, [](double v) { return std::abs(v); });
    double mean = 0, square = 0;
    constexpr int n = 50000;
    for (int i = 0; i < n; ++i) {
      const Vec2 u(hash_to_float(hash_values(i, 0)), hash_to_float(hash_values(i, 1)));
      const auto s = f.sample(u);
      EXPECT_NEAR(std::abs(s.weight), absolute, 2e-3 * absolute) << name;
      // Near its zeros the tabulated sign may be the neighbour's.
      if (const float v = f.eval(s.offset); std::abs(v) > 2e-2f * f.eval(Vec2(0))) {
        EXPECT_GT(v * s.weight, 0) << name;
      }
      mean += static_cast<double>(s.weight) / n;
      square += static_cast<double>(s.weight * s.weight) / n;
    }
    const auto result = statistics::z_test(mean, std::sqrt(std::max(1e-12, square - mean * mean) / n), 1,
                                           static_cast<int>(filter_names().size()));
    EXPECT_TRUE(result) << name << ": " << mean;
  }
}

TEST(Filter, SamplesStayInsideAtTheEndsOfTheRange) {
  for (const std::string& name : filter_names()) {
    const FilterSampler f = filter(name);
    for (const Vec2 u : {Vec2(0), Vec2(0x1.fffffep-1f), Vec2(0, 0x1.fffffep-1f)}) {
      const Vec2 offset = f.sample(u).offset;
      EXPECT_LE(std::abs(offset.x), f.radius().x) << name;
      EXPECT_LE(std::abs(offset.y), f.radius().y) << name;
    }
  }
}

TEST(Filter, RadiusPerAxis) {
  const FilterSampler f({.kind = FilterKind::triangle, .radius = {2, 0.5f}});
  EXPECT_NEAR(integral(f), 1, 1e-3);
  EXPECT_NEAR(f.eval(Vec2(0)), 1, 1e-3f) << "a pyramid of volume 4 · 1 · height / 4";
  EXPECT_NEAR(f.eval({1, 0}), 0.5f, 1e-3f);
  EXPECT_NEAR(f.eval({0, 0.25f}), 0.5f, 1e-3f);
}

TEST(Filter, RefusesWhatIsNoFilter) {
  EXPECT_NE(error_of([] { filter_kind("mitchel"); }).find("mitchell"), std::string::npos);
  EXPECT_NE(error_of([] { FilterSampler({.kind = FilterKind::gaussian, .sigma = 0}); }).find("sigma"),
            std::string::npos);
  EXPECT_NE(error_of([] { FilterSampler({.radius = Vec2(INFINITY)}); }).find("radius"), std::string::npos);
}

}  // namespace
}  // namespace lambert
