#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace lambert::gltf {

/// The two parts of a document.
struct Container {
  std::string_view json;
  std::span<const std::byte> binary;  ///< GLB's BIN chunk; empty when there is none
};

/// Takes a GLB file apart; anything else counts as JSON. Throws Error with `name` and byte offset when the GLB is
/// truncated, of another version, or its chunks do not fit.
Container split_container(std::span<const std::byte> data, const std::string& name);

}  // namespace lambert::gltf
