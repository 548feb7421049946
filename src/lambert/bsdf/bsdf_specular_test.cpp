/// Models that scatter by Dirac lobes alone, against Fresnel's equations.

#include "lambert/base/hash.h"
#include "lambert/bsdf/any_bsdf.h"
#include "lambert/bsdf/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

Vec3 direction(float cos_theta, float phi = 0.7f) {
  const float ring = std::sqrt(1 - cos_theta * cos_theta);
  return {ring * std::cos(phi), ring * std::sin(phi), cos_theta};
}

/// Frequency of transmission, and the one sample of each kind.
struct Split {
  double transmitted = 0;
  std::optional<BsdfSample> reflection, transmission;
};
Split split(const Bsdf& bsdf, Vec3 wo, Transport mode = Transport::radiance) {
  Split s;
  constexpr int n = 40000;
  for (int i = 0; i < n; ++i) {
    const auto sample = bsdf.sample(wo, hash_to_float(hash_values(i, 3)), Vec2(0.3f), mode);
    if (!sample) continue;
    EXPECT_TRUE(sample->specular);
    if (sample->transmitted) s.transmitted += 1.0 / n;
    (sample->transmitted ? s.transmission : s.reflection) = sample;
  }
  return s;
}

void expect_near(Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), 1e-5f) << a.x << " " << a.y << " " << a.z; }

// rows: IS-49 IS-73
// 1e-2 is four standard errors of 40000 draws at the worst.
TEST(SpecularBsdf, GlassSplitsByFresnel) {
  const Bsdf glass = Dielectric{1.5f, 0, 0};
  for (const float cos : {1.0f, 0.6f, 0.2f, -0.9f, -0.8f}) {
    const Vec3 wo = direction(cos);
    const float eta = cos > 0 ? 1.5f : 1 / 1.5f, r = fresnel_dielectric(cos, 1.5f);
    const Split s = split(glass, wo);
    EXPECT_NEAR(s.transmitted, 1 - static_cast<double>(r), 1e-2) << cos;
    ASSERT_TRUE(s.transmission && s.reflection);
    expect_near(s.reflection->wi, {-wo.x, -wo.y, wo.z});
    expect_near({eta * s.transmission->wi.x, eta * s.transmission->wi.y, 0}, {-wo.x, -wo.y, 0});
    EXPECT_LT(s.transmission->wi.z * wo.z, 0);
    EXPECT_FLOAT_EQ(s.transmission->eta, eta);
    EXPECT_FLOAT_EQ(s.reflection->weight.g, 1);
    EXPECT_FLOAT_EQ(s.transmission->weight.g, 1 / (eta * eta)) << "radiance";
    EXPECT_FLOAT_EQ(split(glass, wo, Transport::importance).transmission->weight.g, 1);
  }
}

// rows: IS-50
TEST(SpecularBsdf, GlassReflectsTotallyBeyondTheCriticalAngle) {
  for (const Bsdf& glass : {Bsdf(Dielectric{1.5f, 0, 0}),
                            Bsdf(GltfPbr{.alpha_x = 0, .alpha_y = 0, .transmission = 1, .thin_walled = false})}) {
    const Split s = split(glass, direction(-0.7f));
    EXPECT_FALSE(s.transmission);
    ASSERT_TRUE(s.reflection);
    EXPECT_NEAR(s.reflection->weight.g, 1, 1e-4f);
  }
}

// The series over all reflections inside: R' = R + T² R (1 + R² + ...).
TEST(SpecularBsdf, APaneSumsItsInnerReflections) {
  for (const float cos : {1.0f, 0.5f, -0.2f}) {
    const Vec3 wo = direction(cos);
    const double r = static_cast<double>(fresnel_dielectric(std::abs(cos), 1.5f));
    double reflected = r;
    for (double inside = r; inside > 1e-9; inside *= r * r) reflected += (1 - r) * (1 - r) * inside;
    const Split s = split(ThinDielectric{1.5f}, wo);
    EXPECT_NEAR(s.transmitted, 1 - reflected, 1e-2) << cos;
    expect_near(s.transmission->wi, -wo);
    EXPECT_FLOAT_EQ(s.transmission->eta, 1);
  }
}

TEST(SpecularBsdf, AMirrorReflectsFresnel) {
  const Conductor gold{.eta = {0.143f, 0.375f, 1.442f}, .k = {3.983f, 2.386f, 1.603f}};
  for (const float cos : {1.0f, 0.3f, -0.3f}) {
    const Vec3 wo = direction(cos);
    const Split s = split(gold, wo);
    EXPECT_EQ(s.transmitted, 0);
    expect_near(s.reflection->wi, {-wo.x, -wo.y, wo.z});
    EXPECT_EQ(s.reflection->weight, fresnel_conductor(std::abs(cos), gold.eta, gold.k));
  }
}

// A smooth coat over a smooth metal: F + T² R / (1 - F R), by the mean of the weights.
TEST(SpecularBsdf, ASmoothCoatOnAMirrorIsTheSeries) {
  const Rgb eta(0.2f, 0.9f, 1.1f), k(3, 2, 2);
  const Bsdf coated = CoatedConductor{.coat = {1.5f, 0, 0}, .metal = {eta, k, 0, 0}};
  EXPECT_TRUE(coated.is_specular());
  for (const float cos : {1.0f, 0.4f}) {
    const float f = fresnel_dielectric(cos, 1.5f), inner = std::sqrt(1 - (1 - cos * cos) / 2.25f);
    const float r = fresnel_conductor(inner, eta, k).g, exact = f + (1 - f) * (1 - f) * r / (1 - f * r);
    double sum = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
      const auto s = coated.sample(direction(cos), (static_cast<float>(i) + 0.5f) / n, Vec2(0.3f));
      if (s) sum += static_cast<double>(s->weight.g) / n;
    }
    EXPECT_NEAR(sum, exact, 1e-3) << cos;
  }
}

// A body without a border is not seen, however rough its facets.
TEST(SpecularBsdf, AnIndexOfOnePassesStraightOn) {
  for (const Bsdf& nothing :
       {Bsdf(Dielectric{1, 0.3f, 0.3f}),
        Bsdf(GltfPbr{.alpha_x = 0.3f, .alpha_y = 0.3f, .ior = 1, .transmission = 1, .thin_walled = false})}) {
    const Vec3 wo = direction(0.4f);
    const auto s = nothing.sample(wo, 0.5f, Vec2(0.3f));
    ASSERT_TRUE(s && s->transmitted && s->specular);
    expect_near(s->wi, -wo);
  }
}

}  // namespace
}  // namespace lambert
