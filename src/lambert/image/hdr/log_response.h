#pragma once
/// The equations g(code) = ln radiance + ln exposure of Debevec and Malik, with the radiances eliminated.

#include "lambert/image/hdr/least_squares.h"
#include "lambert/image/hdr/samples.h"

#include <cstddef>
#include <vector>

namespace lambert::hdr {

/// Where a curve over codes has its values: at every code of 8 bits; of 16 bits at 256 codes, as k², so that codes of
/// linear cameras are told apart where they are small. Between them curves are straight.
struct Knots {
  std::vector<double> position;      ///< codes
  std::vector<std::uint16_t> below;  ///< by code, the knot at it or below it
  std::vector<float> fraction;       ///< by code, how far it is towards the next
  explicit Knots(int levels);
  static constexpr std::size_t count() { return 256; }
  double eval(const std::vector<double>& g, std::size_t code) const {
    const std::size_t k = below[code];
    const double f = static_cast<double>(fraction[code]);
    return f > 0 ? g[k] + f * (g[k + 1] - g[k]) : g[k];
  }
};

/// Of the sum Q(g) = Σ w_ij (g(z_ij) - ln t_j - m_i)² with m_i the one that makes it least: Q(g) = gᵀ a g - 2 bᵀ g + c.
struct LogEquations {
  SymmetricMatrix a;
  std::vector<double> b;
  double c = 0;
  std::size_t terms = 0;  ///< pairs (i, j), less one for each m_i
  explicit LogEquations(std::size_t knots) : a(knots), b(knots) {}
  double misfit(const std::vector<double>& g) const;
};

/// `weights` as samples.codes; 0 leaves a code out.
LogEquations log_equations(const Samples& samples, const Knots& knots, const std::vector<double>& weights);

}  // namespace lambert::hdr
