#pragma once
#include <cstdint>

namespace lambert::polygon {

/// Stands where a number of a vertex, edge, side or item could, and there is none.
inline constexpr std::uint32_t no_index = 0xffffffffu;

}  // namespace lambert::polygon
