#pragma once
/// Weights of multiple importance sampling (Veach 1997, ch. 9), one sample of each of two strategies.

namespace lambert {

/// p / (p + q); 0 when both are 0.
inline float balance_heuristic(float p, float q) { return p > 0 ? p / (p + q) : 0; }

/// p² / (p² + q²) without overflow: infinite p gives 1.
inline float power_heuristic(float p, float q) {
  if (!(p > 0)) return 0;
  const float ratio = q / p;
  return 1 / (1 + ratio * ratio);
}

}  // namespace lambert
