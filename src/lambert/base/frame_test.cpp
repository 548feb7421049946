#include "lambert/base/frame.h"

#include "lambert/base/hash.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

void expect_right_handed_orthonormal(const Frame& f) {
  EXPECT_NEAR(length(f.s), 1, 5e-6);
  EXPECT_NEAR(length(f.t), 1, 5e-6);
  EXPECT_NEAR(length(f.n), 1, 5e-6);
  EXPECT_NEAR(dot(f.s, f.n), 0, 5e-6);
  EXPECT_LT(length(cross(f.s, f.t) - f.n), 5e-6f);
}

std::vector<Vec3> directions() {
  std::vector<Vec3> all = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, -0.0f}, {1e-4f, 0, -1}};
  all[4] = normalize(Vec3(1, 1, -0.0f));
  for (int i = 0; i < 1000; ++i) {
    const auto number = [i](int k) { return hash_to_float(hash_values(i, k)) - 0.5f; };
    all.push_back({number(0), number(1), number(2)});
  }
  for (Vec3& d : all) d = normalize(d);
  return all;
}

TEST(Frame, IsRightHandedAndOrthonormalForEveryNormal) {
  for (const Vec3 n : directions()) {
    expect_right_handed_orthonormal(Frame(n));
    EXPECT_EQ(Frame(n).n, n);
  }
}

TEST(Frame, LocalAndWorldAreInverse) {
  const Vec3 v(0.3f, -2, 5);
  for (const Vec3 n : directions()) {
    const Frame f(n);
    EXPECT_LT(length(f.to_world(f.to_local(v)) - v), 1e-5f);
    EXPECT_LT(length(f.to_local(n) - Vec3(0, 0, 1)), 5e-6f);
  }
}

TEST(Frame, FromTangentTurnsSTowardsIt) {
  const Vec3 tangent(1, 2, -0.5f);
  for (const Vec3 n : directions()) {
    const Frame f = Frame::from_tangent(n, tangent);
    expect_right_handed_orthonormal(f);
    EXPECT_GT(dot(f.s, tangent), 0);
    EXPECT_NEAR(dot(f.t, tangent), 0, 1e-4);
  }
}

TEST(Frame, FromNearlyParallelTangentIsStillOrthonormal) {
  for (const Vec3 n : directions())
    for (const float sine : {1e-1f, 1e-2f, 1e-3f, 1e-4f, 1e-5f})
      expect_right_handed_orthonormal(Frame::from_tangent(n, n + sine * Frame(n).t));
}

TEST(Frame, ParallelOrMissingTangentGivesAnyFrame) {
  for (const Vec3 n : directions()) {
    expect_right_handed_orthonormal(Frame::from_tangent(n, 3.0f * n));
    expect_right_handed_orthonormal(Frame::from_tangent(n, Vec3(0)));
  }
}

}  // namespace
}  // namespace lambert
