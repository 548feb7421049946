#pragma once
#include "lambert/formats/gltf/document.h"

namespace lambert::gltf {

/// Throws Error when "asset" asks for another version than 2.0, or "extensionsRequired" for an extension that is not
/// known; notes the unknown ones of "extensionsUsed".
void check_version_and_extensions(Document& document);

}  // namespace lambert::gltf
