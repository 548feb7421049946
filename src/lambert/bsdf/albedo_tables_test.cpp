#include "lambert/bsdf/albedo_tables.h"

#include "lambert/base/hash.h"
#include "lambert/bsdf/fresnel.h"
#include "lambert/bsdf/microfacet.h"
#include "lambert/bsdf/sheen.h"
#include "lambert/sampling/warp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

Vec3 direction(float cos_theta) { return {std::sqrt(1 - cos_theta * cos_theta), 0, cos_theta}; }
constexpr int side = 300;
Vec2 cell(int i) {
  return {(static_cast<float>(i % side) + 0.5f) / side, (static_cast<float>(i / side) + 0.5f) / side};
}

/// Off the table's nodes, by directions instead of facets.
float ggx_reference(float cos, float alpha, float f0, float f90) {
  const Ggx ggx(alpha, alpha);
  const Vec3 wo = direction(cos);
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const Vec3 wi = square_to_uniform_hemisphere(cell(i)), h = normalize(wo + wi);
    const float f = f0 + (f90 - f0) * schlick_weight(dot(wo, h));
    sum += static_cast<double>(f * ggx.d(h) * ggx.g2(wo, wi) / (4 * wo.z));
  }
  return static_cast<float>(sum * 2 * std::numbers::pi / (side * side));
}

TEST(AlbedoTables, GgxIsTheIntegral) {
  for (const float alpha : {0.15f, 0.37f, 0.8f})
    for (const float cos : {0.97f, 0.55f, 0.21f}) {
      EXPECT_NEAR(ggx_albedo(cos, alpha)(1, 1), ggx_reference(cos, alpha, 1, 1), 0.01f) << alpha << " " << cos;
      EXPECT_NEAR(ggx_albedo(cos, alpha)(0.04f, 1), ggx_reference(cos, alpha, 0.04f, 1), 0.01f) << alpha << " " << cos;
    }
}

TEST(AlbedoTables, SmoothFacetsLoseNothing) {
  for (const float cos : {1.0f, 0.5f, 0.2f}) {
    EXPECT_NEAR(ggx_albedo(cos, 0.001f)(1, 1), 1, 5e-3f) << cos;
    EXPECT_NEAR(ggx_albedo(cos, 0.001f)(0.04f, 1), fresnel_schlick(cos, Rgb(0.04f), Rgb(1)).r, 0.01f) << cos;
  }
  // ∫ (f0 + (1 - f0) (1 - c)^5) 2 c dc = f0 + (1 - f0) / 21.
  EXPECT_NEAR(ggx_mean_albedo(0.001f)(0.04f, 1), 0.04f + 0.96f / 21, 3e-3f);
}

TEST(AlbedoTables, MeansAreMeans) {
  for (const float alpha : {0.1f, 0.5f, 0.9f}) {
    double sum = 0;
    for (int i = 0; i < side; ++i) {
      const float c = (static_cast<float>(i) + 0.5f) / side;
      sum += static_cast<double>(ggx_albedo(c, alpha)(0.5f, 1) * 2 * c / side);
    }
    EXPECT_NEAR(ggx_mean_albedo(alpha)(0.5f, 1), sum, 3e-3) << alpha;
  }
}

TEST(AlbedoTables, SheenIsTheIntegral) {
  for (const float roughness : {0.3f, 0.5f, 0.9f})
    for (const float cos : {0.97f, 0.55f, 0.21f}) {
      double sum = 0;
      for (int i = 0; i < side * side; ++i) {
        const Vec3 wi = square_to_uniform_hemisphere(cell(i));
        sum += static_cast<double>(sheen_value(direction(cos), wi, roughness) * wi.z);
      }
      const double exact = std::min(1.0, sum * 2 * std::numbers::pi / (side * side));
      EXPECT_NEAR(sheen_albedo(cos, roughness), exact, 0.015) << roughness << " " << cos;
    }
}

// rows: IS-79
TEST(AlbedoTables, NeverAboveOne) {
  for (float cos = 0; cos <= 1; cos += 0.05f)
    for (float roughness = 0; roughness <= 1; roughness += 0.05f) {
      EXPECT_LE(sheen_albedo(cos, roughness), 1);
      EXPECT_LE(ggx_albedo(cos, roughness)(1, 1), 1.0001f);
      EXPECT_GE(ggx_albedo(cos, roughness).bias, 0);
    }
}

}  // namespace
}  // namespace lambert
