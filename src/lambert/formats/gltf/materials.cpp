#include "lambert/formats/gltf/materials.h"

#include "lambert/base/error.h"
#include "lambert/formats/gltf/material_extensions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::gltf {
namespace {

/// Colour and alpha of the base, whichever model it is of.
struct Base {
  RgbParameter colour;
  FloatParameter alpha;
};

Base read_metallic_roughness(const JsonView& json, Textures& textures, GltfMaterial& model) {
  const Vec4 factor = json["baseColorFactor"].vec4({1, 1, 1, 1});
  const TextureId colour = textures.add(json["baseColorTexture"], Encoding::srgb);
  const TextureId both = textures.add(json["metallicRoughnessTexture"], Encoding::linear);
  model.base_colour = {clamp(Rgb(factor.x, factor.y, factor.z), 0, 1), colour};
  model.metallic = {unit_number(json["metallicFactor"], 1), both, 2};
  model.roughness = {unit_number(json["roughnessFactor"], 1), both, 1};
  return {model.base_colour, {std::clamp(factor.w, 0.0f, 1.0f), colour, 3}};
}

Base read_base(const JsonView& json, Document& document, Textures& textures, GltfMaterial& model) {
  const JsonView glossy = json.extension("KHR_materials_pbrSpecularGlossiness");
  if (!glossy) return read_metallic_roughness(json["pbrMetallicRoughness"], textures, model);
  document.notes.add("KHR_materials_pbrSpecularGlossiness is converted to metallic-roughness");
  read_specular_glossiness(glossy, textures, model);
  const float alpha = glossy["diffuseFactor"].vec4({1, 1, 1, 1}).w;
  return {model.base_colour, {std::clamp(alpha, 0.0f, 1.0f), model.base_colour.texture, 3}};
}

void read_alpha(const JsonView& json, const FloatParameter& alpha, Material& material) {
  const std::vector<std::string> modes{"OPAQUE", "MASK", "BLEND"};
  const std::string mode = json["alphaMode"].text("OPAQUE");
  if (mode == "OPAQUE") return;
  if (mode != "MASK" && mode != "BLEND") json["alphaMode"].fail("unknown mode " + unknown_word(mode, modes));
  material.alpha_mode = mode == "MASK" ? AlphaMode::mask : AlphaMode::blend;
  material.alpha = alpha;
  material.alpha_cutoff = json["alphaCutoff"].number(0.5f);
}

std::optional<Emission> read_emission(const JsonView& json, Textures& textures, bool two_sided) {
  const Vec3 factor = glm::max(json["emissiveFactor"].vec3({0, 0, 0}), Vec3(0));
  const JsonView strength = json.extension("KHR_materials_emissive_strength")["emissiveStrength"];
  const Vec3 radiance = factor * std::max(strength.number(1), 0.0f);
  if (radiance == Vec3(0)) return std::nullopt;
  if (!std::isfinite(radiance.x + radiance.y + radiance.z)) strength.fail("the emission is too large");
  const TextureId texture = textures.add(json["emissiveTexture"], Encoding::srgb);
  return Emission{{Rgb(radiance.x, radiance.y, radiance.z), texture}, two_sided};
}

}  // namespace

SurfaceMaterial Materials::get(const JsonView& reference) {
  if (!reference) {
    if (!default_) default_ = read(reference);
    return *default_;
  }
  const JsonView json = document_->referred("materials", reference);
  const auto known = known_.find(reference.count());
  return known != known_.end() ? known->second : known_.emplace(reference.count(), read(json)).first->second;
}

SurfaceMaterial Materials::read(const JsonView& json) {
  Material material;
  material.name = json["name"].text(json ? "" : "glTF default");
  material.double_sided = json["doubleSided"].boolean(false);
  GltfMaterial model;
  const Base base = read_base(json, *document_, textures_, model);
  read_material_extensions(json, textures_, model);
  read_alpha(json, base.alpha, material);
  if (json["occlusionTexture"])
    document_->notes.add("glTF occlusion textures are ignored: occlusion is what is computed");

  SurfaceMaterial surface;
  if (json.extension("KHR_materials_unlit")) {
    material.model = DiffuseMaterial{{Rgb(0.0f)}};
    surface.emission = Emission{base.colour, material.double_sided, false};
  } else {
    const JsonView normal = json["normalTexture"];
    material.normal_map = textures_.add(normal, Encoding::linear);
    material.normal_scale = normal["scale"].number(1);
    if (!model.thin_walled) {
      material.absorption = volume_absorption(json.extension("KHR_materials_volume"));
      // Light must leave through the back of the surface, whatever a rasterizer culls.
      material.double_sided = true;
    }
    surface.emission = read_emission(json, textures_, json["doubleSided"].boolean(false));
    material.model = model;
  }
  surface.id = set_->add(std::move(material));
  return surface;
}

}  // namespace lambert::gltf
