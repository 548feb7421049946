#include "lambert/image/hdr/recover_methods.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {

std::vector<double> recover_robertson(const Samples& s, const Knots& knots, const std::vector<double>& start) {
  const std::size_t n = knots.count(), middle = n / 2;
  std::vector<std::size_t> knot(s.codes.size());
  std::vector<double> weight(s.codes.size()), time(s.frames);
  for (std::size_t j = 0; j < s.frames; ++j) time[j] = std::exp(s.log_exposures[j]);
  for (std::size_t i = 0; i < knot.size(); ++i) {
    const std::size_t code = s.codes[i];
    knot[i] = knots.below[code] + (knots.fraction[code] > 0.5f ? 1 : 0);
    const double from_middle =
        (static_cast<double>(knot[i]) - static_cast<double>(middle)) / static_cast<double>(middle);
    weight[i] = s.usable.contains(s.codes[i]) ? std::exp(-4 * from_middle * from_middle) : 0;
  }
  std::vector<double> exposure;
  for (const double g : start) exposure.push_back(std::exp(g - start[middle]));
  constexpr int most_turns = 500;
  for (int turn = 0; turn < most_turns; ++turn) {
    std::vector<double> sum(n), count(n);
    for (std::size_t i = 0; i < s.count(); ++i) {
      const std::size_t first = i * s.frames;
      double above = 0, below = 0;
      for (std::size_t j = 0; j < s.frames; ++j) {
        const double w = weight[first + j] * time[j];
        above += w * exposure[knot[first + j]], below += w * time[j];
      }
      if (!(below > 0)) continue;
      for (std::size_t j = 0; j < s.frames; ++j)
        if (weight[first + j] > 0) sum[knot[first + j]] += time[j] * above / below, count[knot[first + j]] += 1;
    }
    double change = 0;
    std::vector<double> next = exposure;
    for (std::size_t k = 0; k < n; ++k)
      if (count[k] > 0) next[k] = sum[k] / count[k];
    if (const double unit = next[middle]; unit > 0)
      for (double& x : next) x /= unit;
    for (std::size_t k = n / 16; k < n; ++k)
      if (count[k] > 0) change = std::max(change, std::abs(next[k] / exposure[k] - 1));
    exposure = std::move(next);
    if (change < 1e-5) break;
  }
  return exposure;
}

}  // namespace lambert::hdr
