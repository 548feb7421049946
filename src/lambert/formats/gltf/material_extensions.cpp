#include "lambert/formats/gltf/material_extensions.h"

#include <algorithm>
#include <cmath>

namespace lambert::gltf {
namespace {

constexpr float huge_ior = 1000;

FloatParameter float_parameter(const JsonView& factor, float fallback, TextureId texture, int channel) {
  return {unit_number(factor, fallback), texture, channel};
}

void read_clearcoat(const JsonView& json, Textures& textures, GltfMaterial& model) {
  model.clearcoat =
      float_parameter(json["clearcoatFactor"], 0, textures.add(json["clearcoatTexture"], Encoding::linear), 0);
  model.clearcoat_roughness = float_parameter(json["clearcoatRoughnessFactor"], 0,
                                              textures.add(json["clearcoatRoughnessTexture"], Encoding::linear), 1);
  model.clearcoat_normal = textures.add(json["clearcoatNormalTexture"], Encoding::linear);
}

void read_sheen(const JsonView& json, Textures& textures, GltfMaterial& model) {
  model.sheen_colour = {unit_colour(json["sheenColorFactor"], Rgb(0.0f)),
                        textures.add(json["sheenColorTexture"], Encoding::srgb)};
  model.sheen_roughness = float_parameter(json["sheenRoughnessFactor"], 0,
                                          textures.add(json["sheenRoughnessTexture"], Encoding::linear), 3);
}

void read_specular(const JsonView& json, Textures& textures, GltfMaterial& model) {
  model.specular =
      float_parameter(json["specularFactor"], 1, textures.add(json["specularTexture"], Encoding::linear), 3);
  // May exceed 1: the product with the reflectance of the index is what is limited.
  const Vec3 colour = glm::max(json["specularColorFactor"].vec3({1, 1, 1}), Vec3(0));
  model.specular_colour = {Rgb(colour.x, colour.y, colour.z),
                           textures.add(json["specularColorTexture"], Encoding::srgb)};
}

void read_anisotropy(const JsonView& json, Textures& textures, GltfMaterial& model) {
  model.anisotropy = unit_number(json["anisotropyStrength"], 0);
  model.anisotropy_rotation = json["anisotropyRotation"].number(0);
  model.anisotropy_texture = textures.add(json["anisotropyTexture"], Encoding::linear);
}

void read_iridescence(const JsonView& json, Textures& textures, GltfMaterial& model) {
  model.iridescence =
      float_parameter(json["iridescenceFactor"], 0, textures.add(json["iridescenceTexture"], Encoding::linear), 0);
  model.iridescence_ior = std::max(json["iridescenceIor"].number(1.3f), 1.0f);
  model.iridescence_thickness_min = std::max(json["iridescenceThicknessMinimum"].number(100), 0.0f);
  model.iridescence_thickness_max = std::max(json["iridescenceThicknessMaximum"].number(400), 0.0f);
  model.iridescence_thickness = {1, textures.add(json["iridescenceThicknessTexture"], Encoding::linear), 1};
}

}  // namespace

float unit_number(const JsonView& json, float fallback) { return std::clamp(json.number(fallback), 0.0f, 1.0f); }

Rgb unit_colour(const JsonView& json, Rgb fallback) {
  const Vec3 c = json.vec3({fallback.r, fallback.g, fallback.b});
  return clamp(Rgb(c.x, c.y, c.z), 0, 1);
}

float index_of_refraction(const JsonView& json) {
  const float ior = json.number(1.5f);
  if (ior == 0) return huge_ior;
  if (!(ior >= 1)) json.fail("expected 0 or at least 1");
  return std::min(ior, huge_ior);
}

void read_material_extensions(const JsonView& json, Textures& textures, GltfMaterial& model) {
  if (const JsonView e = json.extension("KHR_materials_clearcoat")) read_clearcoat(e, textures, model);
  if (const JsonView e = json.extension("KHR_materials_sheen")) read_sheen(e, textures, model);
  if (const JsonView e = json.extension("KHR_materials_specular")) read_specular(e, textures, model);
  if (const JsonView e = json.extension("KHR_materials_anisotropy")) read_anisotropy(e, textures, model);
  if (const JsonView e = json.extension("KHR_materials_iridescence")) read_iridescence(e, textures, model);
  if (const JsonView e = json.extension("KHR_materials_ior")) model.ior = index_of_refraction(e["ior"]);
  if (const JsonView e = json.extension("KHR_materials_dispersion"))
    model.dispersion = std::max(e["dispersion"].number(0), 0.0f);
  if (const JsonView e = json.extension("KHR_materials_transmission"))
    model.transmission =
        float_parameter(e["transmissionFactor"], 0, textures.add(e["transmissionTexture"], Encoding::linear), 0);
  const JsonView volume = json.extension("KHR_materials_volume");
  model.thin_walled = !(volume["thicknessFactor"].number(0) > 0);
}

/// T(d) = c^(d / distance) = exp(-sigma d), so sigma = -ln(c) / distance.
Rgb volume_absorption(const JsonView& volume) {
  const JsonView distance = volume["attenuationDistance"];
  if (!distance) return Rgb(0.0f);
  const float d = distance.number();
  if (!(d > 0)) distance.fail("expected more than 0");
  const Rgb c = max(unit_colour(volume["attenuationColor"], Rgb(1.0f)), Rgb(1e-6f));
  // Kept finite for the smallest distances.
  return clamp(Rgb(-std::log(c.r), -std::log(c.g), -std::log(c.b)) / std::max(d, 1e-30f), 0, 1e30f);
}

void read_specular_glossiness(const JsonView& json, Textures& textures, GltfMaterial& model) {
  const Vec4 diffuse = json["diffuseFactor"].vec4({1, 1, 1, 1});
  model.base_colour = {clamp(Rgb(diffuse.x, diffuse.y, diffuse.z), 0, 1),
                       textures.add(json["diffuseTexture"], Encoding::srgb)};
  model.metallic = {0, no_texture, 0};
  model.ior = huge_ior;
  const float f0 = sqr((huge_ior - 1) / (huge_ior + 1));
  const JsonView texture = json["specularGlossinessTexture"];
  model.specular_colour = {unit_colour(json["specularFactor"], Rgb(1.0f)) / f0, textures.add(texture, Encoding::srgb)};
  const float glossiness = unit_number(json["glossinessFactor"], 1);
  model.roughness = {1 - glossiness, no_texture, 0};
  const TextureId roughness = texture ? textures.add_roughness_of_glossiness(texture, glossiness) : no_texture;
  if (roughness != no_texture) model.roughness = {1, roughness, 0};
}

}  // namespace lambert::gltf
