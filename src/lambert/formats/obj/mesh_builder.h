#pragma once
#include "lambert/geometry/mesh.h"

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace lambert::obj {

inline constexpr std::uint32_t no_index = ~std::uint32_t{0};

/// Indices into the file's lists; texture coordinate and normal may be missing.
struct Corner {
  std::uint32_t position = 0, uv = no_index, normal = no_index;
  bool operator==(const Corner&) const = default;
};

/// The file's lists of vertex data.
struct VertexData {
  std::vector<Vec3> positions, normals;
  std::vector<Vec4> colours;  ///< as long as positions once the file gave any, else empty
  std::vector<Vec2> uvs;
};

/// One mesh out of faces whose corners index separate lists. Corners that agree in all become one vertex.
class MeshBuilder {
 public:
  /// Corners must be in range.
  void add_face(std::span<const Corner> corners, const VertexData& data);
  /// `smooth` computes normals where the file gave none. Leaves the builder empty.
  TriangleMesh finish(bool smooth);

 private:
  struct CornerHash {
    std::size_t operator()(const Corner& c) const;
  };
  std::uint32_t vertex(const Corner& c, const VertexData& data);

  TriangleMesh mesh_;
  std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
  std::vector<std::uint32_t> face_;
  bool has_uvs_ = false, has_normals_ = false;
};

}  // namespace lambert::obj
