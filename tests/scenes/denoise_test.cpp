#include "lambert/image/denoise/denoise.h"
#include "lambert/render/render.h"
#include "lambert/scene/cornell_box.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

Image box(int samples, std::vector<Aov> aovs) {
  SceneGraph graph = cornell_box();
  const Camera camera = graph.cameras().at(0).with_resolution({64, 64});
  const Scene scene = compile(std::move(graph));
  const RenderSettings settings{
      .samples_per_pixel = samples, .seed = static_cast<std::uint64_t>(samples), .aovs = std::move(aovs)};
  return render(scene, camera, *make_method("path"), settings).film.develop();
}

double mean_squared_error(const Image& a, const Image& b) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (int c = 0; c < 3; ++c) sum += std::pow(static_cast<double>(a.rgb(x, y)[c] - b.rgb(x, y)[c]), 2);
  return sum / (3.0 * a.width() * a.height());
}

TEST(Denoise, TheBoxAt16SamplesHasAFifthOfItsError) {
  const Image truth = box(512, {}), noisy = box(16, {Aov::denoising});
  const Image out = denoise_image(noisy, {.method = DenoiseMethod::nfor});
  EXPECT_LT(mean_squared_error(out, truth), mean_squared_error(noisy, truth) / 5);
  EXPECT_LT(mean_squared_error(out, truth),
            mean_squared_error(denoise_image(noisy, {.method = DenoiseMethod::nlm}), truth));
  EXPECT_LT(mean_squared_error(out, truth),
            mean_squared_error(denoise_image(noisy, {.method = DenoiseMethod::bilateral}), truth));
}

TEST(Denoise, LayersDoNotChangeTheImage) {
  const Image plain = box(4, {}), layered = box(4, {Aov::denoising});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      EXPECT_EQ(plain.rgb(x, y), layered.rgb(x, y));
      for (const char* c : {"R", "G", "B"}) {
        const std::string name = c;
        const auto value = [&](const std::string& channel) {
          return layered.at(x, y, *layered.channel(channel + name));
        };
        const float scattered = 0.5f * (value("denoising.a.") + value("denoising.b."));
        if (value("denoising.a.emission.") + value("denoising.b.emission.") == 0)
          EXPECT_NEAR(value(""), scattered, 1e-5f * scattered) << "the halves make the whole";
        else
          EXPECT_LT(scattered, 1) << "the lamp's own light is told apart";
      }
    }
}

}  // namespace
}  // namespace lambert
