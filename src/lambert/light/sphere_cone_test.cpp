#include "lambert/light/sphere_cone.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(SphereCone, HasTheSolidAngleOfTheSphere) {
  const auto cone = SphereCone::from({0, 0, 2}, {0, 0, 0}, 1);
  ASSERT_TRUE(cone);
  // 2π (1 - cos 30°)
  EXPECT_NEAR(1 / cone->pdf_omega(), 2 * pi * (1 - std::sqrt(0.75f)), 1e-5f);
  const auto far = SphereCone::from({1e4f, 0, 0}, {0, 0, 0}, 1);
  EXPECT_NEAR(1 / far->pdf_omega(), pi * 1e-8f, 1e-12f);
}

TEST(SphereCone, IsNotThereInside) {
  EXPECT_FALSE(SphereCone::from({0.5f, 0, 0}, {0, 0, 0}, 1));
  EXPECT_FALSE(SphereCone::from({0, 0, 0}, {0, 0, 0}, 1));
}

TEST(SphereCone, SeesTheNearSideUnderAUniformCosine) {
  const Vec3 from(0, 0, 2);
  const auto cone = SphereCone::from(from, {0, 0, 0}, 1);
  const float cos_max = std::sqrt(0.75f);
  for (int i = 0; i <= 16; ++i) {
    const float u = static_cast<float>(i) / 16;
    const Vec3 n = cone->sample_normal({u, 0.3f});
    EXPECT_NEAR(length(n), 1, 1e-5f);
    EXPECT_GE(dot(n, from - n), -1e-3f);
    EXPECT_NEAR(dot(normalize(n - from), Vec3(0, 0, -1)), 1 - u * (1 - cos_max), 1e-4f);
  }
}

}  // namespace
}  // namespace lambert
