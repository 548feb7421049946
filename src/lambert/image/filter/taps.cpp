#include "lambert/image/filter/taps.h"

#include <algorithm>
#include <cmath>

namespace lambert {

void Taps::add(int index, double weight, int n, EdgeMode edge) {
  const int at = edge_index(index, n, edge);
  if (at < 0) {
    black_ += weight;
  } else if (!pending_.empty() && pending_.back().index == at) {
    weights_.back() += weight;
  } else {
    pending_.push_back({at, 0});
    weights_.push_back(weight);
  }
}

void Taps::end() {
  for (std::size_t i = 0; i < pending_.size(); ++i)
    if (const auto w = static_cast<float>(weights_[i]); w != 0) taps_.push_back({pending_[i].index, w});
  end_.push_back(taps_.size());
  pending_.clear();
  weights_.clear();
  black_ = 0;
}

void Taps::end_normalised(int nearest, int n, EdgeMode edge) {
  double sum = black_, absolute = std::abs(black_);
  for (const double w : weights_) sum += w, absolute += std::abs(w);
  if (!(std::abs(sum) > 1e-9 * absolute)) {
    pending_.clear();
    weights_.clear();
    add(nearest, 1, n, edge);
    sum = 1;
  }
  for (double& w : weights_) w /= sum;
  // Rounded weights should add up to what the exact ones do, so that constants stay: the heaviest takes the difference.
  if (!weights_.empty()) {
    double lost = 0;
    for (const double w : weights_) lost += w - static_cast<double>(static_cast<float>(w));
    *std::max_element(weights_.begin(), weights_.end()) += lost;
  }
  end();
}

Taps resampling_taps(const Kernel& kernel, const LineMap& map, EdgeMode edge) {
  Taps taps;
  const double widening = std::max(1.0, map.scale), radius = kernel.radius() * widening;
  constexpr double rounding = 1e-9;  // a pixel on the kernel's very end counts on both sides or on none
  for (int i = 0; i < map.out; ++i) {
    const double centre = map.scale * (i + map.offset + 0.5) - 0.5;
    const int first = static_cast<int>(std::ceil(centre - radius - rounding)),
              last = static_cast<int>(std::floor(centre + radius + rounding));
    for (int k = first; k <= last; ++k) {
      const double x = std::clamp((k - centre) / widening, -kernel.radius(), kernel.radius());
      taps.add(k, kernel(x), map.in, edge);
    }
    taps.end_normalised(static_cast<int>(std::lround(centre)), map.in, edge);
  }
  return taps;
}

Taps convolution_taps(std::span<const double> weights, int n, EdgeMode edge) {
  Taps taps;
  const int radius = static_cast<int>(weights.size() / 2);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < static_cast<int>(weights.size()); ++k)
      taps.add(i - radius + k, weights[static_cast<std::size_t>(k)], n, edge);
    taps.end();
  }
  return taps;
}

Taps area_taps(int in, int out) {
  Taps taps;
  const double step = static_cast<double>(in) / out;
  for (int i = 0; i < out; ++i) {
    const double begin = i * step, end = begin + step;
    for (int k = static_cast<int>(begin); k < in && k < end; ++k)
      taps.add(k, std::min<double>(end, k + 1) - std::max<double>(begin, k), in, EdgeMode::clamp);
    taps.end_normalised(static_cast<int>(begin), in, EdgeMode::clamp);
  }
  return taps;
}

Taps identity_taps(int n) {
  constexpr double one[] = {1};
  return convolution_taps(one, n, EdgeMode::clamp);
}

}  // namespace lambert
