#pragma once
/// Eight floats at once, in the vectors of GCC and Clang, which make two of four where the machine has no wider ones.

#include <cstddef>
#include <cstring>

namespace lambert {

using Lanes = float __attribute__((vector_size(32)));
inline constexpr std::size_t lane_count = 8;

inline Lanes load_lanes(const float* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void store_lanes(float* p, const Lanes& v) { std::memcpy(p, &v, sizeof v); }

/// Eight rows of eight become eight columns: to[j * to_stride + i] = from[i * from_stride + j].
inline void transpose_8x8(const float* from, std::size_t from_stride, float* to, std::size_t to_stride) {
  Lanes a[8], b[8];
  for (std::size_t i = 0; i < 8; ++i) a[i] = load_lanes(from + i * from_stride);
  for (std::size_t i = 0; i < 4; ++i) {
    b[2 * i] = __builtin_shufflevector(a[2 * i], a[2 * i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    b[2 * i + 1] = __builtin_shufflevector(a[2 * i], a[2 * i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      a[4 * i + 2 * j] = __builtin_shufflevector(b[4 * i + j], b[4 * i + j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      a[4 * i + 2 * j + 1] = __builtin_shufflevector(b[4 * i + j], b[4 * i + j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (std::size_t i = 0; i < 4; ++i) {
    b[i] = __builtin_shufflevector(a[i], a[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    b[i + 4] = __builtin_shufflevector(a[i], a[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
  for (std::size_t i = 0; i < 8; ++i) store_lanes(to + i * to_stride, b[i]);
}

}  // namespace lambert
