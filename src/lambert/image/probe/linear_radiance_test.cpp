#include "lambert/image/probe/linear_radiance.h"

#include "lambert/image/probe/parts.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

const std::vector<AnyProjection>& maps() {
  static const std::vector<AnyProjection> all{LatLong{},     Cube{},        EqualArea{},  Octahedral{},
                                              angular_map(), MirrorBall{6}, MirrorBall{}, Fisheye{}};
  return all;
}

template <class F>
void for_each_texel(const Probe& probe, const F& f) {
  for (int chart = 0; chart < static_cast<int>(probe.charts.size()); ++chart)
    for (int y = 0; y < probe.height(); ++y)
      for (int x = 0; x < probe.width(); ++x) f(Texel{chart, x, y});
}

/// Means over texels by their own integrals: of what is linear these are values at the texels' middles.
Probe linear_map(const AnyProjection& p, Rgb constant, Vec3d gradient) {
  Probe probe = map_of(p, 12, [](Vec3) { return Rgb(); });
  for_each_texel(probe, [&](const Texel& t) {
    const CellIntegrals i = integrals(p, t.chart, texel_cell(probe, t.x, t.y));
    const double change = i.solid_angle > 0 ? dot(gradient, i.moment / i.solid_angle) : 0;
    probe.charts[static_cast<std::size_t>(t.chart)].set_rgb(t.x, t.y, constant + Rgb(static_cast<float>(change)));
  });
  return probe;
}

// rows: LF-08
TEST(LinearRadiance, IsExactWhereRadianceIsLinear) {
  const Vec3d gradient(0.3, -0.2, 0.5);
  for (const AnyProjection& p : maps()) {
    const Probe probe = linear_map(p, Rgb(2), gradient);
    for_each_texel(probe, [&](const Texel& t) {
      const LinearRadiance l = linear_radiance(probe, t);
      if (l.middle == Vec3d(0)) return;  // out of the disk
      for (const MapPoint& corner : corners(p, t.chart, texel_cell(probe, t.x, t.y)))
        if (const auto d = direction(p, corner)) {
          const auto want = static_cast<float>(2 + dot(gradient, Vec3d(*d)));
          EXPECT_NEAR(l(Vec3d(*d)).g, want, 0.03f) << p.index() << " " << t.x << " " << t.y;
        }
    });
  }
}

TEST(LinearRadiance, StaysAboveZeroBesideASun) {
  for (const AnyProjection& p : maps()) {
    const Probe probe = map_of(p, 16, [](Vec3 d) { return Rgb(dot(d, normalize(Vec3(1, 2, -3))) > 0.98f ? 1e4f : 1); });
    for_each_texel(probe, [&](const Texel& t) {
      const LinearRadiance l = linear_radiance(probe, t);
      for (const MapPoint& corner : corners(p, t.chart, texel_cell(probe, t.x, t.y)))
        if (const auto d = direction(p, corner)) {
          EXPECT_GE(l(Vec3d(*d)).g, -1e-3f) << p.index();
        }
    });
  }
}

TEST(LinearRadiance, ASunLeavesTheTexelsAroundAsTheyAre) {
  Probe probe = map_of(LatLong{}, 16, [](Vec3) { return Rgb(1); });
  probe.charts[0].set_rgb(10, 5, Rgb(1e4f));
  for_each_texel(probe, [&](const Texel& t) {
    for (const Vec3d& g : linear_radiance(probe, t).gradient) EXPECT_LT(length(g), 1e-5) << t.x << " " << t.y;
  });
}

TEST(LinearRadiance, OfATexelAloneIsItsColour) {
  const Probe probe = map_of(EqualArea{}, 1, [](Vec3) { return Rgb(3); });
  EXPECT_EQ(linear_radiance(probe, {0, 0, 0})(Vec3d(0, 0, 1)), Rgb(3));
}

}  // namespace
}  // namespace lambert::probe
