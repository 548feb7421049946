#pragma once

namespace lambert {

struct PathSettings {
  int max_depth = 1000;    ///< most scattering events of a path; Russian roulette ends nearly all long before
  int roulette_depth = 2;  ///< scattering events before Russian roulette may end a path
  float clamp = 0;  ///< largest component that a contribution after the first bounce may have; 0: off (clamping biases)
};

}  // namespace lambert
