#pragma once
#include "lambert/formats/gltf/json.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lambert::gltf {

/// Which elements to read, in increasing order; empty: all.
using Selection = std::vector<std::uint32_t>;

/// How an accessor's numbers are stored.
struct ComponentType {
  std::size_t code = 5126;  ///< 5120 … 5126, as in the specification
  std::size_t size = 4;     ///< bytes
};
/// Throws Error at `place` (a "componentType" member) for an unknown one.
ComponentType component_type(const JsonView& place);
/// The factor of a normalized integer: 1 / its largest value; 1 for floats.
float normalization(ComponentType type);

/// Numbers in memory: `count` elements of `components` each, `stride` bytes apart.
struct Elements {
  std::span<const std::byte> bytes;  ///< from the first element on; empty: all zeros
  std::size_t count = 0, components = 1, stride = 0;
  ComponentType type;
  bool normalized = false;

  std::size_t element_size() const { return components * type.size; }
  /// Makes `all`, from `offset` on, the memory. Throws Error at `place` unless every element lies inside.
  void lay_over(std::span<const std::byte> all, std::size_t offset, const JsonView& place);
  /// Fills `out` (components floats per element) with the selected elements; normalized integers become [0,1] or
  /// [-1,1].
  void read(const Selection& selection, std::span<float> out) const;
  /// One unsigned integer per element; `components` must be 1 and the type one of them.
  std::vector<std::uint32_t> integers() const;
};

}  // namespace lambert::gltf
