#pragma once
#include "lambert/formats/gltf/document.h"
#include "lambert/image/io.h"
#include "lambert/texture/texture.h"

#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace lambert::gltf {

/// What the colour channels of an image hold.
enum class Encoding { linear, srgb };

/// Turns textureInfo objects into textures of the scene; each image is decoded once per kind of use.
class Textures {
 public:
  Textures(Document& document, TextureSet& set) : document_(&document), set_(&set) {}

  /// no_texture when `info` is absent or its image is of a kind that is not read (which is noted).
  TextureId add(const JsonView& info, Encoding encoding);
  /// One channel: roughness 1 - factor * (the image's alpha), for KHR_materials_pbrSpecularGlossiness.
  TextureId add_roughness_of_glossiness(const JsonView& info, float factor);

 private:
  struct Source {
    JsonView image;
    MipMap::Settings settings;
  };
  std::optional<Source> source_of(const JsonView& info);
  std::optional<Texels> decode(const JsonView& image);
  std::shared_ptr<const MipMap> mip_map(const Source& source);

  Document* document_;
  TextureSet* set_;
  std::map<std::tuple<std::string, EdgeMode, EdgeMode, TextureFilter, bool>, std::shared_ptr<const MipMap>> images_;
};

/// KHR_texture_transform, and which set of coordinates `info` reads.
UvTransform uv_transform(const JsonView& info, Notes& notes);

}  // namespace lambert::gltf
