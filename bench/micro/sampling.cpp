/// Nanoseconds per call of what every path vertex does.

#include "lambert/sampling/sampler.h"
#include "lambert/sampling/warp.h"

#include <benchmark/benchmark.h>

namespace lambert {
namespace {

void next2(benchmark::State& state, SamplerKind kind) {
  const SamplerSettings settings{.kind = kind};
  std::uint32_t sample = 0;
  for (auto _ : state) {
    Sampler sampler(settings, {17, 42}, sample++ & 63);
    for (int i = 0; i < 16; ++i) benchmark::DoNotOptimize(sampler.next2());
  }
  state.SetItemsProcessed(16 * state.iterations());
}
BENCHMARK_CAPTURE(next2, independent, SamplerKind::independent);
BENCHMARK_CAPTURE(next2, stratified, SamplerKind::stratified);
BENCHMARK_CAPTURE(next2, halton, SamplerKind::halton);
BENCHMARK_CAPTURE(next2, sobol, SamplerKind::sobol);
BENCHMARK_CAPTURE(next2, blue_noise, SamplerKind::blue_noise);

void cosine_hemisphere(benchmark::State& state) {
  Vec2 u(0.1f, 0.7f);
  for (auto _ : state) {
    benchmark::DoNotOptimize(square_to_cosine_hemisphere(u));
    u.x = u.x < 0.9f ? u.x + 0.01f : 0.05f;
  }
}
BENCHMARK(cosine_hemisphere);

}  // namespace
}  // namespace lambert
