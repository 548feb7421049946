#include "lambert/geometry/shape_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

constexpr Cylinder example{.radius = 1, .z_min = 0, .z_max = 4, .caps = true};

// rows: PG-61 PG-70
TEST(Cylinder, WorkedExample) {  // V-PG-50
  const auto t = [](Vec3 origin, Vec3 d) { return example.intersect({.origin = origin, .direction = d}); };
  const auto body = t({-3, 0, -1}, {0.707106781187f, 0, 0.707106781187f});
  ASSERT_TRUE(body);
  EXPECT_NEAR(body->t, 2.82842712475, 1e-6);
  EXPECT_LT(length(body->position - Vec3(-1, 0, 1)), 1e-6f);
  EXPECT_LT(length(body->normal - Vec3(-1, 0, 0)), 1e-6f);
  const auto level = t({-3, 0, 2}, {1, 0, 0});
  ASSERT_TRUE(level);
  EXPECT_EQ(level->t, 2);
  const auto top = t({0.5f, 0, 9}, {0, 0, -1});
  ASSERT_TRUE(top);
  EXPECT_EQ(top->t, 5);
  EXPECT_EQ(top->normal, Vec3(0, 0, 1));
  EXPECT_FALSE(t({-3, 0, 5}, {1, 0, 0}));
  EXPECT_FALSE(t({2, 0, 9}, {0, 0, -1}));
}

// rows: PG-70
TEST(Cylinder, RaysThatRunInASurface) {
  // In the wall: the quadratic has no term in t² (E-PG-25), and the rims of the caps are met.
  const Ray in_wall{.origin = {1, 0, 9}, .direction = {0, 0, -1}};
  EXPECT_EQ(all_hits(example, in_wall).size(), 2u);
  EXPECT_EQ(example.intersect(in_wall)->t, 5);
  Cylinder open = example;
  open.caps = false;
  EXPECT_FALSE(open.intersect(in_wall));
  // In the plane of a cap: the wall's rim is met.
  const Ray in_cap{.origin = {-3, 0, 4}, .direction = {1, 0, 0}};
  EXPECT_EQ(example.intersect(in_cap)->t, 2);
  EXPECT_EQ(example.intersect(in_cap)->normal, Vec3(-1, 0, 0));
  // Along the axis: both caps, and nothing when there are none.
  const Ray on_axis{.origin = {0, 0, -1}, .direction = {0, 0, 1}};
  EXPECT_EQ(all_hits(example, on_axis).size(), 2u);
  EXPECT_EQ(example.intersect(on_axis)->normal, Vec3(0, 0, -1));
  EXPECT_FALSE(open.intersect(on_axis));
}

TEST(Cylinder, ClosedBodyHasNoGapAtItsRims) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const float phi = random.between(0, 2 * pi);
    const Vec3 rim(std::cos(phi), std::sin(phi), i % 2 ? 4.0f : 0.0f), inside(0.1f, -0.2f, 2);
    const Ray out{.origin = inside, .direction = rim - inside};
    ASSERT_TRUE(example.intersect(out)) << phi;
  }
}

TEST(Cylinder, AreaOfBodyAndCaps) {
  EXPECT_FLOAT_EQ(example.area(), 2 * pi * 4 + 2 * pi);
  EXPECT_FLOAT_EQ((Cylinder{.radius = 2, .z_min = 0, .z_max = 3, .phi_max = 1}.area()), 6);
}

}  // namespace
}  // namespace lambert
