#pragma once
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace lambert {

/// A full-avalanche mix of 64 bits (Stafford's variant 13 of the MurmurHash3 finaliser).
constexpr std::uint64_t mix_bits(std::uint64_t v) {
  v ^= v >> 30, v *= 0xbf58476d1ce4e5b9ull;
  v ^= v >> 27, v *= 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}

/// One 64-bit hash of several trivially copyable values, in order.
template <class... T>
std::uint64_t hash_values(const T&... values) {
  std::uint64_t h = 0x9e3779b97f4a7c15ull;
  const auto add = [&h](const auto& v) {
    static_assert(std::is_trivially_copyable_v<std::remove_cvref_t<decltype(v)>> && sizeof v <= 16);
    std::uint64_t words[2] = {0, 0};
    std::memcpy(words, &v, sizeof v);
    h = mix_bits(h ^ words[0]);
    if constexpr (sizeof v > 8) h = mix_bits(h ^ words[1]);
  };
  (add(values), ...);
  return h;
}

/// The top 24 bits as a float in [0,1).
constexpr float hash_to_float(std::uint64_t h) { return static_cast<float>(h >> 40) * 0x1p-24f; }

}  // namespace lambert
