#include "lambert/bsdf/fresnel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace lambert {
namespace {

float cos_of(double degrees) { return static_cast<float>(std::cos(degrees * std::numbers::pi / 180)); }

/// Fresnel's equations for amplitudes, with complex numbers.
double exact_reflectance(double cos_i, std::complex<double> n) {
  const std::complex<double> cos_t = std::sqrt(1.0 - (1 - cos_i * cos_i) / (n * n));
  const auto parallel = (n * cos_i - cos_t) / (n * cos_i + cos_t),
             perpendicular = (cos_i - n * cos_t) / (cos_i + n * cos_t);
  return 0.5 * (std::norm(parallel) + std::norm(perpendicular));
}

// rows: IS-73
// V-IS-31: crown glass.
TEST(Fresnel, CrownGlass) {
  const std::array degrees = {0.0, 45.0, 56.6593, 80.0};
  const std::array expected = {0.0425799949609, 0.0530452321029, 0.0783460261306, 0.390949863386};
  for (std::size_t i = 0; i < degrees.size(); ++i)
    EXPECT_NEAR(fresnel_dielectric(cos_of(degrees[i]), 1.52f), expected[i], 1e-5) << degrees[i];
}

TEST(Fresnel, NormalAndGrazingIncidence) {
  for (const float eta : {1.0f, 1.31f, 1.5f, 2.42f, 1 / 1.5f}) {
    const float normal = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
    EXPECT_NEAR(fresnel_dielectric(1, eta), normal, 1e-6f);
    EXPECT_NEAR(fresnel_dielectric(-1, eta), normal, 1e-6f) << "from inside";
    EXPECT_NEAR(f0_of_eta(eta), normal, 1e-6f);
  }
  EXPECT_NEAR(fresnel_dielectric(1e-6f, 1.5f), 1, 1e-4f);
  EXPECT_NEAR(eta_of_f0(f0_of_eta(1.7f)), 1.7f, 1e-5f);
}

// At Brewster's angle, tan θ = η, only the perpendicular half reflects: sin²(θ - θt) / 2 with θ + θt = 90°.
TEST(Fresnel, BrewstersAngle) {
  for (const double eta : {1.33, 1.5, 2.42}) {
    const double angle = std::atan(eta), turned = std::sin(2 * angle - std::numbers::pi / 2);
    EXPECT_NEAR(fresnel_dielectric(static_cast<float>(std::cos(angle)), static_cast<float>(eta)), 0.5 * turned * turned,
                1e-6);
  }
}

// rows: IS-50
// V-IS-21: critical angles into vacuum.
TEST(Fresnel, TotalReflectionBeyondTheCriticalAngle) {
  const std::array etas = {1.31f, 1.333f, 1.52f, 1.66f, 2.42f};
  const std::array critical = {49.7612018741, 48.6066263917, 41.1395104149, 37.0426709284, 24.407468918};
  for (std::size_t i = 0; i < etas.size(); ++i) {
    const float beyond = cos_of(critical[i] + 0.02), before = cos_of(critical[i] - 0.02);
    EXPECT_EQ(fresnel_dielectric(-beyond, etas[i]), 1);
    EXPECT_LT(fresnel_dielectric(-before, etas[i]), 0.95f);
    const auto at = [](float cos) { return Vec3(std::sqrt(1 - cos * cos), 0, cos); };
    EXPECT_FALSE(refract(at(beyond), {0, 0, 1}, 1 / etas[i]));
    EXPECT_TRUE(refract(at(before), {0, 0, 1}, 1 / etas[i]));
  }
}

// What passes a border one way passes it the other way along the same path.
TEST(Fresnel, BothSidesAgreeAlongARefractedPath) {
  for (const float cos : {0.95f, 0.6f, 0.2f}) {
    const auto t = refract({std::sqrt(1 - cos * cos), 0, cos}, {0, 0, 1}, 1.5f);
    ASSERT_TRUE(t);
    EXPECT_NEAR(t->x, -std::sqrt(1 - cos * cos) / 1.5f, 1e-6f) << "Snell";
    EXPECT_NEAR(length(*t), 1, 1e-6f);
    EXPECT_NEAR(fresnel_dielectric(cos, 1.5f), fresnel_dielectric(t->z, 1.5f), 1e-5f);
  }
}

// rows: IS-73
TEST(Fresnel, ConductorsAreFresnelsEquationsForAComplexIndex) {
  struct Index {
    double eta, k;
  };
  for (const Index n : {Index{0.143, 3.983}, {1.442, 1.603}, {1.3456, 7.4746}, {0.2, 0.1}, {1.5, 0}}) {
    for (const double cos : {1.0, 0.8, 0.5, 0.2, 0.05, 0.001}) {
      const Rgb r =
          fresnel_conductor(static_cast<float>(cos), Rgb(static_cast<float>(n.eta)), Rgb(static_cast<float>(n.k)));
      EXPECT_NEAR(r.g, exact_reflectance(cos, {n.eta, n.k}), 2e-4) << n.eta << " + i" << n.k << " at " << cos;
      EXPECT_EQ(r.r, r.b);
    }
  }
  EXPECT_NEAR(fresnel_conductor(0, Rgb(0.2f), Rgb(3)).r, 1, 1e-6f) << "grazing";
}

// Johnson and Christy 1972 (gold) and Rakić 1995 (aluminium), as indices near 650, 550 and 450 nm.
TEST(Fresnel, GoldIsYellowAndAluminiumWhite) {
  const Rgb gold = fresnel_conductor(1, {0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f});
  EXPECT_NEAR(gold.r, 0.966f, 5e-3f);
  EXPECT_NEAR(gold.g, 0.80f, 1e-2f);
  EXPECT_NEAR(gold.b, 0.325f, 1e-2f);
  const Rgb aluminium = fresnel_conductor(1, {1.3456f, 0.9654f, 0.6172f}, {7.4746f, 6.3995f, 5.3031f});
  EXPECT_NEAR(aluminium.g, 0.914f, 5e-3f);
  EXPECT_NEAR(aluminium.r, aluminium.b, 0.01f);
}

TEST(Fresnel, KOfAReflectanceReflectsIt) {
  const Rgb wanted(0.1f, 0.5f, 0.95f), got = fresnel_conductor(1, Rgb(1), conductor_k_of_reflectance(wanted));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], wanted[i], 1e-5f);
}

// Egan and Hilgeman 1973: 9.2 % outside and 59.6 % inside for an index of 1.5; the two are tied by
// η² (1 - inside) = 1 - outside.
TEST(Fresnel, DiffuseLight) {
  EXPECT_NEAR(diffuse_fresnel(1.5f), 0.0918f, 5e-4f);
  EXPECT_NEAR(diffuse_fresnel(1 / 1.5f), 0.5963f, 5e-4f);
  for (const float eta : {1.1f, 1.33f, 2.0f})
    EXPECT_NEAR(eta * eta * (1 - diffuse_fresnel(1 / eta)), 1 - diffuse_fresnel(eta), 2e-3f) << eta;
}

}  // namespace
}  // namespace lambert
