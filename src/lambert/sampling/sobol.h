#pragma once
/// The first two dimensions of Sobol's sequence and hashed Owen scrambling, on 32-bit integers that stand for x / 2^32.

#include <cstdint>

namespace lambert {

inline std::uint32_t reverse_bits(std::uint32_t v) {
  v = __builtin_bswap32(v);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v >> 4) & 0x0f0f0f0fu);
  v = ((v & 0x33333333u) << 2) | ((v >> 2) & 0x33333333u);
  return ((v & 0x55555555u) << 1) | ((v >> 1) & 0x55555555u);
}

/// The bits of `i` times Pascal's triangle modulo 2, which is the Kronecker power of [[1,1],[0,1]]: one step a factor.
/// reverse_bits of it is the second dimension of Sobol's sequence; reverse_bits(i) is the first.
inline std::uint32_t pascal_bits(std::uint32_t i) {
  i ^= (i >> 1) & 0x55555555u;
  i ^= (i >> 2) & 0x33333333u;
  i ^= (i >> 4) & 0x0f0f0f0fu;
  i ^= (i >> 8) & 0x00ff00ffu;
  return i ^ (i >> 16);
}

/// A permutation of 32-bit numbers in which each bit depends on lower ones only: Owen scrambling of bit-reversed
/// numbers (Laine and Karras 2011; constants of Vegdahl 2021).
inline std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

}  // namespace lambert
