#pragma once
/// Points for Monte Carlo integration, keyed by pixel, sample, dimension and seed: the same key gives the same number
/// on any thread and in any order of work.

#include "lambert/base/hash.h"
#include "lambert/base/vec.h"
#include "lambert/sampling/sobol.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class SamplerKind : std::uint8_t {
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
  std::uint32_t samples_per_pixel = 64;  ///< planned; needed by stratified and blue_noise, a hint to halton
  std::uint64_t seed = 0;
  Vec2i resolution{512, 512};  ///< needed by blue_noise
};

/// The numbers of one sample of one pixel. A value; each call moves on by one dimension. All numbers lie in [0,1).
class Sampler {
 public:
  Sampler(const SamplerSettings& settings, Vec2i pixel, std::uint32_t sample)
      : key_(mix_bits(settings.seed * 0x9e3779b97f4a7c15ull ^ pack(pixel))),
        sample_(sample),
        reversed_sample_(reverse_bits(sample)),
        kind_(settings.kind) {
    if (kind_ != SamplerKind::sobol) prepare(settings, pixel);
  }

  float next() {
    const std::uint64_t h = hash();
    if (kind_ != SamplerKind::sobol) return general(h).x;
    const std::uint32_t index = shuffled_index(h);
    return to_float(reverse_bits(laine_karras(index, static_cast<std::uint32_t>(h >> 32))));
  }

  Vec2 next2() {
    const std::uint64_t h = hash();
    if (kind_ != SamplerKind::sobol) return general(h);
    const std::uint32_t index = shuffled_index(h);
    const std::uint64_t h2 = h * 0xd6e8feb86659fd93ull;
    return {to_float(reverse_bits(laine_karras(index, static_cast<std::uint32_t>(h >> 32)))),
            to_float(reverse_bits(laine_karras(pascal_bits(index), static_cast<std::uint32_t>(h2 >> 32))))};
  }

  /// Continues from `dimension` (each number of next() and each pair of next2() takes one).
  void set_dimension(std::uint32_t dimension) { dimension_ = dimension; }
  std::uint32_t dimension() const { return dimension_; }

 private:
  static std::uint64_t pack(Vec2i p) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x)) << 32 | static_cast<std::uint32_t>(p.y);
  }
  static float to_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }
  std::uint64_t hash() { return mix_bits(key_ + 0x9e3779b97f4a7c15ull * ++dimension_); }
  /// Owen-scrambling the index shuffles the points but keeps every power-of-two prefix a net.
  std::uint32_t shuffled_index(std::uint64_t h) const {
    return reverse_bits(laine_karras(reversed_sample_, static_cast<std::uint32_t>(h)));
  }

  // The kinds other than sobol, out of line.
  void prepare(const SamplerSettings& settings, Vec2i pixel);
  Vec2 general(std::uint64_t h) const;
  Vec2 stratified(std::uint64_t h) const;
  Vec2 halton(std::uint64_t h) const;
  Vec2 blue_noise() const;

  std::uint64_t key_;
  std::uint64_t z_index_ = 0;  // blue_noise: Morton code of the pixel, then the sample
  std::uint32_t sample_, reversed_sample_;
  std::uint32_t dimension_ = 0;
  std::uint32_t planned_ = 1;  // stratified, halton: samples per pixel; blue_noise: base-4 digits of z_index_
  SamplerKind kind_;
};

}  // namespace lambert
