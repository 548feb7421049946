#include "lambert/image/hdr/log_response.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {

Knots::Knots(int levels) : below(static_cast<std::size_t>(levels)), fraction(below.size()) {
  const double top = levels - 1;
  for (int k = 0; k < 256; ++k)
    position.push_back(levels == 256 ? k : std::max<double>(k, std::round(top * (k / 255.0) * (k / 255.0))));
  std::size_t k = 0;
  for (std::size_t code = 0; code < below.size(); ++code) {
    while (k + 1 < position.size() && position[k + 1] <= static_cast<double>(code)) ++k;
    below[code] = static_cast<std::uint16_t>(k);
    if (k + 1 < position.size())
      fraction[code] = static_cast<float>((static_cast<double>(code) - position[k]) / (position[k + 1] - position[k]));
  }
}

double LogEquations::misfit(const std::vector<double>& g) const {
  const std::vector<double> explained = a.times(g);
  double sum = c;
  for (std::size_t i = 0; i < g.size(); ++i) sum += g[i] * (explained[i] - 2 * b[i]);
  return sum;
}

LogEquations log_equations(const Samples& samples, const Knots& knots, const std::vector<double>& weights) {
  LogEquations q(knots.count());
  struct Term {
    std::size_t knot;
    double share;  // of its frame's weight
  };
  std::vector<Term> terms;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const std::size_t first = i * samples.frames;
    double total = 0, mean = 0;
    std::size_t used = 0;
    for (std::size_t j = 0; j < samples.frames; ++j) {
      const double w = weights[first + j];
      total += w, mean += w * samples.log_exposures[j], used += w > 0;
    }
    if (used < 2) continue;
    mean /= total;
    q.terms += used - 1;
    // Q_i = Σ w (g - l)² - (Σ w (g - l))² / Σ w, with g - l centred by the mean of l.
    terms.clear();
    for (std::size_t j = 0; j < samples.frames; ++j) {
      const double w = weights[first + j];
      if (!(w > 0)) continue;
      const double l = samples.log_exposures[j] - mean;
      const std::size_t code = samples.codes[first + j], k = knots.below[code];
      const double f = static_cast<double>(knots.fraction[code]);
      q.c += w * l * l;
      q.b[k] += w * (1 - f) * l;
      q.a.at(k, k) += w * (1 - f) * (1 - f);
      terms.push_back({k, w * (1 - f)});
      if (!(f > 0)) continue;
      q.b[k + 1] += w * f * l;
      q.a.at(k + 1, k + 1) += w * f * f;
      q.a.at(k + 1, k) += w * f * (1 - f);
      terms.push_back({k + 1, w * f});
    }
    for (std::size_t s = 0; s < terms.size(); ++s) {
      const double scaled = terms[s].share / total;
      for (std::size_t t = 0; t < terms.size(); ++t)
        if (terms[s].knot >= terms[t].knot) q.a.at(terms[s].knot, terms[t].knot) -= scaled * terms[t].share;
    }
  }
  return q;
}

}  // namespace lambert::hdr
