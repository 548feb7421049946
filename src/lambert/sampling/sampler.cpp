#include "lambert/sampling/sampler.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace lambert {
namespace {

constexpr std::array<std::pair<std::string_view, SamplerKind>, 5> kinds{{
    {"independent", SamplerKind::independent},
    {"stratified", SamplerKind::stratified},
    {"halton", SamplerKind::halton},
    {"sobol", SamplerKind::sobol},
    {"blue-noise", SamplerKind::blue_noise},
}};

/// Element `i` of a pseudo-random permutation of 0..n-1 (Kensler, "Correlated Multi-Jittered Sampling", 2013).
std::uint32_t permuted(std::uint32_t i, std::uint32_t n, std::uint32_t key) {
  std::uint32_t w = std::bit_ceil(n) - 1;
  do {
    i ^= key, i *= 0xe170893du, i ^= key >> 16, i ^= (i & w) >> 4, i ^= key >> 8, i *= 0x0929eb3fu, i ^= key >> 23;
    i ^= (i & w) >> 1, i *= 1 | key >> 27, i *= 0x6935fa69u, i ^= (i & w) >> 11, i *= 0x74dcb303u;
    i ^= (i & w) >> 2, i *= 0x9e501cc3u, i ^= (i & w) >> 2, i *= 0xc860a3dfu, i &= w, i ^= i >> 5;
  } while (i >= n);
  return (i + key) % n;
}

/// The radical inverse of `i` in `base`, each digit permuted as the digits before it say (Owen scrambling), which keeps
/// stratification and makes the point uniform. Shifts would not do for permutations: until two bases have gone once
/// round together, i mod b and i mod c run along diagonals, and shifts leave those whole. After the digits that tell
/// `planned` points apart the rest is one random number, as it would be for a single point.
float scrambled_radical_inverse(std::uint32_t base, std::uint64_t i, std::uint64_t planned, std::uint64_t key) {
  double value = 0, width = 1;
  std::uint64_t prefix = key;
  for (std::uint64_t told_apart = 1; told_apart < planned || i > 0; told_apart *= base, i /= base) {
    const std::uint32_t digit =
        permuted(static_cast<std::uint32_t>(i % base), base, static_cast<std::uint32_t>(mix_bits(prefix)));
    width /= base;
    value += digit * width;
    prefix = mix_bits(prefix + digit + 1);
  }
  value += width * static_cast<double>(hash_to_float(mix_bits(prefix)));
  return std::min(static_cast<float>(value), one_minus_epsilon);
}

std::uint64_t spread_bits(std::uint32_t v) {
  std::uint64_t x = v;
  x = (x | x << 16) & 0x0000ffff0000ffffull;
  x = (x | x << 8) & 0x00ff00ff00ff00ffull;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0full;
  x = (x | x << 2) & 0x3333333333333333ull;
  return (x | x << 1) & 0x5555555555555555ull;
}

/// The 24 permutations of four digits, two bits a digit.
const std::array<std::uint8_t, 24>& digit_permutations() {
  static const auto table = [] {
    std::array<std::uint8_t, 24> all{};
    std::array<unsigned, 4> p{0, 1, 2, 3};
    for (std::uint8_t& packed : all) {
      packed = static_cast<std::uint8_t>(p[0] | p[1] << 2 | p[2] << 4 | p[3] << 6);
      std::next_permutation(p.begin(), p.end());
    }
    return all;
  }();
  return table;
}

}  // namespace

SamplerKind sampler_kind(std::string_view name) {
  for (const auto& [known, kind] : kinds)
    if (known == name) return kind;
  throw Error("unknown sampler " + unknown_word(name, sampler_names()));
}

std::vector<std::string> sampler_names() {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds) names.emplace_back(name);
  return names;
}

void Sampler::prepare(const SamplerSettings& settings, Vec2i pixel) {
  planned_ = std::max(1u, settings.samples_per_pixel);
  if (kind_ != SamplerKind::blue_noise) return;
  // An even number of bits for the samples, so that base-4 digits hold pixels or samples, never both.
  const auto sample_bits = static_cast<std::uint32_t>(std::bit_width(planned_ - 1) + 1) & ~1u;
  const std::uint64_t morton =
      spread_bits(static_cast<std::uint32_t>(pixel.x)) | spread_bits(static_cast<std::uint32_t>(pixel.y)) << 1;
  const auto side = static_cast<std::uint32_t>(std::max({settings.resolution.x, settings.resolution.y, 1}));
  // A sum: samples beyond the planned ones go on in the next pixel's points instead of coming back to their own.
  z_index_ = (morton << sample_bits) + sample_;
  planned_ = sample_bits / 2 + static_cast<std::uint32_t>(std::bit_width(side - 1));
  key_ = mix_bits(settings.seed + 1);  // the same for all pixels: they share one sequence
}

Vec2 Sampler::general(std::uint64_t h) const {
  switch (kind_) {
    case SamplerKind::stratified: return stratified(h);
    case SamplerKind::halton: return halton(h);
    case SamplerKind::blue_noise: return blue_noise();
    default: break;
  }
  const std::uint64_t own = mix_bits(h + sample_);
  return {hash_to_float(own), hash_to_float(own << 24)};
}

Vec2 Sampler::stratified(std::uint64_t h) const {
  // The most nearly square grid of at least `planned_` cells; rounds of that many samples follow each other.
  const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(planned_))));
  const std::uint32_t rows = (planned_ + columns - 1) / columns, cells = columns * rows;
  const auto key = static_cast<std::uint32_t>(mix_bits(h + sample_ / cells));
  const std::uint32_t cell = permuted(sample_ % cells, cells, key);
  const std::uint64_t jitter = mix_bits(h ^ (0xabcdull << 32) ^ sample_);
  const float x = (static_cast<float>(cell % columns) + hash_to_float(jitter)) / static_cast<float>(columns);
  const float y = (static_cast<float>(cell / columns) + hash_to_float(jitter << 24)) / static_cast<float>(rows);
  return {std::min(x, one_minus_epsilon), std::min(y, one_minus_epsilon)};
}

Vec2 Sampler::halton(std::uint64_t h) const {
  // Beyond 32 pairs the bases begin again, with other scrambles.
  static constexpr std::array<std::uint16_t, 64> primes{
      2,   3,   5,   7,   11,  13,  17,  19,  23,  29,  31,  37,  41,  43,  47,  53,  59,  61,  67,  71,  73,  79,
      83,  89,  97,  101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193,
      197, 199, 211, 223, 227, 229, 233, 239, 241, 251, 257, 263, 269, 271, 277, 281, 283, 293, 307, 311};
  const std::size_t pair = (dimension_ - 1) % (primes.size() / 2);
  return {scrambled_radical_inverse(primes[2 * pair], sample_, planned_, h),
          scrambled_radical_inverse(primes[2 * pair + 1], sample_, planned_, ~h)};
}

Vec2 Sampler::blue_noise() const {
  const std::uint64_t dimension_key = mix_bits(key_ + 0x9e3779b97f4a7c15ull * dimension_);
  std::uint64_t index = 0;
  for (std::uint32_t digit = planned_; digit-- > 0;) {
    const std::uint32_t shift = 2 * digit;
    const std::uint64_t higher = shift + 2 < 64 ? z_index_ >> (shift + 2) : 0;
    const std::uint8_t permutation = digit_permutations()[mix_bits(higher ^ dimension_key) % 24];
    const std::uint64_t value = z_index_ >> shift & 3;
    index |= static_cast<std::uint64_t>(permutation >> (2 * value) & 3) << shift;
  }
  const auto i = static_cast<std::uint32_t>(index);
  const std::uint64_t scramble = mix_bits(dimension_key + 1);
  return {to_float(reverse_bits(laine_karras(i, static_cast<std::uint32_t>(scramble)))),
          to_float(reverse_bits(laine_karras(pascal_bits(i), static_cast<std::uint32_t>(scramble >> 32))))};
}

}  // namespace lambert
