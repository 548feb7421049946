#pragma once
#include "lambert/formats/gltf/document.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lambert::gltf {

/// A mesh that was compressed by Draco: a triangle list and one array per attribute of the extension.
struct DracoMesh {
  struct Attribute {
    std::size_t components = 0;
    std::vector<float> floats;  ///< normalized integers are [0,1] or [-1,1]
  };
  std::size_t vertex_count = 0;
  std::vector<std::uint32_t> indices;
  std::map<std::string, Attribute> attributes;
};

/// `primitive` has the extension KHR_draco_mesh_compression. Throws Error there when the data are malformed or have
/// more faces than the accessor of the indices says.
DracoMesh decode_draco(Document& document, const JsonView& primitive);

}  // namespace lambert::gltf
