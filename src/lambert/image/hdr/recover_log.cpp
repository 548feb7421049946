#include "lambert/base/error.h"
#include "lambert/image/hdr/recover_methods.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert::hdr {
namespace {

constexpr std::size_t basis_size = 7;

/// The curve of few parameters that the automatic recovery starts from, at code `z` of `top`.
std::array<double, basis_size> basis(double z, double top) {
  const double v = std::max(z, 0.35) / top;
  return {std::log(v), std::log(v + 0.05), v, v * v, v * v * v, v * v * v * v, v * v * v * v * v};
}

[[noreturn]] void no_solution() { throw Error("the response cannot be recovered: the equations have no solution"); }

std::vector<double> fit_basis(const LogEquations& q, const Knots& knots) {
  const std::size_t n = knots.count();
  std::vector<std::array<double, basis_size>> phi;
  for (const double z : knots.position) phi.push_back(basis(z, knots.position.back()));
  SymmetricMatrix a(basis_size);
  std::vector<double> b(basis_size);
  for (std::size_t p = 0; p < basis_size; ++p) {
    std::vector<double> column(n);
    for (std::size_t i = 0; i < n; ++i) column[i] = phi[i][p];
    column = q.a.times(column);
    for (std::size_t r = p; r < basis_size; ++r)
      for (std::size_t i = 0; i < n; ++i) a.at(r, p) += phi[i][r] * column[i];
    for (std::size_t i = 0; i < n; ++i) b[p] += phi[i][p] * q.b[i];
  }
  double trace = 0;
  for (std::size_t p = 0; p < basis_size; ++p) trace += a.at(p, p);
  for (std::size_t p = 0; p < basis_size; ++p) a.at(p, p) += 1e-10 * trace;
  const auto coefficients = solve_positive(std::move(a), std::move(b));
  if (!coefficients) no_solution();
  std::vector<double> g(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t p = 0; p < basis_size; ++p) g[i] += (*coefficients)[p] * phi[i][p];
  return g;
}

/// Adds weight[k] (second difference at knot k)² for the inner knots.
void add_smoothness(SymmetricMatrix& a, const std::vector<double>& weight) {
  constexpr double stencil[] = {1, -2, 1};
  for (std::size_t k = 1; k + 1 < a.size; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j) a.at(k - 1 + i, k - 1 + j) += weight[k] * stencil[i] * stencil[j];
}

/// The equations know g up to a constant only: asks for a mean of 0.
void fix_mean(SymmetricMatrix& a) {
  double trace = 0;
  for (std::size_t i = 0; i < a.size; ++i) trace += a.at(i, i);
  const double weight = trace / static_cast<double>(a.size * a.size);
  for (double& entry : a.entries) entry += weight;
}

/// What the data want beside the curve `g`, small and smooth. The scales are priors: deviations of a few hundredths,
/// whose slope changes by 2.5e-5 from code to code, by more below code 20 of 255 where curves bend.
std::vector<double> deviation(const LogEquations& q, const std::vector<double>& g) {
  const std::size_t n = g.size();
  SymmetricMatrix a = q.a;
  std::vector<double> rhs = q.b;
  const std::vector<double> explained = q.a.times(g);
  for (std::size_t i = 0; i < n; ++i) rhs[i] -= explained[i];
  std::vector<double> weight(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double spread = 2.5e-5 * std::pow(std::max(1.0, 20.0 / static_cast<double>(k + 1)), 2);
    weight[k] = 1 / (spread * spread);
  }
  add_smoothness(a, weight);
  for (std::size_t i = 0; i < n; ++i) a.at(i, i) += 100;
  const auto d = solve_positive(std::move(a), std::move(rhs));
  if (!d) no_solution();
  return *d;
}

double hat(int code, const UsableCodes& usable) {
  return usable.contains(code) ? std::min(code - usable.black, usable.saturated - code) : 0;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Residuals g(z_ij) - ln t_j - m_i with the m_i of `weights`; 0 where the weight is.
std::vector<double> residuals(const Samples& s, const Knots& knots, const std::vector<double>& g,
                              const std::vector<double>& weights) {
  std::vector<double> r(weights.size());
  for (std::size_t i = 0; i < s.count(); ++i) {
    const std::size_t first = i * s.frames;
    double total = 0, mean = 0;
    for (std::size_t j = 0; j < s.frames; ++j) {
      const double w = weights[first + j];
      if (!(w > 0)) continue;
      r[first + j] = knots.eval(g, s.codes[first + j]) - s.log_exposures[j];
      total += w, mean += w * r[first + j];
    }
    for (std::size_t j = 0; j < s.frames; ++j)
      if (weights[first + j] > 0) r[first + j] -= mean / total;
  }
  return r;
}

constexpr std::size_t noise_bins = 16;
std::size_t bin_of(const Knots& knots, std::size_t code) { return knots.below[code] * noise_bins / knots.count(); }
const double rounding_noise = std::sqrt(1.0 / 12);

/// Leaves out codes of pixels that shorter exposures say are saturated: lossy compression scatters these below the code
/// that counts as saturated, and among the highest codes they are the most.
void leave_out_saturated(const Samples& s, const Knots& knots, const std::vector<double>& g,
                         std::vector<double>& weights) {
  constexpr double clearly = 0.1;  // ln exposure
  const double saturated = knots.eval(g, static_cast<std::size_t>(s.usable.saturated));
  for (std::size_t i = 0; i < s.count(); ++i) {
    double total = 0, mean = 0;
    for (std::size_t j = 0; j < s.frames; ++j) {
      double& w = weights[i * s.frames + j];
      if (total > 0 && mean / total + s.log_exposures[j] > saturated + clearly) w = 0;
      total += w, mean += w * (knots.eval(g, s.codes[i * s.frames + j]) - s.log_exposures[j]);
    }
  }
}

/// 1 / variance of g(code), by noise and by the slope of the image.
std::vector<double> inverse_variances(const Samples& s, const Knots& knots, const std::vector<double>& g,
                                      const std::vector<double>& noise) {
  const std::vector<double> slope = slopes_of(g, knots);
  std::vector<double> weights(s.codes.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!s.usable.contains(s.codes[i])) continue;
    const double g1 = knots.eval(slope, s.codes[i]), blur = 0.25 * static_cast<double>(s.slopes[i]);
    const double sigma = noise[bin_of(knots, s.codes[i])];
    weights[i] = 1 / (g1 * g1 * (sigma * sigma + blur * blur));
  }
  if (s.usable.scattered) leave_out_saturated(s, knots, g, weights);
  return weights;
}

/// The noise for which the median of r² w, corrected for what a term pulls its own mean, is that of its expectation;
/// from pixels where the image is flat, so that its slope explains less of r than noise does.
std::vector<double> renewed_noise(const Samples& s, const Knots& knots, const std::vector<double>& residual,
                                  const std::vector<double>& weights, const std::vector<double>& noise) {
  std::vector<std::vector<double>> squares(noise_bins), on_slopes(noise_bins);
  for (std::size_t i = 0; i < s.count(); ++i) {
    const std::size_t first = i * s.frames;
    double total = 0;
    for (std::size_t j = 0; j < s.frames; ++j) total += weights[first + j];
    for (std::size_t j = 0; j < s.frames; ++j) {
      const double w = weights[first + j];
      // A term that is nearly all of the mean says little of its own noise.
      if (!(w > 0) || w > 0.9 * total) continue;
      const std::size_t bin = bin_of(knots, s.codes[first + j]);
      const double square = residual[first + j] * residual[first + j] * w / (1 - w / total);
      const bool flat = 0.25 * static_cast<double>(s.slopes[first + j]) < 0.5 * noise[bin];
      (flat ? squares : on_slopes)[bin].push_back(square);
    }
  }
  for (std::size_t b = 0; b < noise_bins; ++b)
    if (squares[b].size() < 30) squares[b].insert(squares[b].end(), on_slopes[b].begin(), on_slopes[b].end());
  constexpr double median_of_chi_square = 0.4549;
  std::vector<double> renewed(noise_bins, 0);
  for (std::size_t b = 0; b < noise_bins; ++b)
    if (squares[b].size() >= 30)
      renewed[b] = std::max(noise[b] * std::sqrt(median(squares[b]) / median_of_chi_square), rounding_noise);
  for (std::size_t b = 1; b < noise_bins; ++b)
    if (renewed[b] == 0) renewed[b] = renewed[b - 1];
  for (std::size_t b = noise_bins - 1; b-- > 0;)
    if (renewed[b] == 0) renewed[b] = renewed[b + 1];
  for (double& sigma : renewed)
    if (sigma == 0) sigma = rounding_noise;
  return renewed;
}

}  // namespace

std::vector<double> slopes_of(const std::vector<double>& g, const Knots& knots) {
  const std::size_t n = g.size();
  std::vector<double> slopes(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t a = k > 1 ? k - 1 : k, b = std::min(k + 1, n - 1);  // code 0 has no logarithm worth a slope
    slopes[k] = b > a ? (g[b] - g[a]) / (knots.position[b] - knots.position[a]) : 0;
    slopes[k] = std::max(slopes[k], 0.1 / knots.position.back());
  }
  slopes[0] = slopes[std::min<std::size_t>(1, n - 1)];
  return slopes;
}

std::vector<double> noise_by_sixteenths(const Samples& s, const Knots& knots, const std::vector<double>& g) {
  std::vector<double> noise(noise_bins, knots.below.size() == 256 ? 0.5 : 32);
  for (int turn = 0; turn < 3; ++turn) {
    const std::vector<double> weights = inverse_variances(s, knots, g, noise);
    noise = renewed_noise(s, knots, residuals(s, knots, g, weights), weights, noise);
  }
  return noise;
}

LogRecovery recover_automatic(const Samples& s, const Knots& knots) {
  std::vector<double> weights(s.codes.size()), robust(s.codes.size(), 1);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = hat(s.codes[i], s.usable);
  LogRecovery result{.equations = log_equations(s, knots, weights)};
  result.g = fit_basis(result.equations, knots);
  std::vector<double> noise(noise_bins, knots.below.size() == 256 ? 0.5 : 32);
  constexpr int turns = 6;
  for (int turn = 0; turn < turns; ++turn) {
    const std::vector<double> plain = inverse_variances(s, knots, result.g, noise);
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = plain[i] * robust[i];
    const std::vector<double> residual = residuals(s, knots, result.g, weights);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double excess = residual[i] * residual[i] * plain[i] / 9;
      robust[i] = 1 / ((1 + excess) * (1 + excess));
      weights[i] = plain[i] * robust[i];
    }
    noise = renewed_noise(s, knots, residual, plain, noise);
    result.equations = log_equations(s, knots, weights);
    result.g = fit_basis(result.equations, knots);
    const std::vector<double> d = deviation(result.equations, result.g);
    for (std::size_t k = 0; k < d.size(); ++k) result.g[k] += d[k];
  }
  result.weights = std::move(weights);
  return result;
}

LogRecovery recover_debevec(const Samples& s, const Knots& knots, double smoothness) {
  std::vector<double> weights(s.codes.size());
  double half = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = hat(s.codes[i], s.usable);
    half = std::max(half, weights[i]);
  }
  for (double& w : weights) w = (w / half) * (w / half);
  LogRecovery result{.equations = log_equations(s, knots, weights)};
  SymmetricMatrix a = result.equations.a;
  constexpr double pixels_of_the_paper = 100;
  const double scale = smoothness * static_cast<double>(s.count()) / pixels_of_the_paper;
  std::vector<double> weight(knots.count());
  for (std::size_t k = 0; k < weight.size(); ++k) {
    const double w = std::max(hat(static_cast<int>(knots.position[k]), s.usable), half / 128) / half;
    weight[k] = scale * w * w;
  }
  add_smoothness(a, weight);
  fix_mean(a);
  auto g = solve_positive(std::move(a), result.equations.b);
  if (!g) no_solution();
  result.g = std::move(*g);
  return result;
}

}  // namespace lambert::hdr
