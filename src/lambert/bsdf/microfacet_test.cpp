#include "lambert/bsdf/microfacet.h"

#include "lambert/base/transform.h"
#include "lambert/sampling/warp.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lambert {
namespace {

struct Alpha {
  float x, y;
};
constexpr std::array alphas = {Alpha{0.1f, 0.1f}, Alpha{0.2f, 0.2f}, Alpha{0.5f, 0.5f}, Alpha{1, 1},
                               Alpha{0.15f, 0.6f}};

Vec3 direction(float cos_theta, float phi = 0.7f) {
  const float ring = std::sqrt(1 - cos_theta * cos_theta);
  return {ring * std::cos(phi), ring * std::sin(phi), cos_theta};
}

/// ∫ f dω over the upper hemisphere by midpoints in cos θ and φ, denser near the pole.
template <class F>
double integrate_hemisphere(const F& f, int n = 600) {
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = (i + 0.5) / n, cos = 1 - u * u, jacobian = 2 * u;
      const float phi = static_cast<float>(2 * std::numbers::pi * (j + 0.5) / n);
      sum += static_cast<double>(f(direction(static_cast<float>(cos), phi))) * jacobian;
    }
  return sum * 2 * std::numbers::pi / (n * n);
}

// rows: IS-69
TEST(Ggx, FacetsProjectToTheSurfacesArea) {
  for (const Alpha a : alphas) {
    const Ggx ggx(a.x, a.y);
    EXPECT_NEAR(integrate_hemisphere([&](Vec3 m) { return ggx.d(m) * m.z; }), 1, 2e-3) << a.x << " " << a.y;
  }
}

// What is visible from w projects to the surface seen from w: ∫ G1(w) max(0, w.m) D(m) dm = cos θw (Heitz 2014, eq.
// 14).
TEST(Ggx, MaskingKeepsTheProjectedArea) {
  for (const Alpha a : alphas) {
    const Ggx ggx(a.x, a.y);
    for (const float cos : {1.0f, 0.7f, 0.3f, 0.05f}) {
      const Vec3 w = direction(cos);
      const auto seen = [&](Vec3 m) { return ggx.g1(w) * std::max(0.0f, dot(w, m)) * ggx.d(m); };
      EXPECT_NEAR(integrate_hemisphere(seen) / static_cast<double>(cos), 1, 5e-3) << a.x << " " << a.y << " at " << cos;
    }
  }
}

TEST(Ggx, PeakAndLimits) {
  EXPECT_NEAR(Ggx(0.5f, 0.2f).d({0, 0, 1}), 1 / (pi * 0.1f), 1e-4f);
  EXPECT_EQ(Ggx(0.5f, 0.5f).d({0.6f, 0, -0.8f}), 0) << "no facet looks down";
  const Ggx ggx(0.3f, 0.3f);
  EXPECT_EQ(ggx.g1({0, 0, 1}), 1);
  EXPECT_EQ(ggx.g1({1, 0, 0}), 0);
  EXPECT_GT(ggx.g2(direction(0.3f), direction(0.4f)), ggx.g1(direction(0.3f)) * ggx.g1(direction(0.4f)))
      << "heights are correlated";
}

// Walter et al. 2007, eq. 34: G1 = 2 / (1 + sqrt(1 + α² tan² θ)).
TEST(Ggx, IsotropicMaskingIsWalters) {
  for (const float cos : {0.9f, 0.5f, 0.1f}) {
    const float tan2 = 1 / (cos * cos) - 1;
    for (const float alpha : {0.1f, 0.5f, 1.0f})
      EXPECT_NEAR(Ggx(alpha, alpha).g1(direction(cos)), 2 / (1 + std::sqrt(1 + alpha * alpha * tan2)), 1e-5f);
  }
}

TEST(Ggx, AlongXOnlyTheRoughnessOfXCounts) {
  const Vec3 w = direction(0.3f, 0);
  EXPECT_NEAR(Ggx(0.4f, 0.05f).lambda(w), Ggx(0.4f, 0.4f).lambda(w), 1e-5f);
  EXPECT_GT(Ggx(0.4f, 0.05f).d(direction(0.9f, 0)), Ggx(0.4f, 0.05f).d(direction(0.9f, pi / 2)));
}

// rows: PT-29
TEST(Ggx, VisibleNormalsFollowTheirDensity) {
  const Transform turn = Transform::rotate(degrees(35), {1, 2, 3}), back = turn.inverse();
  constexpr std::array cosines = {1.0f, 0.6f, 0.1f, 0.01f};
  for (const Alpha a : alphas)
    for (const float cos : cosines) {
      const Ggx ggx(a.x, a.y);
      const Vec3 w = direction(cos);
      const auto sample = [&](Vec2 u, float) { return std::optional(turn.vector(ggx.sample_visible(w, u))); };
      const auto pdf = [&](Vec3 m) { return static_cast<double>(ggx.visible_d(w, back.vector(m))); };
      const auto result = statistics::chi_square_sphere(
          sample, pdf,
          {.samples = 40000, .subdivisions = 16, .tests = static_cast<int>(alphas.size() * cosines.size())});
      EXPECT_TRUE(result) << a.x << " " << a.y << " at " << cos << ": " << result.message;
    }
}

}  // namespace
}  // namespace lambert
