#pragma once
#include <cstddef>
#include <functional>

namespace lambert {

/// How far a long work has come. Rates are per second of wall time since the start; 0 where unknown.
struct Progress {
  double fraction = 0;  ///< done, in [0,1]
  double elapsed_seconds = 0;
  double remaining_seconds = 0;
  double samples = 0, samples_per_second = 0;
  double rays = 0, rays_per_second = 0;
  double error = 0;  ///< estimated relative error of the image; 0 when not measured
};

/// Called now and then by long works, always from one thread at a time.
using ProgressSink = std::function<void(const Progress&)>;

/// The same of works that tell only the fraction done, in [0, 1], which does not fall. May be empty.
using FractionSink = std::function<void(double)>;

/// What the part of a work from fraction `begin` to `end` tells; empty where `whole` is.
FractionSink part_of(const FractionSink& whole, double begin, double end);

/// parallel_for() (parallel.h) that tells `progress` the share of the bodies that are done, a hundred times at most.
void parallel_for(std::size_t count, const FractionSink& progress, const std::function<void(std::size_t)>& body);

}  // namespace lambert
