#pragma once
#include <array>
#include <cstdint>

namespace lambert::polygon {

/// Indices of three vertices, counter-clockwise unless said otherwise.
using Triangle = std::array<std::uint32_t, 3>;

}  // namespace lambert::polygon
