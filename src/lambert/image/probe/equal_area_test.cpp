#include "lambert/image/probe/octahedral.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

TEST(EqualArea, KnowsItsPoles) {
  EXPECT_NEAR(equal_area_square_to_sphere({0.5f, 0.5f}).z, 1, 1e-6f);
  EXPECT_NEAR(equal_area_square_to_sphere({0, 0}).z, -1, 1e-6f);
  EXPECT_NEAR(equal_area_square_to_sphere({1, 0.5f}).x, 1, 1e-6f);
  EXPECT_NEAR(equal_area_square_to_sphere({0.5f, 0}).y, -1, 1e-6f);
}

TEST(EqualArea, ForwardAndInverseUndoEachOther) {
  for (int i = 0; i < 400; ++i) {
    const Vec2 uv((static_cast<float>(i % 20) + 0.37f) / 20, (static_cast<float>(i) / 20 + 0.41f) / 21);
    const Vec3 d = equal_area_square_to_sphere(uv);
    EXPECT_NEAR(length(d), 1, 1e-5f);
    const Vec2 back = equal_area_sphere_to_square(d);
    EXPECT_NEAR(back.x, uv.x, 2e-4f);
    EXPECT_NEAR(back.y, uv.y, 2e-4f);
  }
}

// |∂d/∂u × ∂d/∂v| = 4π everywhere.
TEST(EqualArea, KeepsAreas) {
  constexpr float h = 1e-3f;
  for (int i = 0; i < 100; ++i) {
    const Vec2 uv((static_cast<float>(i % 10) + 0.43f) / 10, (static_cast<float>(i) / 10 + 0.17f) / 10.5f);
    const Vec3 du = equal_area_square_to_sphere(uv + Vec2(h, 0)) - equal_area_square_to_sphere(uv - Vec2(h, 0));
    const Vec3 dv = equal_area_square_to_sphere(uv + Vec2(0, h)) - equal_area_square_to_sphere(uv - Vec2(0, h));
    EXPECT_NEAR(length(cross(du, dv)) / (4 * h * h), 4 * pi, 0.15f) << uv.x << " " << uv.y;
  }
}

}  // namespace
}  // namespace lambert::probe
