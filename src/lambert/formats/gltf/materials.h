#pragma once
#include "lambert/formats/gltf/textures.h"
#include "lambert/light/light.h"
#include "lambert/material/material.h"

#include <map>
#include <optional>

namespace lambert::gltf {

/// What a primitive needs of its material.
struct SurfaceMaterial {
  MaterialId id = no_material;
  std::optional<Emission> emission;
};

/// The materials of a document, added to the scene when they are first asked for.
class Materials {
 public:
  Materials(Document& document, TextureSet& textures, MaterialSet& set)
      : document_(&document), textures_(document, textures), set_(&set) {}

  /// `reference` is a member that holds a material's index, or an absent one for the default material.
  SurfaceMaterial get(const JsonView& reference);

 private:
  SurfaceMaterial read(const JsonView& json);

  Document* document_;
  Textures textures_;
  MaterialSet* set_;
  std::map<std::size_t, SurfaceMaterial> known_;
  std::optional<SurfaceMaterial> default_;
};

}  // namespace lambert::gltf
