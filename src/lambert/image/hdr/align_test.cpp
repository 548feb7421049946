#include "lambert/image/hdr/align.h"

#include "lambert/base/error.h"
#include "lambert/image/hdr/hdr_test_tools.h"
#include "lambert/image/hdr/merge.h"
#include "lambert/image/hdr/recover.h"

#include <gtest/gtest.h>

namespace lambert::hdr {
namespace {

constexpr SensorNoise some_noise{.full_well = 8000, .read_noise = 5};

// rows: LF-11
// Reference point p lies at map place p; the moved camera at p + move, so what p shows is seen at p - move.
TEST(Align, FindsKnownShifts) {
  const Image map = test_map(320, 240);
  const Vec2d moves[] = {{0, 0}, {5, -3}, {-17, 12}, {-4, 30}};
  std::vector<ExposeSettings> settings;
  for (std::size_t i = 0; i < 4; ++i)
    settings.push_back({.exposure = std::exp2(2.0 * static_cast<double>(i) - 5),
                        .noise = some_noise,
                        .seed = i + 1,
                        .move = moves[i]});
  const ExposureStack stack = photographs({&map}, "srgb", settings);
  for (const Alignment kind : {Alignment::shift, Alignment::rigid}) {
    const std::vector<Motion> found = find_motions(stack, 1, {.kind = kind});
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(found[i].shift.x, moves[1].x - moves[i].x, 0.3) << i;
      EXPECT_NEAR(found[i].shift.y, moves[1].y - moves[i].y, 0.3) << i;
      EXPECT_NEAR(found[i].turn, 0, 1e-3);
    }
  }
}

TEST(Align, LeavesWhatStandsStill) {
  const Image map = test_map(320, 240);
  for (const std::string curve : {"srgb", "log"}) {
    const ExposureStack stack = photographs(map, curve, {1.0 / 256, 1.0 / 16, 1, 16}, 8, some_noise);
    for (const Motion& m : find_motions(stack, 1))
      EXPECT_TRUE(m.still()) << curve << m.shift.x << " " << m.shift.y << " " << m.turn;
  }
}

// rows: LF-11
TEST(Align, FindsTurnsAndPartsOfPixels) {
  const Image map = test_map(320, 240);
  const ExposureStack stack =
      photographs({&map}, "film",
                  {{.exposure = 0.05, .noise = some_noise, .seed = 1},
                   {.exposure = 0.2, .noise = some_noise, .seed = 2, .move = {3.4, -6.7}, .turn = 0.02}});
  const Motion m = find_motions(stack, 0)[1];
  // q = R(-turn) (p - move)
  const double c = std::cos(0.02), s = std::sin(0.02);
  EXPECT_NEAR(m.turn, -0.02, 2e-4);
  EXPECT_NEAR(m.shift.x, -(c * 3.4 + s * -6.7), 0.1);
  EXPECT_NEAR(m.shift.y, -(-s * 3.4 + c * -6.7), 0.1);
}

// rows: LF-11
TEST(Align, MovedBackTheStackMergesAsIfItStood) {
  const Image map = test_map(320, 240);
  ExposureStack stack = photographs(
      {&map}, "srgb", {{.exposure = 0.05, .move = {9, 4}}, {.exposure = 0.2}, {.exposure = 0.8, .move = {-6, 11}}});
  const Response response = response_named("srgb", 3, 256);
  const double before = radiance_error(stack, merge(stack, response).image, map);
  move_back(stack, find_motions(stack, 1));
  const double after = radiance_error(stack, merge(stack, response).image, map);
  EXPECT_LT(after, 0.006);
  EXPECT_GT(before, 10 * after);
  EXPECT_EQ(stack.covered(0, 100), (Span{9, 320}));
  EXPECT_EQ(stack.covered(2, 100), (Span{0, 314}));
  EXPECT_EQ(stack.covered(0, 3), (Span{0, 0}));
}

TEST(Align, BearsTinyAndFlatPictures) {
  for (const Vec2i size : {Vec2i(1, 1), Vec2i(1, 40), Vec2i(7, 3)}) {
    ExposureStack stack = photographs(test_map(size.x, size.y), "srgb", {0.1, 0.4});
    move_back(stack, find_motions(stack, 0));
    EXPECT_EQ(stack.frames.size(), 2u);
  }
}

TEST(Align, MotionsFollowOneAnother) {
  const Motion m = then({{1, 2}, 0.5}, {{3, -1}, -0.5});
  EXPECT_NEAR(m.turn, 0, 1e-12);
  EXPECT_NEAR(m.shift.x, std::cos(0.5) + 2 * std::sin(0.5) + 3, 1e-12);
}

}  // namespace
}  // namespace lambert::hdr
