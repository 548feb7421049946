// Whether a ring is simple, and all crossings of many segments.

#include "lambert/polygon/queries/simple.h"
#include "lambert/polygon/sweep/intersections.h"
#include "outlines.h"

#include <benchmark/benchmark.h>

namespace lambert::polygon {
namespace {

template <Ring (*outline)(std::size_t)>
void simple(benchmark::State& state) {
  const Ring ring = outline(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(check_simple(ring));
}
BENCHMARK(simple<coast>)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);
BENCHMARK(simple<needles>)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);

/// Short segments at random: about as many crossings as segments.
void crossings(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d a(unit(random), unit(random));
    segments.push_back({a, a + 3 / std::sqrt(static_cast<double>(n)) * Vec2d(unit(random), unit(random))});
  }
  std::size_t found = 0;
  for (auto _ : state) found = all_intersections(segments).size();
  state.counters["crossings"] = static_cast<double>(found);
}
BENCHMARK(crossings)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lambert::polygon
