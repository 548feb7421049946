#include "lambert/bsdf/layered_interface.h"

#include "lambert/bsdf/coated_diffuse.h"
#include "lambert/bsdf/dielectric.h"
#include "lambert/bsdf/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

Vec3 direction(float cos_theta, float phi = 0.7f) {
  const float ring = std::sqrt(1 - cos_theta * cos_theta);
  return {ring * std::cos(phi), ring * std::sin(phi), cos_theta};
}

// The coat's outside reflects as a dielectric does; the dielectric chooses reflection by Fresnel, the coat always.
TEST(CoatInterface, ReflectsLikeADielectric) {
  const CoatInterface coat{1.5f, 0.2f, 0.4f};
  const Dielectric glass{1.5f, 0.2f, 0.4f};
  for (const float cos : {0.9f, 0.4f, 0.1f}) {
    const Vec3 wo = direction(cos), wi = direction(0.5f, 3);
    const float f = fresnel_dielectric(dot(wo, normalize(wo + wi)), 1.5f);
    EXPECT_NEAR(coat.eval(wo, wi), glass.eval(wo, wi, Transport::radiance).g, 1e-4f * coat.eval(wo, wi));
    EXPECT_NEAR(coat.pdf(wo, wi) * f, glass.pdf(wo, wi), 1e-4f * coat.pdf(wo, wi));
  }
}

TEST(CoatInterface, ASmoothOneIsAMirror) {
  const CoatInterface coat{1.5f, 0, 0};
  const Vec3 wo = direction(0.3f);
  EXPECT_TRUE(coat.is_smooth());
  EXPECT_EQ(*coat.sample(wo, Vec2(0.2f)), Vec3(-wo.x, -wo.y, wo.z));
  EXPECT_EQ(coat.eval(wo, direction(0.3f, 0.7f + pi)), 0);
  EXPECT_EQ(coat.pdf(wo, wo), 0);
  EXPECT_FLOAT_EQ(coat.fresnel(wo), fresnel_dielectric(0.3f, 1.5f));
}

// A coat of the index around it is none: what is left is the diffuse base.
TEST(CoatInterface, WithoutABorderTheBaseIsBare) {
  const Rgb base(0.8f, 0.3f, 0.1f);
  const CoatedDiffuse bare(base, 1, 0.3f, 0.3f);
  const Vec3 wo = direction(0.5f), wi = direction(0.7f, 2);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(bare.eval(wo, wi, Transport::radiance)[i], base[i] * inv_pi * wi.z, 1e-5f);
}

TEST(CoatInterface, NothingOnNothingHasNoDensity) {
  const CoatedDiffuse black(Rgb(0), 1, 0.3f, 0.3f);
  EXPECT_TRUE(std::isfinite(black.pdf(direction(0.5f), direction(0.7f, 2))));
}

}  // namespace
}  // namespace lambert
