/// Random variables: density, distribution and mean.

#include "lambert/draw/plot.h"
#include "lambert/lab/demo.h"
#include "lambert/sampling/inversion.h"
#include "lambert/sampling/patterns.h"
#include "lambert/sampling/quadrature.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace lambert::lab {
namespace {

using draw::Plot;
using draw::Series;
using std::numbers::pi;

constexpr double width = 460, height = 340;

/// Uniform random numbers in [0, 1).
std::vector<double> uniform_numbers(int count, std::uint64_t seed) {
  std::vector<double> numbers;
  for (const Vec2 p : random_points((count + 1) / 2, seed)) {
    numbers.push_back(static_cast<double>(p.x));
    numbers.push_back(static_cast<double>(p.y));
  }
  numbers.resize(static_cast<std::size_t>(count));
  return numbers;
}

// p(x) = 6x(1 - x) on [0, 1], P(x) = 3x² - 2x³: a cubic equation stands behind its inverse.
double density(double x) { return 6 * x * (1 - x); }
double cumulative(double x) { return x * x * (3 - 2 * x); }

constexpr double alpha = 0.2, beta = 0.5;

draw::Drawing density_plot(const std::vector<double>& samples) {
  constexpr int bins = 40, steps = 100;
  std::vector<double> histogram(bins);
  for (const double x : samples)
    histogram[static_cast<std::size_t>(x * bins)] += bins / static_cast<double>(samples.size());
  Series area{.name = fmt::format("P({:g}) - P({:g}) = {:.3f}", beta, alpha, cumulative(beta) - cumulative(alpha)),
              .mark = Series::Mark::area,
              .colour = draw::series_colour(1).with_opacity(0.35)};
  Series measured{.name = fmt::format("{} samples", samples.size()), .mark = Series::Mark::steps, .width = 1},
      curve{.name = "p(x) = 6x(1 - x)"};
  for (int i = 0; i <= steps; ++i) {
    const double x = static_cast<double>(i) / steps;
    curve.points.emplace_back(x, density(x));
    area.points.emplace_back(alpha + x * (beta - alpha), density(alpha + x * (beta - alpha)));
  }
  for (int i = 0; i < bins; ++i)
    measured.points.emplace_back(static_cast<double>(i) / bins, histogram[static_cast<std::size_t>(i)]);
  measured.points.emplace_back(1, histogram.back());
  measured.colour = draw::series_colour(7);
  curve.colour = draw::series_colour(0);
  return drawn(Plot{.title = "PDF, and samples by inversion",
                    .x = {.label = "x", .low = 0, .high = 1},
                    .y = {.label = "density", .low = 0, .high = 2.6},
                    .series = {area, measured, curve},
                    .width = width,
                    .height = height});
}

draw::Drawing distribution_plot(std::vector<double> samples) {
  constexpr int steps = 100;
  samples.resize(100);
  std::ranges::sort(samples);
  Series curve{.name = "P(x)", .colour = draw::series_colour(0)},
      measured{.name = fmt::format("{} samples", samples.size()),
               .points = {{0, 0}},
               .mark = Series::Mark::steps,
               .colour = draw::series_colour(7),
               .width = 1},
      ends{.name = fmt::format("P({:g}) = {:g}, P({:g}) = {:g}", alpha, cumulative(alpha), beta, cumulative(beta)),
           .points = {{alpha, 0},
                      {alpha, cumulative(alpha)},
                      {0, cumulative(alpha)},
                      {NAN, NAN},
                      {0, cumulative(beta)},
                      {beta, cumulative(beta)},
                      {beta, 0}},
           .colour = draw::series_colour(1),
           .dashed = true};
  for (int i = 0; i <= steps; ++i)
    curve.points.emplace_back(static_cast<double>(i) / steps, cumulative(static_cast<double>(i) / steps));
  for (std::size_t i = 0; i < samples.size(); ++i)
    measured.points.emplace_back(samples[i], static_cast<double>(i + 1) / static_cast<double>(samples.size()));
  measured.points.emplace_back(1, 1);
  return drawn(Plot{.title = "CDF",
                    .x = {.label = "x", .low = 0, .high = 1},
                    .y = {.label = "probability", .low = 0, .high = 1.05},
                    .series = {measured, ends, curve},
                    .width = width,
                    .height = height});
}

/// X uniform on [0, pi].
double expected(const std::function<double(double)>& f) {
  return midpoint_integral([&](double x) { return f(x) / pi; }, 0, pi, 10000);
}

/// The mean of f(X) over the first n samples, where n grows by a twelfth of an octave or by 1.
Series running_mean(const std::string& name, const std::vector<double>& xi, const std::function<double(double)>& f) {
  Series series{.name = name};
  double sum = 0, next = 1;
  for (std::size_t n = 1; n <= xi.size(); ++n) {
    sum += f(pi * xi[n - 1]);
    if (static_cast<double>(n) < next) continue;
    series.points.emplace_back(static_cast<double>(n), sum / static_cast<double>(n));
    next = std::max(next + 1, next * std::exp2(1.0 / 12));
  }
  return series;
}

constexpr int most = 1 << 16;

draw::Drawing mean_plot(std::uint64_t seed) {
  const auto cosine = [](double x) { return std::cos(x); };
  const double deviation = std::sqrt(expected([](double x) { return std::cos(x) * std::cos(x); }));
  Plot plot{.title = "The mean of cos X, X uniform on 0 .. pi",
            .x = {.label = "samples n", .logarithmic = true, .low = 1, .high = most},
            .y = {.label = "mean of the first n", .low = -1.1, .high = 1.1},
            .series = {},
            .width = width,
            .height = height};
  for (std::uint64_t run = 0; run < 3; ++run)
    plot.series.push_back(running_mean(fmt::format("run {}", run + 1), uniform_numbers(most, seed + run), cosine));
  for (const double side : {2.0, -2.0}) {
    Series bound{.name = side > 0 ? "+-2 sigma / root n" : "", .colour = draw::Colour{36, 41, 47}, .dashed = true};
    for (double n = 1; n <= most; n *= std::exp2(0.25)) bound.points.emplace_back(n, side * deviation / std::sqrt(n));
    plot.series.push_back(std::move(bound));
  }
  return drawn(plot);
}

/// How many of 1000 means of 1024 samples of cos X are within two of their deviations of 0.
double share_within_bounds(std::uint64_t seed) {
  constexpr int runs = 1000, samples = 1024;
  const auto xi = uniform_numbers(runs * samples, seed);
  int within = 0;
  for (std::size_t run = 0; run < runs; ++run) {
    double mean = 0;
    for (std::size_t i = 0; i < samples; ++i) mean += std::cos(pi * xi[run * samples + i]) / samples;
    within += std::abs(mean) < 2 * std::sqrt(0.5 / samples);
  }
  return static_cast<double>(within) / runs;
}

// 3X and X² of the same X: as dependent as can be.
double first_term(double x) { return 3 * x; }
double second_term(double x) { return x * x; }
double sum_of_terms(double x) { return first_term(x) + second_term(x); }

double variance(const std::function<double(double)>& f) {
  const double mean = expected(f);
  return expected([&](double x) { return (f(x) - mean) * (f(x) - mean); });
}

draw::Drawing linearity_plot(const std::vector<double>& xi) {
  Plot plot{.title = "Means add up, of dependent terms too",
            .x = {.label = "samples n", .logarithmic = true, .low = 1, .high = most},
            .y = {.label = "mean of the first n", .low = 0, .high = 14},
            .series = {},
            .width = width,
            .height = height};
  std::size_t i = 0;
  const auto add = [&](const std::string& name, double (*f)(double), double truth) {
    Series mean = running_mean(name, xi, f);
    mean.colour = draw::series_colour(i++);
    plot.series.push_back(std::move(mean));
    plot.series.push_back({.name = "",
                           .points = {{1, truth}, {most, truth}},
                           .colour = draw::Colour{36, 41, 47},
                           .width = 1,
                           .dashed = true});
  };
  add("3 X", first_term, expected(first_term));
  add("X squared", second_term, expected(second_term));
  add("3 X + X squared", sum_of_terms, expected(first_term) + expected(second_term));
  return drawn(plot);
}

}  // namespace

Shown show_random_variable(const LabSettings& settings) {
  constexpr int count = 4000;
  std::vector<double> samples;
  for (const double u : uniform_numbers(count, settings.seed)) samples.push_back(invert_cdf(cumulative, u, 0, 1));
  const auto inside = std::ranges::count_if(samples, [](double x) { return x >= alpha && x < beta; });
  const auto xi = uniform_numbers(most, settings.seed + 3);
  return {
      draw::side_by_side(
          {density_plot(samples), distribution_plot(samples), mean_plot(settings.seed + 10), linearity_plot(xi)}, 2),
      {{"integral of the density", midpoint_integral(density, 0, 1, 10000)},
       {"probability of 0.2 to 0.5, area under the density", midpoint_integral(density, alpha, beta, 10000)},
       {"the same, difference of the distribution", cumulative(beta) - cumulative(alpha)},
       {"the same, share of the samples", static_cast<double>(inside) / count},
       {"mean of cos X", expected([](double x) { return std::cos(x); })},
       {"mean of cos X, 65536 samples", running_mean("", xi, [](double x) { return std::cos(x); }).points.back().y},
       {"share of 1000 means within 2 deviations", share_within_bounds(settings.seed)},
       {"mean of 3 X plus mean of X squared", expected(first_term) + expected(second_term)},
       {"mean of their sum, 65536 samples", running_mean("", xi, sum_of_terms).points.back().y},
       {"variance of 3 X plus variance of X squared", variance(first_term) + variance(second_term)},
       {"variance of their sum", variance(sum_of_terms)}}};
}

}  // namespace lambert::lab
