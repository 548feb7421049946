/// Texture lookups: nanoseconds each, of the mip map that rendering uses and of the pyramid of floats.

#include "lambert/base/hash.h"
#include "lambert/texture/mip_map.h"

#include <benchmark/benchmark.h>

namespace lambert {
namespace {

constexpr int size = 1024;

Texels bytes() {
  Texels t{.width = size, .height = size, .channels = 3};
  for (std::uint64_t i = 0; i < 3ull * size * size; ++i) t.bytes.push_back(static_cast<std::uint8_t>(hash_values(i)));
  return t;
}
Texels floats() {
  Texels t{.width = size, .height = size, .channels = 3, .linear = true};
  for (std::uint64_t i = 0; i < 3ull * size * size; ++i) t.floats.push_back(hash_to_float(hash_values(i)));
  return t;
}

/// Along a slanted line, as neighbouring pixels look, that also leaves the image.
template <class Look>
void along_a_line(benchmark::State& state, Look look) {
  Vec2 uv(-2);
  for (auto _ : state) {
    benchmark::DoNotOptimize(look(uv));
    uv += Vec2(0.37f, 0.21f) / static_cast<float>(size);
    if (uv.x > 2) uv = Vec2(-2);
  }
  state.SetItemsProcessed(state.iterations());
}

void mip_map(benchmark::State& state, Texels (*make)(), TextureFilter filter, float texels) {
  const MipMap map(make(), {.filter = filter, .srgb = true});
  const float width = texels / static_cast<float>(size);
  along_a_line(state, [&](Vec2 uv) { return map.lookup(uv, width); });
}
BENCHMARK_CAPTURE(mip_map, nearest_8_bit, bytes, TextureFilter::nearest, 0.0f);
BENCHMARK_CAPTURE(mip_map, bilinear_8_bit, bytes, TextureFilter::bilinear, 0.0f);
BENCHMARK_CAPTURE(mip_map, trilinear_8_bit, bytes, TextureFilter::trilinear, 2.7f);
BENCHMARK_CAPTURE(mip_map, nearest_float, floats, TextureFilter::nearest, 0.0f);
BENCHMARK_CAPTURE(mip_map, bilinear_float, floats, TextureFilter::bilinear, 0.0f);
BENCHMARK_CAPTURE(mip_map, trilinear_float, floats, TextureFilter::trilinear, 2.7f);

}  // namespace
}  // namespace lambert
