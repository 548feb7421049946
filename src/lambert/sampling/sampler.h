#pragma once
/// Points for Monte Carlo integration, keyed by pixel, sample, dimension and seed: the same key gives the same number
/// on any thread and in any order of work.

#include "lambert/base/vec.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class SamplerKind {
  independent,  ///< hashed random numbers
  stratified,   ///< jittered strata, shuffled per dimension pair
  halton,       ///< Halton points, digits Owen-scrambled per pixel and dimension
  sobol,        ///< (0,2)-sequence pairs with hashed Owen scrambling, shuffled per pair (Burley, JCGT 2020)
  blue_noise,   ///< Sobol' points dealt along a Morton curve, so that error is blue noise (Ahmed and Wonka 2020)
};

/// Names as on the command line; throws Error for an unknown one.
SamplerKind sampler_kind(std::string_view name);
std::vector<std::string> sampler_names();

struct SamplerSettings {
  SamplerKind kind = SamplerKind::sobol;
  std::uint32_t samples_per_pixel = 64;  ///< planned; needed by stratified and blue_noise, a hint to the others
  std::uint64_t seed = 0;
  Vec2i resolution{512, 512};  ///< needed by blue_noise
};

/// The numbers of one sample of one pixel. A value; each call moves on by one or two dimensions. All in [0,1).
class Sampler {
 public:
  Sampler(const SamplerSettings& settings, Vec2i pixel, std::uint32_t sample);
  float next();
  Vec2 next2();
  /// Continues from `dimension` (each number of next() and each pair of next2() takes one).
  void set_dimension(std::uint32_t dimension);
  std::uint32_t dimension() const;
};

}  // namespace lambert
