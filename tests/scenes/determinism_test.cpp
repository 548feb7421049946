#include "lambert/base/parallel.h"
#include "lambert/render/render.h"
#include "lambert/scene/cornell_box.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambert {
namespace {

Image render_cornell_box(const RenderSettings& settings, std::size_t threads) {
  set_thread_count(threads);
  SceneGraph graph = cornell_box();
  const Camera camera = graph.cameras().at(0).with_resolution({48, 48});
  const Scene scene = compile(std::move(graph));
  Image image = render(scene, camera, *make_method("path"), settings).film.develop();
  set_thread_count(0);
  return image;
}

void expect_same_bits(const Image& a, const Image& b) {
  EXPECT_TRUE(std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), b.pixels().end()));
}

class EverySampler : public testing::TestWithParam<std::string> {};

TEST_P(EverySampler, ImageDoesNotDependOnThreads) {
  const RenderSettings settings{
      .samples_per_pixel = 16, .sampler = sampler_kind(GetParam()), .aovs = {Aov::albedo, Aov::variance}};
  expect_same_bits(render_cornell_box(settings, 1), render_cornell_box(settings, 2));
}

TEST_P(EverySampler, ImageDoesNotDependOnPasses) {
  RenderSettings settings{.samples_per_pixel = 64, .sampler = sampler_kind(GetParam()), .pass_size = 64};
  const Image one_pass = render_cornell_box(settings, 2);
  settings.pass_size = 16;
  expect_same_bits(one_pass, render_cornell_box(settings, 2));
}

TEST_P(EverySampler, AnotherSeedGivesOtherNoise) {
  RenderSettings settings{.samples_per_pixel = 4, .sampler = sampler_kind(GetParam())};
  const Image a = render_cornell_box(settings, 2);
  settings.seed = 1;
  const Image b = render_cornell_box(settings, 2);
  EXPECT_FALSE(std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), b.pixels().end()));
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Samplers, EverySampler, testing::ValuesIn(sampler_names()), test_name);

TEST(Crop, PixelsAreThoseOfTheWholeImage) {
  RenderSettings settings{.samples_per_pixel = 4};
  const Image whole = render_cornell_box(settings, 2);
  settings.crop = PixelRect{{10, 20}, {30, 33}};
  const Image part = render_cornell_box(settings, 2);
  ASSERT_EQ(part.width(), 20);
  ASSERT_EQ(part.height(), 13);
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x) EXPECT_EQ(part.rgb(x, y), whole.rgb(x + 10, y + 20));
}

}  // namespace
}  // namespace lambert
