#include "lambert/image/probe/spherical_harmonics.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/parts.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

const std::vector<AnyProjection>& maps() {
  static const std::vector<AnyProjection> all{LatLong{},    Cube{},        EqualArea{},
                                              Octahedral{}, angular_map(), MirrorBall{}};
  return all;
}

TEST(SphericalHarmonics, AreOrthonormal) {
  constexpr int order = 5;
  const Probe probe = map_of(EqualArea{}, 64, [](Vec3) { return Rgb(1); });
  std::vector<double> gram(sh_count(order) * sh_count(order), 0), y(sh_count(order));
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 64; ++i) {
      sh_basis(order, *direction(probe.projection, {0, uv_of(probe, Vec2(i, j) + 0.5f)}), y);
      for (std::size_t a = 0; a < y.size(); ++a)
        for (std::size_t b = 0; b < y.size(); ++b) gram[a * y.size() + b] += y[a] * y[b] * 4 * std::numbers::pi / 4096;
    }
  for (std::size_t a = 0; a < y.size(); ++a)
    for (std::size_t b = 0; b < y.size(); ++b) EXPECT_NEAR(gram[a * y.size() + b], a == b ? 1 : 0, 0.02);
  // The table of Ramamoorthi and Hanrahan.
  const Vec3 d = normalize(Vec3(0.3f, -0.5f, 0.8f));
  sh_basis(2, d, y);
  const double want[] = {0.282095,
                         0.488603 * static_cast<double>(d.y),
                         0.488603 * static_cast<double>(d.z),
                         0.488603 * static_cast<double>(d.x),
                         1.092548 * static_cast<double>(d.x * d.y),
                         1.092548 * static_cast<double>(d.y * d.z),
                         0.315392 * static_cast<double>(3 * d.z * d.z - 1),
                         1.092548 * static_cast<double>(d.x * d.z),
                         0.546274 * static_cast<double>(d.x * d.x - d.y * d.y)};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(y[i], want[i], 1e-5) << i;
}

TEST(SphericalHarmonics, ProjectionFindsWhatWasPutIn) {
  for (const AnyProjection& p : maps()) {
    std::vector<ShColour> put(sh_count(4));
    for (std::size_t i = 0; i < put.size(); ++i)
      put[i] = {0.1 * static_cast<double>(i), 1.0 / static_cast<double>(i + 1), i == 12 ? 1.0 : 0};
    const bool disk = has_disk(p);
    const auto got = sh_project(map_of(
                                    p, disk ? 128 : 64, [&](Vec3 d) { return sh_radiance(put, d); }, disk ? 8 : 4),
                                4);
    for (std::size_t i = 0; i < put.size(); ++i) {
      EXPECT_NEAR(got[i].r, put[i].r, 3e-4 + 2e-3 * put[i].r) << p.index() << " " << i;
      EXPECT_NEAR(got[i].b, put[i].b, 1e-3) << p.index() << " " << i;
    }
  }
  const auto constant = sh_project(map_of(LatLong{}, 16, [](Vec3) { return Rgb(1); }), 6);
  EXPECT_NEAR(constant[0].r, std::sqrt(4 * std::numbers::pi), 1e-4);
  for (std::size_t i = 1; i < constant.size(); ++i) EXPECT_NEAR(constant[i].r, 0, i < 9 ? 5e-5 : 3e-4) << i;
  EXPECT_THROW(sh_project(map_of(LatLong{}, 2, pattern), 33), Error);
}

// Nine coefficients are within 3 % of a clear but bounded environment (Ramamoorthi and Hanrahan: 1 % on average).
TEST(SphericalHarmonics, NineCoefficientsAreNearlyTheIrradiance) {
  EXPECT_NEAR(cosine_lobe(2), std::numbers::pi / 4, 1e-12);
  EXPECT_NEAR(cosine_lobe(4), -std::numbers::pi / 24, 1e-12);
  EXPECT_EQ(cosine_lobe(3), 0);
  const Probe probe = map_of(LatLong{}, 64, pattern, 2);
  const Irradiance exact(probe);
  const auto few = sh_irradiance(sh_project(probe, 2)), many = sh_irradiance(sh_project(probe, 16));
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Vec3 n = random_direction(i);
    const float e = exact(n).g;
    EXPECT_NEAR(sh_radiance(few, n).g, e, 0.03f * e);
    EXPECT_NEAR(sh_radiance(many, n).g, e, 1e-3f * e);
  }
}

}  // namespace
}  // namespace lambert::probe
