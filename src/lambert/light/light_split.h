#pragma once
#include "lambert/light/light_bounds.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace lambert {

/// Reorders `lights` (at least two indices into `bounds`) and returns where their second part begins: where the surface
/// area orientation heuristic is least (Conty Estevez and Kulla 2018, sec. 4.4), tried at the borders of buckets along
/// each axis.
std::size_t split_by_orientation(std::span<const LightBounds> bounds, std::span<std::uint32_t> lights);

/// The same in two equal parts along the longest axis.
std::size_t split_in_halves(std::span<const LightBounds> bounds, std::span<std::uint32_t> lights);

}  // namespace lambert
