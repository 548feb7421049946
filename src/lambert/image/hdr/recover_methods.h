#pragma once
/// One function per RecoveryMethod: the response of one channel from its samples, as ln exposure or exposure at the
/// knots, in a scale of its own.

#include "lambert/image/hdr/log_response.h"
#include "lambert/image/hdr/recover.h"

#include <vector>

namespace lambert::hdr {

/// ln exposure at the knots, with its slope, and what was found on the way.
struct LogRecovery {
  std::vector<double> g;
  LogEquations equations;       ///< of the last turn
  std::vector<double> weights;  ///< of its terms, as Samples::codes
};

/// Turns of weighted least squares: a term's weight is 1 / (g'² (noise(code)² + (slope / 4)²)), which is the variance
/// of g(code) for pixels that lie up to a quarter of a pixel apart, times Geman and McClure's factor for what does not
/// fit. The curve is one of few parameters (ln z, ln(z + z_top / 20) and powers to the fifth) plus a deviation by knots
/// whose second differences are small; so the period of the exposures cannot show in it, which the equations alone
/// cannot tell (Grossberg and Nayar 2003).
LogRecovery recover_automatic(const Samples& samples, const Knots& knots);

/// Debevec and Malik 1997, equation 3, over all samples.
LogRecovery recover_debevec(const Samples& samples, const Knots& knots, double smoothness);

/// Robertson, Borman and Stevenson 2003: exposures at the knots. Codes go to the nearest knot. The turns begin at ln
/// exposure `start` instead of the paper's straight line, from which thousands may not arrive.
std::vector<double> recover_robertson(const Samples& samples, const Knots& knots, const std::vector<double>& start);

/// Mitsunaga and Nayar 1999: of the degrees up to 9 the lowest that fits within 2 % of the best.
std::vector<double> recover_mitsunaga(const Samples& samples, const Knots& knots);

/// The noise of the codes, in codes, by sixteenth of the knots: what makes the median of the squared residuals about
/// `g` the expected one; at least that of rounding. 0.29 or the neighbours' where pixels are rare.
std::vector<double> noise_by_sixteenths(const Samples& samples, const Knots& knots, const std::vector<double>& g);

/// Slopes by central differences in codes, at least a small positive one.
std::vector<double> slopes_of(const std::vector<double>& g, const Knots& knots);

}  // namespace lambert::hdr
