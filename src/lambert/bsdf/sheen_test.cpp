#include "lambert/bsdf/sheen.h"

#include <gtest/gtest.h>

#include <numbers>

namespace lambert {
namespace {

Vec3 direction(float cos_theta, float phi = 0) {
  const float ring = std::sqrt(1 - cos_theta * cos_theta);
  return {ring * std::cos(phi), ring * std::sin(phi), cos_theta};
}

// ∫ D cos = 1: D is read off the value where wo = wi = h, D = f 4 (2 cos - cos²).
TEST(Sheen, ItsDistributionIsNormalised) {
  for (const float roughness : {0.2f, 0.5f, 1.0f}) {
    double sum = 0;
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i) {
      const float c = (static_cast<float>(i) + 0.5f) / n;
      const Vec3 h = direction(c);
      sum += static_cast<double>(sheen_value(h, h, roughness) * 4 * (2 * c - c * c) * c * 2 * pi / n);
    }
    EXPECT_NEAR(sum, 1, 2e-3) << roughness;
  }
}

// rows: IS-80
TEST(Sheen, IsReciprocal) {
  const Vec3 a = direction(0.3f, 1), b = direction(0.8f, 2.5f);
  EXPECT_FLOAT_EQ(sheen_value(a, b, 0.4f), sheen_value(b, a, 0.4f));
}

TEST(Sheen, ShinesAtTheRimAndNotStraightOn) {
  EXPECT_NEAR(sheen_value({0, 0, 1}, {0, 0, 1}, 0.3f), 0, 1e-6f);
  EXPECT_GT(sheen_value(direction(0.1f), direction(0.1f), 0.3f), 1);
}

// h at 45° and roughness 1: D = 3 / (2π sqrt(2)), over 4 (1 + 0 - 0) for a grazing wi.
TEST(Sheen, AValueByHand) {
  EXPECT_NEAR(sheen_value({0, 0, 1}, {1, 0, 0}, 1), 3 / (2 * pi * std::numbers::sqrt2_v<float>) / 4, 1e-5f);
}

}  // namespace
}  // namespace lambert
