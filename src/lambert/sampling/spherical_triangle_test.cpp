#include "lambert/sampling/spherical_triangle.h"

#include "lambert/sampling/sampling_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace lambert {
namespace {

struct Case {
  Vec3 from;
  std::array<Vec3, 3> v;
  SphericalTriangle triangle() const { return {from, v}; }
  Vec3d at(double b, double c) const {
    return Vec3d(v[0]) + b * (Vec3d(v[1]) - Vec3d(v[0])) + c * (Vec3d(v[2]) - Vec3d(v[0]));
  }
  double exact() const { return exact_solid_angle(Vec3d(from), Vec3d(v[0]), Vec3d(v[1]), Vec3d(v[2])); }
  /// Barycentric coordinates of where the direction meets the triangle's plane (Cramer's rule).
  Vec2d meet(Vec3d w) const {
    const Vec3d e1 = Vec3d(v[1]) - Vec3d(v[0]), e2 = Vec3d(v[2]) - Vec3d(v[0]), s = Vec3d(from) - Vec3d(v[0]);
    const double det = glm::dot(e1, glm::cross(w, e2));
    return {glm::dot(s, glm::cross(w, e2)) / det, glm::dot(w, glm::cross(s, e1)) / det};
  }
};

const std::array<Case, 6> cases = {{
    {{0, 0, 0}, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}},
    {{0, 0, 0}, {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 0)}},  // the other way round
    {{0.3f, 0.2f, 0.1f}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}},
    {{4, -2, 1}, {Vec3(0, 0, 0), Vec3(1, 0, 0.2f), Vec3(0.3f, 1, 0)}},
    {{0, 0, 2}, {Vec3(-3, -0.1f, 0), Vec3(3, -0.1f, 0), Vec3(0, 0.1f, 0)}},  // long and thin
    {{0.3f, 0.3f, 0.01f}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}},    // almost a hemisphere
}};

TEST(SphericalTriangle, SolidAngleInClosedForm) {
  EXPECT_NEAR(cases[0].triangle().solid_angle(), pi / 2, 1e-6f) << "an octant";
  EXPECT_NEAR(cases[1].triangle().solid_angle(), pi / 2, 1e-6f);
  EXPECT_NEAR(SphericalTriangle(Vec3(0), {Vec3(-1, -1, 1), Vec3(1, -1, 1), Vec3(1, 1, 1)}).solid_angle(), 4 * pi / 12,
              1e-6f)
      << "half a face of a cube";
  for (const Case& c : cases)
    EXPECT_NEAR(static_cast<double>(c.triangle().solid_angle()) / c.exact(), 1, 1e-5) << c.exact();
}

// Far triangles: E = A cos / r² to first order.
TEST(SphericalTriangle, SmallSolidAnglesKeepTheirDigits) {
  for (const float distance : {10.0f, 100.0f, 1000.0f}) {
    const Case c{{0, 0, distance}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}};
    EXPECT_NEAR(static_cast<double>(c.triangle().solid_angle()) / c.exact(), 1,
                5e-7 * static_cast<double>(distance) + 1e-6)
        << distance;
  }
}

// Barycentric coordinates are cut into triangles; each must get its share of the solid angle.
TEST(SphericalTriangle, IsSampledUniformlyBySolidAngle) {
  constexpr int side = 6, n = 40000;
  for (const Case& c : cases) {
    const SphericalTriangle t = c.triangle();
    std::array<double, side * side * 2> observed{}, expected{};
    TestNumbers random(2);
    for (int i = 0; i < n; ++i) {
      const Vec3 w = t.sample(random.pair());
      ASSERT_NEAR(length(w), 1, 1e-5f);
      const Vec2d b = glm::clamp(c.meet(Vec3d(w)), 0.0, 0.999999) * static_cast<double>(side);
      const int x = static_cast<int>(b.x), y = std::min(static_cast<int>(b.y), side - 1 - x);
      const bool upper = b.x - x + b.y - y > 1 && x + y < side - 1;
      ++observed[static_cast<std::size_t>(2 * (y * side + x) + upper)];
    }
    for (int y = 0; y < side; ++y)
      for (int x = 0; x + y < side; ++x) {
        const auto corner = [&](int i, int j) {
          return c.at(static_cast<double>(x + i) / side, static_cast<double>(y + j) / side);
        };
        const auto share = [&](Vec3d p, Vec3d q, Vec3d r) {
          return n * exact_solid_angle(Vec3d(c.from), p, q, r) / c.exact();
        };
        const auto cell = static_cast<std::size_t>(2 * (y * side + x));
        expected[cell] = share(corner(0, 0), corner(1, 0), corner(0, 1));
        if (x + y < side - 1) expected[cell + 1] = share(corner(1, 0), corner(1, 1), corner(0, 1));
      }
    const auto result = statistics::chi_square(observed, expected, cases.size());
    EXPECT_TRUE(result) << c.exact() << ": " << result.message;
  }
}

TEST(SphericalTriangle, SamplesLieInside) {
  for (const Case& c : cases)
    for (const float x : {0.0f, 0.01f, 0.5f, one_minus_epsilon})
      for (const float y : {0.0f, 0.01f, 0.5f, one_minus_epsilon}) {
        const Vec2d b = c.meet(Vec3d(c.triangle().sample({x, y})));
        EXPECT_TRUE(b.x > -2e-3 && b.y > -2e-3 && b.x + b.y < 1 + 2e-3) << b.x << " " << b.y;
      }
}

TEST(SphericalTriangle, ForwardAndInverseUndoEachOther) {
  for (const Case& c : cases) {
    const SphericalTriangle t = c.triangle();
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const Vec2 u((static_cast<float>(i) + 0.3f) / 20, (static_cast<float>(j) + 0.6f) / 20);
        EXPECT_LT(length(t.to_square(t.sample(u)) - u), 5e-4f) << c.exact() << " at " << u.x << " " << u.y;
      }
  }
}

TEST(SphericalTriangle, DegenerateOnesStayFinite) {
  const std::array<Case, 5> degenerate = {{
      {{3, 0.5f, 0}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}},  // seen edge-on
      {{0, 0, 1}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}},     // a needle
      {{0, 0, 1}, {Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0)}},     // a point
      {{0, 0, 0}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}},     // from a vertex
      {{0, 0, 1e4f}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}},  // 5e-9 sr
  }};
  for (const Case& c : degenerate) {
    const SphericalTriangle t = c.triangle();
    EXPECT_TRUE(t.solid_angle() >= 0 && t.solid_angle() < 1e-6f) << t.solid_angle();
    if (t.solid_angle() == 0) continue;
    for (const float x : {0.0f, 0.5f, one_minus_epsilon})
      for (const float y : {0.0f, 0.5f, one_minus_epsilon}) EXPECT_NEAR(length(t.sample({x, y})), 1, 1e-5f);
  }
}

}  // namespace
}  // namespace lambert
