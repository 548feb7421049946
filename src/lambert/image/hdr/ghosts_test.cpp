#include "lambert/image/hdr/ghosts.h"

#include "lambert/base/error.h"
#include "lambert/image/hdr/hdr_test_tools.h"
#include "lambert/image/hdr/merge.h"
#include "lambert/image/hdr/recover.h"

#include <gtest/gtest.h>

namespace lambert::hdr {
namespace {

Image with_square(Image map, int left, float radiance) {
  for (int y = 40; y < 70; ++y)
    for (int x = left; x < left + 30; ++x)
      for (std::size_t c = 0; c < 3; ++c) map.at(x, y, c) = radiance;
  return map;
}

// rows: LF-11
// A square that is elsewhere in each photograph is, merged, where the reference has it, and nowhere else.
TEST(Ghosts, AMovingSquareIsSeenOnce) {
  const Image map = test_map(200, 120);
  const std::vector<Image> moments{with_square(map, 20, 2), with_square(map, 80, 2), with_square(map, 140, 2)};
  const ExposureStack stack = photographs({&moments[0], &moments[1], &moments[2]}, "srgb",
                                          {{.exposure = 0.05}, {.exposure = 0.15}, {.exposure = 0.45}});
  const Response response = response_named("srgb", 3, 256);
  const GhostMasks ghosts = find_ghosts(stack, response, {.reference = 1});
  const auto error = [&](const Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
      sum += std::abs(std::log(std::max(1e-3, static_cast<double>(image.pixels()[i])) /
                               static_cast<double>(moments[1].pixels()[i])));
    return sum / static_cast<double>(image.pixels().size());
  };
  const double with = error(merge(stack, response, {}, ghosts).image), without = error(merge(stack, response).image);
  EXPECT_LT(with, 0.03);
  EXPECT_LT(with, 0.4 * without);
  EXPECT_TRUE(ghosts.row(1, 0, stack.width) == nullptr);
}

// rows: LF-11
TEST(Ghosts, NothingMovesInAStillScene) {
  const Image map = test_map(200, 120);
  for (const double full_well : {0.0, 5000.0}) {
    const ExposureStack stack =
        photographs(map, "film", {1.0 / 64, 0.125, 1}, 8, {.full_well = full_well, .read_noise = 4});
    const Response response = response_named("film", 3, 256);
    const GhostMasks ghosts = find_ghosts(stack, response, {.noise = measure_noise(stack, response)});
    EXPECT_LT(ghosts.count(), 200u * 120 * 2 / 500) << full_well;
  }
}

TEST(Ghosts, RefusesAReferenceThatIsNotThere) {
  const ExposureStack stack = photographs(test_map(16, 16), "srgb", {0.1, 0.4});
  EXPECT_THROW(find_ghosts(stack, response_named("srgb", 3, 256), {.reference = 2}), Error);
}

}  // namespace
}  // namespace lambert::hdr
