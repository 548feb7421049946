#include "vectors.h"

#include "lambert/render/film.h"
#include "lambert/render/render.h"
#include "lambert/sampling/roulette.h"
#include "scenes/known_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

// rows: PT-26
const CheckOf roulette("V-PT-12", [](const Vector& v) {
  const auto alpha = v.input.at("alpha").get<float>(), throughput = v.input.at("throughput").get<float>();
  for (std::size_t i = 0; i < v.input.at("xi").size(); ++i) {
    const float factor = russian_roulette(alpha, v.input.at("xi")[i].get<float>());
    EXPECT_EQ(factor > 0, v.expected.at("survives")[i].get<bool>());
    if (factor > 0) v.expect_near(throughput * factor, v.expected.at("new_throughput"));
  }
  // 1 + 1/2 + 1/4 …, each step surviving with probability alpha: the k-th term times its chance, summed.
  double sum = 0, without_division = 0, chance = 1, term = 1, divided = 1;
  for (int k = 0; k < 200; ++k) {
    sum += chance * divided, without_division += chance * term;
    chance *= static_cast<double>(alpha), term *= 0.5;
    divided *= 0.5 * static_cast<double>(russian_roulette(alpha, 0));
  }
  v.expect_near(sum, v.expected.at("series_sum_exact"));
  v.expect_near(without_division, v.expected.at("series_without_division"));
});

// rows: PT-03 PT-23
const CheckOf furnaces("V-PT-13", [](const Vector& v) {
  for (std::size_t i = 0; i < v.input.at("albedo").size(); ++i) {
    const Scene scene = compile(furnace(v.input.at("albedo")[i].get<float>(), v.input.at("Le").get<float>()));
    const auto method = make_method("path");
    const Camera camera = cameras_at({0, 0, 0.3f}, {0, 0.1f, -1}).front();
    const Film film = render(scene, camera, *method, {.samples_per_pixel = 1024}).film;
    double mean = 0;
    for (int y = 0; y < camera.resolution.y; ++y)
      for (int x = 0; x < camera.resolution.x; ++x)
        mean += static_cast<double>(luminance(film.mean({x, y}))) / (camera.resolution.x * camera.resolution.y);
    v.expect_near(mean, v.expected.at("L")[i]);
  }
});

/// The standard error that a film reports for n samples, every other one of them black.
double standard_error(int n) {
  Film film({1, 1}, {{0, 0}, {1, 1}}, {});
  for (int i = 0; i < n; ++i) film.add({0, 0}, {.radiance = Rgb(i % 2 ? 1.0f : 0.0f)});
  return std::sqrt(film.variance_of_mean({0, 0}));
}

// rows: PT-22
// The fewest samples with half the error of n (for the known spread of one sample, not that estimated from n - 1).
const CheckOf half_the_error("V-PT-17", [](const Vector& v) {
  const int n = v.input.at("n").get<int>();
  const auto error = [](int samples) { return standard_error(samples) * std::sqrt((samples - 1.0) / samples); };
  int needed = n;
  while (error(needed) > 0.5 * error(n) * (1 + 1e-9)) needed += 2;
  v.expect_near(static_cast<double>(needed), v.expected.at("needed"));
});

}  // namespace
}  // namespace lambert
