/// Nanoseconds per evaluation, density and sample of the scattering models, through the variant as a renderer calls
/// them.

#include "lambert/bsdf/any_bsdf.h"

#include <benchmark/benchmark.h>

namespace lambert {
namespace {

void scatter(benchmark::State& state, const Bsdf& bsdf) {
  const Vec3 wo = normalize(Vec3(0.3f, 0.2f, 0.8f));
  Vec2 u(0.3f, 0.6f);
  for (auto _ : state) {
    const auto sample = bsdf.sample(wo, u.y, u);
    if (sample && !sample->specular) benchmark::DoNotOptimize(bsdf.pdf(wo, sample->wi));
    if (sample && !sample->specular) benchmark::DoNotOptimize(bsdf.eval(wo, sample->wi));
    u = {u.x < 0.9f ? u.x + 0.013f : 0.02f, u.y < 0.9f ? u.y + 0.037f : 0.01f};
  }
}
BENCHMARK_CAPTURE(scatter, diffuse, Bsdf(Diffuse{}));
BENCHMARK_CAPTURE(scatter, rough_conductor, Bsdf(Conductor{.alpha_x = 0.2f, .alpha_y = 0.2f}));
BENCHMARK_CAPTURE(scatter, rough_dielectric, Bsdf(Dielectric{.eta = 1.5f, .alpha_x = 0.2f, .alpha_y = 0.2f}));
BENCHMARK_CAPTURE(scatter, coated_diffuse, Bsdf(CoatedDiffuse{}));
BENCHMARK_CAPTURE(scatter, gltf, Bsdf(GltfPbr{}));

}  // namespace
}  // namespace lambert
