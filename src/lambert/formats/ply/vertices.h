#pragma once
/// The vertex element of a PLY file.

#include "lambert/formats/ply/header.h"
#include "lambert/geometry/mesh.h"

#include <array>
#include <optional>
#include <vector>

namespace lambert::ply {

inline constexpr std::size_t slot_count = 12;
inline constexpr std::array<float, slot_count> empty_slots{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};  ///< alpha 1

/// Which property fills which attribute: x y z, nx ny nz, u v, r g b a. Properties of no attribute have no slot.
class VertexLayout {
 public:
  /// Throws Error when x, y or z is missing.
  VertexLayout(const Element& vertex, const std::string& name);
  std::optional<std::size_t> slot(std::size_t property) const { return slots_[property]; }
  void allocate(TriangleMesh& mesh, std::size_t count) const;
  void store(TriangleMesh& mesh, std::size_t i, const std::array<float, slot_count>& values) const;
  /// Names of the properties that fill nothing.
  std::vector<std::string> ignored() const;

 private:
  const Element& element_;
  std::vector<std::optional<std::size_t>> slots_;
  bool has_normal_ = false, has_uv_ = false, has_colour_ = false;
  std::array<float, 4> colour_scale_{1, 1, 1, 1};
  bool srgb_ = false;
};

/// Throws Error naming the first vertex whose position, normal or uv is not finite.
void check_finite(const TriangleMesh& mesh, const std::string& name);

}  // namespace lambert::ply
