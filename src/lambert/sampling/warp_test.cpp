#include "lambert/sampling/warp.h"

#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <ostream>
#include <vector>

namespace lambert {
namespace {

TEST(Warp, CosineAndSineOfAnOctant) {
  for (int i = -1000; i <= 1000; ++i) {
    const float x = pi / 4 * static_cast<float>(i) / 1000;
    const Vec2 cs = cos_sin_octant(x);
    EXPECT_NEAR(cs.x, std::cos(x), 0x1p-23f) << x;
    EXPECT_NEAR(cs.y, std::sin(x), 0x1p-23f) << x;
  }
}

/// A triple in one form for all: points of the plane have z = 0 and lie in origin + [0,1]² size; a size of 0 means
/// directions.
struct Warp {
  const char* name;
  Vec2 origin, size;
  std::function<Vec3(Vec2)> forward;
  std::function<Vec2(Vec3)> inverse;
  std::function<double(Vec3)> pdf;
  bool on_sphere() const { return size.x == 0; }
};

void PrintTo(const Warp& w, std::ostream* out) { *out << w.name; }

Warp of_plane(const char* name, Vec2 origin, Vec2 size, std::function<Vec2(Vec2)> forward,
              std::function<Vec2(Vec2)> inverse, std::function<float(Vec2)> pdf) {
  return {name,
          origin,
          size,
          [=](Vec2 u) { return Vec3(forward(u), 0); },
          [=](Vec3 p) { return inverse(Vec2(p)); },
          [=](Vec3 p) { return static_cast<double>(pdf(Vec2(p))); }};
}

Warp of_sphere(const char* name, std::function<Vec3(Vec2)> forward, std::function<Vec2(Vec3)> inverse,
               std::function<float(Vec3)> pdf) {
  return {name, {}, {}, forward, inverse, [=](Vec3 w) { return static_cast<double>(pdf(w)); }};
}

Warp cosine_power(const char* name, float n) {
  return of_sphere(
      name, [n](Vec2 u) { return square_to_cosine_power(u, n); }, [n](Vec3 w) { return cosine_power_to_square(w, n); },
      [n](Vec3 w) { return cosine_power_pdf(w, n); });
}

Warp cone(const char* name, float cos_theta_max) {
  return of_sphere(
      name, [=](Vec2 u) { return square_to_uniform_cone(u, cos_theta_max); },
      [=](Vec3 w) { return uniform_cone_to_square(w, cos_theta_max); },
      [=](Vec3 w) { return uniform_cone_pdf(w, cos_theta_max); });
}

std::vector<Warp> all_warps() {
  return {
      of_plane("disk_polar", Vec2(-1), Vec2(2), square_to_uniform_disk_polar, uniform_disk_polar_to_square,
               uniform_disk_pdf),
      of_plane("disk_concentric", Vec2(-1), Vec2(2), square_to_uniform_disk_concentric,
               uniform_disk_concentric_to_square, uniform_disk_pdf),
      of_sphere("sphere", square_to_uniform_sphere, uniform_sphere_to_square,
                [](Vec3) { return uniform_sphere_pdf(); }),
      of_sphere("hemisphere", square_to_uniform_hemisphere, uniform_hemisphere_to_square, uniform_hemisphere_pdf),
      of_sphere("cosine_hemisphere", square_to_cosine_hemisphere, cosine_hemisphere_to_square, cosine_hemisphere_pdf),
      cosine_power("cosine_power_0", 0),
      cosine_power("cosine_power_1", 1),
      cosine_power("cosine_power_3", 3),
      cosine_power("cosine_power_20", 20),
      cone("cone_wide", -0.3f),
      cone("cone", 0.5f),
      of_plane("triangle", Vec2(0), Vec2(1), square_to_triangle, triangle_to_square,
               [](Vec2 b) { return b.x >= 0 && b.y >= 0 && b.x + b.y <= 1 ? triangle_pdf() : 0.0f; }),
      of_plane(
          "tent", Vec2(-1, 0), Vec2(2, 1), [](Vec2 u) { return Vec2(uniform_to_tent(u.x), u.y); },
          [](Vec2 p) { return Vec2(tent_to_uniform(p.x), p.y); }, [](Vec2 p) { return tent_pdf(p.x); }),
  };
}

class EveryWarp : public testing::TestWithParam<Warp> {};
INSTANTIATE_TEST_SUITE_P(, EveryWarp, testing::ValuesIn(all_warps()), [](const auto& test) { return test.param.name; });

// rows: PT-15 PT-17 PT-19 PT-20
TEST_P(EveryWarp, ForwardAndInverseUndoEachOther) {
  const Warp& w = GetParam();
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 40; ++i) {
      const Vec2 u((static_cast<float>(i) + 0.4f) / 40, (static_cast<float>(j) + 0.7f) / 40);
      const Vec3 x = w.forward(u);
      EXPECT_LT(length(w.inverse(x) - u), 1e-5f) << u.x << " " << u.y;
      EXPECT_LT(length(w.forward(w.inverse(x)) - x), 1e-5f) << u.x << " " << u.y;
    }
}

TEST_P(EveryWarp, DensityIsOneOverTheJacobian) {
  const Warp& w = GetParam();
  EXPECT_LT(statistics::jacobian_error(w.forward, w.pdf, 10), 0.01);
}

TEST_P(EveryWarp, SamplesFollowTheDensity) {
  const Warp& w = GetParam();
  const statistics::SphereTest settings{.subdivisions = 32, .tests = static_cast<int>(all_warps().size())};
  const double area = static_cast<double>(w.size.x * w.size.y);
  const auto result =
      w.on_sphere()
          ? statistics::chi_square_sphere([&](Vec2 u, float) { return std::optional(w.forward(u)); }, w.pdf, settings)
          : statistics::chi_square_square([&](Vec2 u) { return (Vec2(w.forward(u)) - w.origin) / w.size; },
                                          [&](Vec2 s) { return area * w.pdf(Vec3(w.origin + s * w.size, 0)); },
                                          settings);
  EXPECT_TRUE(result) << result.message;
}

TEST_P(EveryWarp, DensityIntegratesToOne) {
  const Warp& w = GetParam();
  constexpr int n = 500;
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vec2d s((i + 0.5) / n, (j + 0.5) / n);
      const double z = 2 * s.x - 1, ring = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * s.y;
      sum += w.pdf(w.on_sphere() ? Vec3(Vec3d(ring * std::cos(phi), ring * std::sin(phi), z))
                                 : Vec3(w.origin + Vec2(s) * w.size, 0));
    }
  const double domain = w.on_sphere() ? 4 * std::numbers::pi : static_cast<double>(w.size.x * w.size.y);
  EXPECT_NEAR(sum * domain / (n * n), 1, 3e-3);
}

TEST_P(EveryWarp, StaysInItsDomainUpToTheEdgesOfTheSquare) {
  const Warp& w = GetParam();
  for (const float x : {0.0f, 1e-30f, 0x1p-24f, 0.25f, 0.5f, one_minus_epsilon})
    for (const float y : {0.0f, 1e-30f, 0x1p-24f, 0.5f, 0.75f, one_minus_epsilon}) {
      const Vec3 p = w.forward({x, y});
      if (w.on_sphere()) {
        EXPECT_NEAR(length(p), 1, 1e-6f) << x << " " << y;
      } else {
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(Vec2(p), w.origin - 1e-6f))) << x << " " << y;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(Vec2(p), w.origin + w.size + 1e-6f))) << x << " " << y;
      }
      const Vec2 back = w.inverse(p);
      EXPECT_TRUE(back.x >= -1e-6f && back.x <= 1 + 1e-6f && back.y >= -1e-6f && back.y <= 1 + 1e-6f) << x << " " << y;
    }
}

// The sun's disk is 1e-5 below the pole: z alone would have few digits for it, and none for the last of these.
TEST(Warp, NarrowConesKeepTheirWidth) {
  for (const float below_pole : {1e-3f, 1e-5f, 0x1p-22f}) {
    const float cos_theta_max = 1 - below_pole;
    double mean_squared = 0;
    constexpr int n = 1000;
    for (int i = 0; i < n; ++i) {
      const Vec2 u((static_cast<float>(i) + 0.5f) / n, 0.3f);
      const Vec3 w = square_to_uniform_cone(u, cos_theta_max);
      mean_squared += static_cast<double>(w.x * w.x + w.y * w.y) / n;
      EXPECT_LT(length(uniform_cone_to_square(w, cos_theta_max) - u), 1e-4f);
    }
    // sin² θ ≈ 2 (1 - cos θ), and 1 - cos θ is uniform.
    const auto width = static_cast<double>(1 - cos_theta_max);
    EXPECT_NEAR(mean_squared / width, 1, 1e-3);
  }
}

// rows: PT-29
TEST(Warp, TheConcentricDiskKeepsNeighboursTogether) {
  const float step = 1e-3f;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 u(static_cast<float>(i) / 1000, 0.7f);
    EXPECT_LT(length(square_to_uniform_disk_concentric(u + Vec2(step, 0)) - square_to_uniform_disk_concentric(u)),
              4 * step);
  }
  EXPECT_EQ(square_to_uniform_disk_concentric(Vec2(0.5f)), Vec2(0));
}

TEST(Warp, DensitiesVanishOutside) {
  EXPECT_EQ(uniform_disk_pdf({0.8f, 0.7f}), 0);
  EXPECT_EQ(uniform_hemisphere_pdf({0.6f, 0, -0.8f}), 0);
  EXPECT_EQ(cosine_hemisphere_pdf({0.6f, 0, -0.8f}), 0);
  EXPECT_EQ(cosine_power_pdf({0.6f, 0, -0.8f}, 3), 0);
  EXPECT_EQ(uniform_cone_pdf({0.8f, 0, 0.6f}, 0.7f), 0);
  EXPECT_EQ(tent_pdf(-1.5f), 0);
}

TEST(Warp, TurnsLieInZeroToOne) {
  EXPECT_FLOAT_EQ(turn_of(0, 1), 0.25f);
  EXPECT_FLOAT_EQ(turn_of(0, -1), 0.75f);
  EXPECT_LT(turn_of(1, -1e-20f), 1);
  EXPECT_EQ(turn_of(0, 0), 0);
}

}  // namespace
}  // namespace lambert
