#pragma once
#include "lambert/formats/gltf/budget.h"
#include "lambert/formats/gltf/json.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambert::gltf {

/// Decompresses a buffer view; `json` is its EXT_meshopt_compression object. Throws Error at `json` when the data are
/// malformed or count and stride do not fit the mode.
std::vector<std::byte> decode_meshopt(const JsonView& json, std::span<const std::byte> compressed, Budget& budget);

}  // namespace lambert::gltf
