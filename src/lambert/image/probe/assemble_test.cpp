#include "lambert/image/probe/assemble.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/probe_test_tools.h"
#include "lambert/image/probe/rotation.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

Rgb world(Vec3 d) {
  const float boxes = std::sin(9 * d.x) * std::sin(8 * d.y + 1) * std::sin(7 * d.z + 2) > 0.1f ? 1.5f : 0.4f;
  return pattern(d) * boxes;
}

/// A ball seen from `azimuth` about +y, with a black camera in its middle.
BallView photograph(Angle azimuth, Rgb exposure, Angle real_azimuth, int size = 144) {
  const Mat3 turn = rotation(real_azimuth, degrees(1), degrees(-1.5f));
  const auto seen = [&](Vec3 d) {
    return d.z > std::cos(0.3f) ? Rgb(0.02f) : exposure * world((real_azimuth == degrees(0) ? Mat3(1) : turn) * d);
  };
  return {map_of(MirrorBall{}, size, seen, 3), azimuth};
}

// rows: LF-12
TEST(Assemble, TwoBallsMakeOneWorldWithoutTheCamera) {
  for (const float angle : {90.0f, 120.0f}) {
    const std::vector<BallView> views{photograph(degrees(0), Rgb(1), degrees(0)),
                                      photograph(degrees(angle), Rgb(0.5f, 0.5f, 0.6f), degrees(angle + 3))};
    const Assembly a = assemble(views, 96);
    const Mat3 truth_turn = rotation(degrees(angle + 3), degrees(1), degrees(-1.5f));
    for (int c = 0; c < 3; ++c) EXPECT_LT(length(a.rotations[1][c] - truth_turn[c]), 0.01f) << angle;
    EXPECT_NEAR(a.exposures[1].r, 2, 0.04f);
    EXPECT_NEAR(a.exposures[1].b, 1 / 0.6f, 0.04f);
    EXPECT_GT(a.correlations[1], 0.9f);
    const Probe truth = map_of(LatLong{}, 96, world, 3);
    double error = 0, weight = 0, dark = 0;
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 192; ++x) {
        const auto w = static_cast<double>(density(LatLong{}, {0, {0.5f, (static_cast<float>(y) + 0.5f) / 96}}));
        const Rgb got = a.probe.charts[0].rgb(x, y), want = truth.charts[0].rgb(x, y);
        error += w * static_cast<double>(std::abs(got.g - want.g) / want.g), weight += w;
        if (got.g < 0.2f) dark += w;
      }
    EXPECT_LT(error / weight, 0.06) << angle;  // mostly the edges of the boxes
    EXPECT_LT(dark / weight, 1e-3) << angle;   // no camera
  }
}

TEST(Assemble, RefusesWhatCannotBeAssembled) {
  const BallView ball{map_of(MirrorBall{}, 8, pattern), degrees(0)};
  EXPECT_THROW(assemble({ball}, 8), Error);
  EXPECT_THROW(assemble({ball, {map_of(LatLong{}, 8, pattern), degrees(90)}}, 8), Error);
  const Assembly tiny = assemble({ball, {map_of(MirrorBall{}, 1, pattern), degrees(90)}}, 1);
  for (const float v : tiny.probe.charts[0].pixels()) EXPECT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace lambert::probe
