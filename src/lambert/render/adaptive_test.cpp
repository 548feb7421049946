#include "lambert/render/adaptive.h"

#include "lambert/base/hash.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

const PixelRect crop{{10, 20}, {30, 40}};

/// Pilot samples of mean 1 and standard deviation `deviation` left of column 20, constant `right` elsewhere.
Film pilot(float deviation, float right) {
  Film film({64, 64}, crop, {});
  for (int y = crop.min.y; y < crop.max.y; ++y)
    for (int x = crop.min.x; x < crop.max.x; ++x)
      for (std::uint32_t s = 0; s < pilot_samples; ++s) {
        const float noise = s % 2 == 0 ? deviation : -deviation;
        film.add({x, y}, {.radiance = Rgb(x < 20 ? 1 + noise : right)});
      }
  return film;
}

// n = v / (2 e²) for each half; the estimate of v from 16 alternating samples is d² 16/15.
TEST(PlanSamples, AsManyAsTheErrorAsksFor) {
  const double error = 0.02, v = 0.3 * 0.3 * 16 / 15;
  const SampleMap map = plan_samples(pilot(0.3f, 1), error, pilot_samples, 1000);
  EXPECT_NEAR(map.at({12, 25}), v / (2 * error * error), 1);
  EXPECT_EQ(map.at({28, 25}), pilot_samples) << "no variance there";
  EXPECT_GT(map.at({20, 25}), pilot_samples) << "its neighbours have some";
  EXPECT_EQ(plan_samples(pilot(0.3f, 1), error, pilot_samples, 100).at({12, 25}), 100u);
}

TEST(PlanSamples, ErrorIsRelativeButNotInTheDark) {
  Film film({64, 64}, crop, {});
  for (int y = crop.min.y; y < crop.max.y; ++y)
    for (int x = crop.min.x; x < crop.max.x; ++x)
      for (int s = 0; s < 16; ++s) film.add({x, y}, {.radiance = Rgb(x < 20 ? 1e-4f * static_cast<float>(s % 2) : 0)});
  const SampleMap map = plan_samples(film, 0.01, pilot_samples, 1000);
  EXPECT_EQ(map.at({12, 25}), pilot_samples);
  EXPECT_EQ(map.total(), crop.area() * pilot_samples);
}

TEST(PlanSamples, AnInfiniteVarianceTakesAll) {
  const Film empty({64, 64}, crop, {});
  const SampleMap map = plan_samples(empty, 0.01, pilot_samples, 500);
  EXPECT_EQ(map.total(), crop.area() * 500);
}

TEST(SampleMap, IsIndexedByPixelsOfTheImage) {
  SampleMap map(crop, 3);
  map.set({29, 39}, 10);
  map.set({10, 20}, 20);
  EXPECT_EQ(map.at({29, 39}), 10u);
  EXPECT_EQ(map.at({11, 20}), 3u);
  EXPECT_EQ(map.total(), 398u * 3 + 30);
}

}  // namespace
}  // namespace lambert
