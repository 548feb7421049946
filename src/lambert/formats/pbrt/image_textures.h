#pragma once
#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

/// The "uv" mapping (uscale, vscale, udelta, vdelta). pbrt's v runs up the image, MipMap's runs down; `flip` turns it.
UvTransform uv_mapping(const ParameterList& list, bool flip);

/// The class "imagemap": filename, encoding, filter, wrap, scale, invert and the mapping. `single` asks for one
/// channel: alpha where the image has any, else the mean of its colours (as pbrt does).
ImageTexture image_texture(Context& context, const ParameterList& list, bool single);

/// The image that a light shines through: colours with the parameter "encoding" and default settings.
TextureId add_plain_image(Context& context, const ParameterList& list, const std::string& filename);
/// Numbers as the file stores them.
TextureId add_normal_map(Context& context, const ParameterList& list, const std::string& filename);

}  // namespace lambert::pbrt
