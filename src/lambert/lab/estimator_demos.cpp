/// Integrals by sums and by chance.

#include "lambert/draw/montage.h"
#include "lambert/draw/plot.h"
#include "lambert/lab/demo.h"
#include "lambert/lab/sampled_image.h"
#include "lambert/sampling/distribution.h"
#include "lambert/sampling/quadrature.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace lambert::lab {
namespace {

/// The rms error of `estimate(numbers)` over 200 sets of n random numbers in [0, 1).
double rms_error(int n, std::uint64_t seed, double truth,
                 const std::function<double(const std::vector<double>&)>& estimate) {
  constexpr int repetitions = 200;
  double sum = 0;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<double> numbers;
    for (const Vec2 p : random_points((n + 1) / 2, seed * 7919 + static_cast<std::uint64_t>(i))) {
      numbers.push_back(static_cast<double>(p.x));
      numbers.push_back(static_cast<double>(p.y));
    }
    numbers.resize(static_cast<std::size_t>(n));
    const double error = estimate(numbers) - truth;
    sum += error * error / repetitions;
  }
  return std::sqrt(sum);
}

double mean_of(const std::vector<double>& numbers, const std::function<double(double)>& term) {
  double sum = 0;
  for (const double u : numbers) sum += term(u);
  return sum / static_cast<double>(numbers.size());
}

constexpr int largest_power = 12;

}  // namespace

// ∫₁⁴ x² dx = 21: uniformly, X = 1 + 3ξ and p = 1/3; in proportion to x, X = √(1 + 15ξ) and p = 2x/15; in proportion to
// x² itself every term is 21.
Shown show_quadrature(const LabSettings& settings) {
  const auto square = [](double x) { return x * x; };
  draw::Series grid{.name = "grid sum", .mark = draw::Series::Mark::line_and_points},
      uniform{.name = "uniform density", .mark = draw::Series::Mark::line_and_points},
      linear{.name = "density 2x/15", .mark = draw::Series::Mark::line_and_points};
  for (int k = 1; k <= largest_power; ++k) {
    const int n = 1 << k;
    grid.points.emplace_back(n, std::abs(midpoint_integral(square, 1, 4, n) - 21));
    uniform.points.emplace_back(n, rms_error(n, settings.seed, 21, [&](const std::vector<double>& xi) {
                                  return mean_of(xi, [](double u) { return 3 * (1 + 3 * u) * (1 + 3 * u); });
                                }));
    linear.points.emplace_back(n, rms_error(n, settings.seed + 1, 21, [&](const std::vector<double>& xi) {
                                 return mean_of(xi, [](double u) { return 7.5 * std::sqrt(1 + 15 * u); });
                               }));
  }
  // One term's deviations: Var(3 X²) of uniform X, and Var(7.5 X) of X with density 2x/15.
  const double uniform_deviation = std::sqrt(3 * (1024.0 - 1) / 5 - 441),
               linear_deviation = std::sqrt(7.5 * 7.5 * 8.5 - 441);
  Shown shown{drawn(draw::Plot{.title = "The integral of x squared from 1 to 4",
                               .x = {.label = "terms", .logarithmic = true},
                               .y = {.label = "rms error", .logarithmic = true},
                               .series = {grid, uniform, linear}}),
              {}};
  shown.facts = {
      {"deviation of a term, uniform density", uniform_deviation},
      {"deviation of a term, density 2x/15", linear_deviation},
      {"rms error times root of n, uniform density", uniform.points.back().y * std::sqrt(uniform.points.back().x)},
      {"rms error times root of n, density 2x/15", linear.points.back().y * std::sqrt(linear.points.back().x)}};
  return shown;
}

// ∫ Π (π/2) sin(π xᵢ) over the unit cube is 1 in any number of variables.
Shown show_dimensions(const LabSettings& settings) {
  draw::Plot plot{.title = "The same number of terms in more variables",
                  .x = {.label = "terms", .logarithmic = true, .low = 0.8, .high = 8e4},
                  .y = {.label = "rms of the relative error", .logarithmic = true, .low = 5e-11, .high = 60.0}};
  Shown shown;
  const auto factor = [](double x) { return 0.5 * std::numbers::pi * std::sin(std::numbers::pi * x); };
  std::size_t colour = 0;
  for (const int variables : {1, 2, 4, 8}) {
    draw::Series grid{.name = fmt::format("grid, {} variable{}", variables, variables > 1 ? "s" : ""),
                      .mark = draw::Series::Mark::line_and_points,
                      .colour = draw::series_colour(colour)};
    draw::Series random = grid;
    random.name = fmt::format("random, {}", variables);
    random.dashed = true;
    for (int side = 1; std::pow(side, variables) <= 65536; side = variables >= 4 ? side + 1 : 2 * side) {
      const double one = midpoint_integral(factor, 0, 1, side);
      grid.points.emplace_back(std::pow(side, variables), std::abs(std::pow(one, variables) - 1));
    }
    for (int k = 1; k <= largest_power; ++k) {
      const int n = 1 << k;
      random.points.emplace_back(n, rms_error(n * variables, settings.seed, 1, [&](const std::vector<double>& xi) {
                                   double sum = 0;
                                   for (std::size_t i = 0; i < xi.size(); i += static_cast<std::size_t>(variables)) {
                                     double product = 1;
                                     for (std::size_t v = 0; v < static_cast<std::size_t>(variables); ++v)
                                       product *= factor(xi[i + v]);
                                     sum += product;
                                   }
                                   return sum / n;
                                 }));
    }
    shown.facts.emplace_back(fmt::format("slope of random points, {} variables", variables),
                             std::log(random.points.back().y / random.points.front().y) /
                                 std::log(random.points.back().x / random.points.front().x));
    plot.series.push_back(std::move(grid));
    plot.series.push_back(std::move(random));
    ++colour;
  }
  shown.picture = drawn(plot);
  return shown;
}

Shown show_inversion(const LabSettings& settings) {
  constexpr int count = 4000, bins = 40, n = 3;
  std::vector<double> histogram(bins);
  double sum = 0;
  for (const Vec2 p : random_points(count, settings.seed)) {
    const double x = std::pow(static_cast<double>(p.x), 1.0 / (n + 1));
    histogram[static_cast<std::size_t>(std::min(bins - 1, static_cast<int>(x * bins)))] +=
        static_cast<double>(bins) / count;
    sum += x / count;
  }
  draw::Series measured{.name = fmt::format("{} samples", count), .mark = draw::Series::Mark::steps},
      density{.name = "4 x^3", .dashed = true};
  for (int i = 0; i < bins; ++i) {
    measured.points.emplace_back(static_cast<double>(i) / bins, histogram[static_cast<std::size_t>(i)]);
    density.points.emplace_back((i + 0.5) / bins, 4 * std::pow((i + 0.5) / bins, 3));
  }
  measured.points.emplace_back(1, histogram.back());

  const std::array<float, 4> weights{0.2f, 0.3f, 0.4f, 0.1f};
  const DiscreteDistribution distribution(weights);
  draw::Series cumulative{.name = "cumulative", .mark = draw::Series::Mark::steps},
      drawn_bins{.name = "share of 4000 samples", .mark = draw::Series::Mark::points, .width = 3};
  std::array<double, 4> share{};
  for (const Vec2 p : random_points(count, settings.seed + 1)) share[distribution.sample(p.x).index] += 1.0 / count;
  for (std::size_t i = 0; i < 4; ++i)
    cumulative.points.emplace_back(static_cast<double>(i), static_cast<double>(distribution.cumulative()[i + 1]));
  cumulative.points.emplace_back(4, 1);
  for (std::size_t i = 0; i < 4; ++i) drawn_bins.points.emplace_back(static_cast<double>(i) + 0.5, share[i]);

  const draw::Drawing power = drawn(draw::Plot{.title = "x = root of order 4 of xi",
                                               .x = {.label = "x", .low = 0, .high = 1},
                                               .y = {.label = "density", .low = 0},
                                               .series = {measured, density},
                                               .width = 460,
                                               .height = 340});
  const draw::Drawing discrete = drawn(draw::Plot{.title = "bins of 0.2, 0.3, 0.4, 0.1",
                                                  .x = {.label = "bin", .low = 0, .high = 4},
                                                  .y = {.label = "probability", .low = 0, .high = 1.05},
                                                  .series = {cumulative, drawn_bins},
                                                  .width = 460,
                                                  .height = 340});
  return {draw::side_by_side({discrete, power}, 2),
          {{"mean of the power distribution (0.8)", sum}, {"share of the third bin (0.4)", share[2]}}};
}

Shown show_noise(const LabSettings& settings) {
  constexpr int size = 96;
  // A disk's shadow with a soft edge: each sample is a yes or no.
  const auto lit = [](Vec2d p) { return std::clamp((std::hypot(p.x - 48, p.y - 48) - 20) / 24, 0.05, 0.95); };
  Image truth(size, size, rgb_channels());
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) truth.set_rgb(x, y, Rgb(static_cast<float>(lit({x + 0.5, y + 0.5}))));
  Shown shown;
  std::vector<draw::Panel> panels;
  for (const int samples : {1, 4, 16, 64, 256}) {
    Image image(size, size, rgb_channels());
    const auto numbers =
        random_points(samples * size * size / 2 + 1, settings.seed + static_cast<std::uint64_t>(samples));
    std::size_t next = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        int hits = 0;
        for (int s = 0; s < samples; ++s, ++next) {
          const float u = next % 2 == 0 ? numbers[next / 2].x : numbers[next / 2].y;
          hits += static_cast<double>(u) < lit({x + 0.5, y + 0.5});
        }
        image.set_rgb(x, y, Rgb(static_cast<float>(hits) / static_cast<float>(samples)));
      }
    panels.push_back({fmt::format("{} sample{}", samples, samples == 1 ? "" : "s"), draw::magnified(image, 2)});
    shown.facts.emplace_back(fmt::format("rms error, {} samples", samples), rms_difference(image, truth));
  }
  shown.picture = montage(panels, {.columns = 5});
  return shown;
}

}  // namespace lambert::lab
