#pragma once
#include "lambert/formats/gltf/textures.h"
#include "lambert/material/material.h"

namespace lambert::gltf {

/// A factor: limited to [0,1].
float unit_number(const JsonView& json, float fallback);
Rgb unit_colour(const JsonView& json, Rgb fallback);

/// The index of refraction for KHR_materials_ior. 0 stands for a Fresnel term of 1 in the extension; here it becomes an
/// index so large that its reflectance at normal incidence is 0.996.
float index_of_refraction(const JsonView& json);

/// Fills `model` from the KHR_materials extensions of the material `json`: clearcoat, sheen, specular, ior,
/// transmission, volume's thickness, anisotropy, iridescence and dispersion.
void read_material_extensions(const JsonView& json, Textures& textures, GltfMaterial& model);

/// Beer-Lambert coefficients [1/m] of KHR_materials_volume.
Rgb volume_absorption(const JsonView& volume);

/// KHR_materials_pbrSpecularGlossiness as a metallic-roughness material: the specular colour becomes the reflectance at
/// normal incidence of a dielectric whose index is very large.
void read_specular_glossiness(const JsonView& json, Textures& textures, GltfMaterial& model);

}  // namespace lambert::gltf
