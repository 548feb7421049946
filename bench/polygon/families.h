#pragma once
/// Pairs of operands by family and size, of coordinates of size 1. Each operand is a valid polygon or several whose
/// interiors are disjoint, since some of the peers demand that.

#include "lambert/polygon/ring.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lambert::bench {

struct Pair {
  polygon::Rings subject, clip;
};

struct Family {
  std::string name;
  /// About `edges` edges in both operands together.
  Pair (*make)(std::size_t edges);
};

/// stars: radii at random in [0.5, 1]; blobs: three sines; combs: teeth that overlap pairwise; squares: two jittered
/// grids of squares; coast: an outline of fractal roughness.
std::vector<Family> families();

std::size_t edge_count(const polygon::Rings& rings);

/// The outlines of countries in world-atlas, one Rings a country; empty when the file is not there.
std::vector<polygon::Rings> countries(const std::string& file);

/// The outer rings of their union, every edge cut into displaced ones until there are about `edges`; valid.
polygon::Rings refined_land(const std::vector<polygon::Rings>& countries, std::size_t edges);

}  // namespace lambert::bench
