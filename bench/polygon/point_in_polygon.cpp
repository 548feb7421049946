// Points at random in the box of an outline: the prepared index against the plain test.

#include "lambert/polygon/locate/point_locator.h"
#include "outlines.h"

#include <benchmark/benchmark.h>

namespace lambert::polygon {
namespace {

std::vector<Vec2d> points_in(const Box2& box) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec2d> points(1 << 20);
  for (Vec2d& p : points) p = box.min + Vec2d(unit(random), unit(random)) * box.size();
  return points;
}

template <Ring (*outline)(std::size_t)>
void prepared(benchmark::State& state) {
  const PointLocator locator(Rings{outline(static_cast<std::size_t>(state.range(0)))});
  const std::vector<Vec2d> points = points_in(locator.box());
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(locator.locate(points[i]));
    i = (i + 1) % points.size();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(prepared<coast>)->RangeMultiplier(10)->Range(1000, 1000000);
BENCHMARK(prepared<needles>)->RangeMultiplier(10)->Range(1000, 1000000);

template <Ring (*outline)(std::size_t)>
void build(benchmark::State& state) {
  const Rings rings{outline(static_cast<std::size_t>(state.range(0)))};
  for (auto _ : state) benchmark::DoNotOptimize(PointLocator(rings));
}
BENCHMARK(build<coast>)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(build<needles>)->Arg(100000)->Unit(benchmark::kMillisecond);

void plain(benchmark::State& state) {
  const Ring ring = coast(static_cast<std::size_t>(state.range(0)));
  const std::vector<Vec2d> points = points_in(box_of(ring));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(locate(ring, points[i]));
    i = (i + 1) % points.size();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(plain)->Arg(100000);

}  // namespace
}  // namespace lambert::polygon
