#pragma once

namespace lambert {

struct PathSettings {
  int max_depth = 1000;    ///< most scattering events of a path; Russian roulette ends nearly all long before
  int roulette_depth = 1;  ///< scattering events before Russian roulette may end a path
  /// Paths whose throughput (largest component) lies below this survive with the probability that raises it to this.
  float roulette_threshold = 0.55f;
  float clamp = 0;  ///< largest component that a contribution after the first bounce may have; 0: off (clamping biases)
};

}  // namespace lambert
