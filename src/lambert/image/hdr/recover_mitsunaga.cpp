#include "lambert/base/error.h"
#include "lambert/image/hdr/recover_methods.h"

#include <array>
#include <cmath>

namespace lambert::hdr {
namespace {

constexpr std::size_t most_coefficients = 10;
using Powers = std::array<double, most_coefficients>;

Powers powers(double v) {
  Powers p;
  double power = 1;
  for (double& entry : p) entry = power, power *= v;
  return p;
}

}  // namespace

/// f(v) = Σ c_n v^n with f(1) = 1 makes Σ (f(v_j) / t_j - f(v_k) / t_k)² over neighbouring exposures least, each term
/// divided by its size so that dark pixels count. c_N = 1 - Σ others turns it into a linear system for the others.
std::vector<double> recover_mitsunaga(const Samples& s, const Knots& knots) {
  const double top = knots.position.back();
  SymmetricMatrix normal(most_coefficients);  // Σ d dᵀ with d = p(v_j) - ratio p(v_k), scaled
  double terms = 0;
  for (std::size_t i = 0; i < s.count(); ++i)
    for (std::size_t j = 0; j + 1 < s.frames; ++j) {
      const int dark = s.codes[i * s.frames + j], bright = s.codes[i * s.frames + j + 1];
      if (!s.usable.contains(dark) || !s.usable.contains(bright)) continue;
      const double ratio = std::exp(s.log_exposures[j] - s.log_exposures[j + 1]);
      const Powers p = powers(dark / top), q = powers(bright / top);
      const double size = 1 / (dark / top + 0.02);
      Powers d;
      for (std::size_t n = 0; n < d.size(); ++n) d[n] = (p[n] - ratio * q[n]) * size;
      for (std::size_t n = 0; n < d.size(); ++n)
        for (std::size_t m = 0; m <= n; ++m) normal.at(n, m) += d[n] * d[m];
      ++terms;
    }
  if (!(terms > 0)) throw Error("the response cannot be recovered: no pixel is usable in two neighbouring exposures");
  struct Fit {
    std::vector<double> c;
    double error;
  };
  std::vector<Fit> fits;
  for (std::size_t degree = 1; degree < most_coefficients; ++degree) {
    // With c_N = 1 - Σ c_n the residual is Σ c_n (d_n - d_N) + d_N.
    SymmetricMatrix a(degree);
    std::vector<double> b(degree);
    for (std::size_t n = 0; n < degree; ++n) {
      for (std::size_t m = 0; m <= n; ++m)
        a.at(n, m) = normal.full(n, m) - normal.full(n, degree) - normal.full(m, degree) + normal.at(degree, degree);
      a.at(n, n) *= 1 + 1e-12;
      b[n] = normal.at(degree, degree) - normal.full(n, degree);
    }
    auto c = solve_positive(std::move(a), std::move(b));
    if (!c) break;
    double last = 1;
    for (const double entry : *c) last -= entry;
    c->push_back(last);
    double error = 0;
    for (std::size_t n = 0; n <= degree; ++n)
      for (std::size_t m = 0; m <= degree; ++m) error += (*c)[n] * (*c)[m] * normal.full(n, m);
    fits.push_back({std::move(*c), std::max(error, 0.0)});
  }
  if (fits.empty()) throw Error("the response cannot be recovered: the equations have no solution");
  double least = fits[0].error;
  for (const Fit& fit : fits) least = std::min(least, fit.error);
  std::size_t chosen = 0;
  while (fits[chosen].error > 1.02 * least) ++chosen;
  std::vector<double> exposure;
  for (const double z : knots.position) {
    const Powers p = powers(z / top);
    double x = 0;
    for (std::size_t n = 0; n < fits[chosen].c.size(); ++n) x += fits[chosen].c[n] * p[n];
    exposure.push_back(x);
  }
  return exposure;
}

}  // namespace lambert::hdr
