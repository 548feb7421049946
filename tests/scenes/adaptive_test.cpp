#include "known_scenes.h"

#include "lambert/render/render.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

/// One pixel whose samples are rarely large: where stopping when it looks converged would bias most.
class RareFlash final : public Method {
 public:
  MethodInfo info() const override { return {"flash", "", "", true}; }
  SettingTable settings() override { return SettingTable({}); }
  void prepare(const Scene&) override {}
  Estimate radiance(const CameraRay&, Sampler& sampler, bool) const override {
    return {Rgb(sampler.next() < 0.05f ? 19.0f : 0.05f), {}, 1};
  }
};

// The mean over many independent adaptive renders is the expected value, 0.05 * 19 + 0.95 * 0.05 = 0.9975.
TEST(Adaptive, StoppingDoesNotBias) {
  const Scene scene = compile(furnace(0.5f, 0.5f));
  Camera camera;
  camera.resolution = {16, 16};
  RareFlash method;
  RenderSettings settings{.samples_per_pixel = 512, .target_error = 0.15, .sampler = SamplerKind::independent};
  settings.filter.kind = FilterKind::box;
  double sum = 0, squares = 0;
  int count = 0;
  std::uint64_t samples = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    settings.seed = seed;
    const RenderResult result = render(scene, camera, method, settings);
    samples += result.statistics.samples;
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const double v = static_cast<double>(result.film.mean({x, y}).r);
        sum += v, squares += v * v, ++count;
      }
  }
  const double mean = sum / count, standard_error = std::sqrt((squares / count - mean * mean) / count);
  EXPECT_NEAR(mean, 0.9975, 4 * standard_error);
  EXPECT_LT(standard_error, 0.01);
  EXPECT_LT(samples, std::uint64_t{30} * 256 * 512) << "nothing was saved";
}

TEST(Adaptive, ReachesTheTargetWithFewerSamplesWhereItIsEasy) {
  // Half the image is a furnace of no variance (emission alone), so it needs only the pilot.
  const Scene scene = compile(furnace(0.0f, 1.0f));
  Camera camera;
  camera.resolution = {16, 16};
  const RenderResult result =
      render(scene, camera, *make_method("path"), {.samples_per_pixel = 1024, .target_error = 0.01});
  EXPECT_EQ(result.statistics.samples, 16u * 16u * 32u);
}

}  // namespace
}  // namespace lambert
