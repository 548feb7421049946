#include "lambert/render/render.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace lambert {
namespace {

/// Random grey; takes its time when asked to.
class Noise final : public Method {
 public:
  explicit Noise(int microseconds = 0) : microseconds_(microseconds) {}
  MethodInfo info() const override { return {"noise", "", "", true}; }
  SettingTable settings() override { return SettingTable({}); }
  void prepare(const Scene&) override { ++prepared; }
  Estimate radiance(const CameraRay&, Sampler& sampler, bool) const override {
    if (microseconds_ > 0) std::this_thread::sleep_for(std::chrono::microseconds(microseconds_));
    return {Rgb(sampler.next()), {}, 3};
  }
  int prepared = 0;

 private:
  int microseconds_;
};

struct RenderTest : testing::Test {
  Scene scene = compile(SceneGraph());
  Camera camera{.resolution = {20, 18}};
  Noise noise;

  std::string error(const RenderSettings& settings) {
    try {
      render(scene, camera, noise, settings);
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }
};

TEST_F(RenderTest, TakesTheSamplesAskedFor) {
  for (const int pass_size : {0, 3, 64}) {
    const RenderResult r = render(scene, camera, noise, {.samples_per_pixel = 23, .pass_size = pass_size});
    EXPECT_EQ(r.statistics.samples, 20u * 18u * 23u);
    EXPECT_EQ(r.film.total_samples(), r.statistics.samples);
    EXPECT_EQ(r.statistics.rays, 3 * r.statistics.samples);
    EXPECT_FALSE(r.statistics.interrupted);
    EXPECT_LE(r.statistics.first_sample_seconds, r.statistics.seconds);
  }
  EXPECT_EQ(noise.prepared, 3);
}

TEST_F(RenderTest, RefusesSettingsOutOfRange) {
  EXPECT_EQ(error({.samples_per_pixel = 0}), "samples per pixel must be at least 1");
  EXPECT_EQ(error({.time_limit_seconds = -1}), "limits of error and time must be numbers of at least 0");
  EXPECT_EQ(error({.target_error = -0.1}), "limits of error and time must be numbers of at least 0");
  for (const PixelRect& crop :
       {PixelRect{{0, 0}, {21, 5}}, PixelRect{{-1, 0}, {5, 5}}, PixelRect{{5, 5}, {5, 8}}, PixelRect{{0, 9}, {5, 8}}})
    EXPECT_EQ(error({.crop = crop}), "the crop window must be a non-empty part of the image (20x18)");
  camera.resolution = {0, 5};
  EXPECT_EQ(error({}), "the resolution must be positive");
}

TEST_F(RenderTest, AStopRequestedBeforeLeavesAValidFilm) {
  std::stop_source source;
  source.request_stop();
  const RenderResult r = render(scene, camera, noise, {}, {}, source.get_token());
  EXPECT_TRUE(r.statistics.interrupted);
  EXPECT_EQ(r.film.total_samples(), 0u);
  EXPECT_EQ(r.film.develop().width(), 20);
}

TEST_F(RenderTest, AStopInTheMiddleKeepsWhatWasSampled) {
  std::stop_source source;
  int calls = 0;
  const ProgressSink stop_soon = [&](const Progress& p) {
    if (++calls == 2) source.request_stop();
    EXPECT_GE(p.fraction, 0);
  };
  Noise slow(20);
  const RenderResult r = render(scene, camera, slow, {.samples_per_pixel = 1000000}, stop_soon, source.get_token());
  EXPECT_TRUE(r.statistics.interrupted);
  EXPECT_GT(r.film.total_samples(), 0u);
  EXPECT_EQ(r.film.total_samples(), r.statistics.samples);
}

TEST_F(RenderTest, TheTimeLimitHolds) {
  for (const double error : {0.0, 1e-6}) {
    Noise slow(20);
    const RenderResult r =
        render(scene, camera, slow, {.samples_per_pixel = 1000000, .time_limit_seconds = 0.15, .target_error = error});
    EXPECT_GE(r.statistics.seconds, 0.15);
    EXPECT_LT(r.statistics.seconds, 2) << "generous: the machine may be busy";
    EXPECT_FALSE(r.statistics.interrupted) << "the limit is no interruption";
    EXPECT_GT(r.film.total_samples(), 0u);
  }
}

TEST_F(RenderTest, NoPixelIsBlackHoweverShortTheTime) {
  for (const double error : {0.0, 0.1}) {
    Noise slow(20);
    const RenderResult r =
        render(scene, camera, slow,
               {.samples_per_pixel = 1000000, .time_limit_seconds = 1e-9, .target_error = error, .pass_size = 100000});
    int black = 0;
    for (int y = 0; y < camera.resolution.y; ++y)
      for (int x = 0; x < camera.resolution.x; ++x) black += r.film.sample_count({x, y}) == 0;
    EXPECT_EQ(black, 0) << "target error " << error;
  }
}

TEST_F(RenderTest, ProgressOnlyGrows) {
  Noise slow(10);
  for (const double error : {0.0, 0.05}) {
    std::vector<Progress> seen;
    render(scene, camera, slow, {.samples_per_pixel = 24, .target_error = error},
           [&](const Progress& p) { seen.push_back(p); });
    ASSERT_GE(seen.size(), 2u);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_LE(seen[i].fraction, 1);
      EXPECT_GE(seen[i].remaining_seconds, 0);
      if (i == 0) continue;
      EXPECT_GE(seen[i].fraction, seen[i - 1].fraction);
      EXPECT_GE(seen[i].samples, seen[i - 1].samples);
      EXPECT_GE(seen[i].rays, seen[i - 1].rays);
      EXPECT_GE(seen[i].elapsed_seconds, seen[i - 1].elapsed_seconds);
    }
    EXPECT_EQ(seen.back().fraction, 1);
    EXPECT_EQ(seen.back().remaining_seconds, 0);
  }
}

TEST_F(RenderTest, AdaptiveMeansAreThoseOfTheMethod) {
  camera.resolution = {32, 32};
  const RenderResult r = render(scene, camera, noise,
                                {.samples_per_pixel = 400, .target_error = 0.05, .sampler = SamplerKind::independent});
  double sum = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) sum += static_cast<double>(r.film.mean({x, y}).r);
  const double standard_error = std::sqrt(1 / 12.0 / static_cast<double>(r.statistics.samples));
  EXPECT_NEAR(sum / 1024, 0.5, 5 * standard_error);
  EXPECT_LT(r.statistics.samples, 1024u * 400u);
}

}  // namespace
}  // namespace lambert
