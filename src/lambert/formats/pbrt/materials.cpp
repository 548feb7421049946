#include "lambert/formats/pbrt/materials.h"

#include "lambert/formats/pbrt/image_textures.h"
#include "lambert/formats/pbrt/old_syntax.h"
#include "lambert/formats/pbrt/textures.h"

#include <array>

namespace lambert::pbrt {
namespace {

RgbParameter reflectance(const Context& c, const ParameterList& list, const char* name, float fallback) {
  return rgb_parameter(c, list, name, Rgb(fallback), SpectrumRole::reflectance);
}

/// `prefix` is "", "interface." or "conductor.".
Roughness roughness(const Context& c, const ParameterList& list, const std::string& prefix) {
  Roughness r;
  const FloatParameter both = float_parameter(c, list, prefix + "roughness", 0);
  const auto one = [&](const std::string& name) { return list.has(name) ? float_parameter(c, list, name, 0) : both; };
  r.u = one(prefix + "uroughness"), r.v = one(prefix + "vroughness");
  r.remap = list.boolean("remaproughness", true);
  return r;
}

DiffuseMaterial diffuse(const Context& c, const ParameterList& list) {
  return {reflectance(c, list, "reflectance", 0.5f)};
}

DiffuseTransmissionMaterial diffuse_transmission(const Context& c, const ParameterList& list) {
  DiffuseTransmissionMaterial m;
  m.reflectance = reflectance(c, list, "reflectance", 0.25f);
  m.transmittance = reflectance(c, list, "transmittance", 0.25f);
  const float scale = list.number("scale", 1);
  m.reflectance.value *= scale, m.transmittance.value *= scale;
  return m;
}

/// `prefix` is "" or "conductor.".
ConductorMaterial conductor(const Context& c, const ParameterList& list, const std::string& prefix) {
  ConductorMaterial m;
  m.use_reflectance = list.has("reflectance");
  if (m.use_reflectance) {
    if (list.has(prefix + "eta") || list.has(prefix + "k")) list.fail("takes 'reflectance' or 'eta' and 'k', not both");
    m.reflectance = reflectance(c, list, "reflectance", 1);
  } else {
    const MetalData copper = named_metal("Cu").value_or(MetalData{m.eta.value, m.k.value});
    m.eta = rgb_parameter(c, list, prefix + "eta", copper.eta, SpectrumRole::unbounded);
    m.k = rgb_parameter(c, list, prefix + "k", copper.k, SpectrumRole::unbounded);
  }
  m.roughness = roughness(c, list, prefix);
  return m;
}

DielectricMaterial dielectric(const Context& c, const ParameterList& list) {
  DielectricMaterial m;
  const GlassData glass = index_of_refraction(c, list, "eta");
  m.eta = glass.eta, m.abbe_number = glass.abbe_number;
  m.roughness = roughness(c, list, "");
  return m;
}

DielectricMaterial thin_dielectric(const Context& c, const ParameterList& list) {
  DielectricMaterial m;
  m.eta = index_of_refraction(c, list, "eta").eta;
  m.thin = true;
  return m;
}

CoatedDiffuseMaterial coated_diffuse(const Context& c, const ParameterList& list) {
  CoatedDiffuseMaterial m;
  m.reflectance = reflectance(c, list, "reflectance", 0.5f);
  m.eta = index_of_refraction(c, list, "eta").eta;
  m.roughness = roughness(c, list, "");
  return m;
}

CoatedConductorMaterial coated_conductor(const Context& c, const ParameterList& list) {
  CoatedConductorMaterial m;
  m.interface_eta = index_of_refraction(c, list, "interface.eta").eta;
  m.interface_roughness = roughness(c, list, "interface.");
  m.conductor = conductor(c, list, "conductor.");
  return m;
}

MaterialId named(const Context& c, const ParameterList& list, const std::string& name) {
  const auto found = c.named_materials.find(name);
  if (found != c.named_materials.end() && !found->second) list.fail("cannot mix with an interface material");
  if (found != c.named_materials.end()) return *found->second;
  std::vector<std::string> known;
  for (const auto& entry : c.named_materials) known.push_back(entry.first);
  list.fail("unknown material " + unknown_word(name, known));
}

MixMaterial mix(const Context& c, const ParameterList& list) {
  const std::vector<std::string> names = list.strings("materials");
  if (names.size() != 2) list.fail("takes \"string materials\" with two names");
  return {named(c, list, names[0]), named(c, list, names[1]), float_parameter(c, list, "amount", 0.5f)};
}

/// Parameters of pbrt's layered models that Lambert's do not have.
void note_layer_parameters(const Context& c, const ParameterList& list) {
  for (const char* name : {"thickness", "interface.thickness", "albedo", "g", "maxdepth", "nsamples"}) {
    if (!list.has(name)) continue;
    c.notes.add(std::string("layered materials: '") + name + "' is ignored");
    list.find(name, {ParameterType::floating, ParameterType::integer, ParameterType::rgb, ParameterType::spectrum,
                     ParameterType::texture});
  }
}

std::optional<MaterialModel> make_model(const Context& c, const ParameterList& list, const std::string& type) {
  if (type == "diffuse") return diffuse(c, list);
  if (type == "diffusetransmission") return diffuse_transmission(c, list);
  if (type == "conductor") return conductor(c, list, "");
  if (type == "dielectric") return dielectric(c, list);
  if (type == "thindielectric") return thin_dielectric(c, list);
  if (type == "mix") return mix(c, list);
  if (type == "coateddiffuse" || type == "coatedconductor") {
    note_layer_parameters(c, list);
    if (type == "coateddiffuse") return coated_diffuse(c, list);
    return coated_conductor(c, list);
  }
  if (type == "interface" || type.empty()) return std::nullopt;
  fail_unknown_type(list, "material", type, material_types(), old_material_hint(type));
}

}  // namespace

std::vector<std::string> material_types() {
  return {"diffuse",         "conductor",           "dielectric", "thindielectric", "coateddiffuse",
          "coatedconductor", "diffusetransmission", "mix",        "interface"};
}

std::optional<MaterialId> add_material(Context& context, const ParameterList& list, const std::string& type,
                                       const std::string& name) {
  auto model = make_model(context, list, type);
  if (!model) return std::nullopt;
  Material m;
  m.name = name.empty() ? type : name;
  m.model = std::move(*model);
  if (const std::string file = list.string("normalmap", ""); !file.empty()) {
    m.normal_map = add_normal_map(context, list, file);
  }
  return context.graph.materials.add(std::move(m));
}

MaterialId with_alpha(Context& context, MaterialId material, const FloatParameter& alpha) {
  if (alpha.texture == no_texture && alpha.value >= 1) return material;
  const auto [entry, is_new] =
      context.materials_with_alpha.try_emplace({material, alpha.value, alpha.texture}, material);
  if (is_new) {
    Material m = context.graph.materials[material];
    if (auto* mixed = std::get_if<MixMaterial>(&m.model)) {
      mixed->a = with_alpha(context, mixed->a, alpha);
      mixed->b = with_alpha(context, mixed->b, alpha);
    } else {
      m.alpha_mode = AlphaMode::blend;
      m.alpha = alpha;
    }
    entry->second = context.graph.materials.add(std::move(m));
  }
  return entry->second;
}

}  // namespace lambert::pbrt
