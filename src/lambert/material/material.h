#pragma once
/// Materials: textures in, scattering model out. A closed set of descriptions plus what all of them share.

#include "lambert/base/rgb.h"
#include "lambert/bsdf/any_bsdf.h"
#include "lambert/texture/texture.h"

#include <concepts>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lambert {

using MaterialId = std::uint32_t;
inline constexpr MaterialId no_material = ~MaterialId{0};

/// Where and for which light a material is evaluated.
struct MaterialContext {
  TextureCoordinates at;
  Rgb vertex_colour{1.0f};  ///< multiplied into the base colour (glTF)
  float wavelength_nm = 0;  ///< of a path that met dispersion; 0: the middle of the spectrum (587.6)
};

/// Roughness as the file gives it: anisotropic, and whether alpha = sqrt(roughness) (pbrt) or alpha = roughness.
struct Roughness {
  FloatParameter u{0}, v{0};
  bool remap = true;
};

struct DiffuseMaterial {
  RgbParameter reflectance{Rgb(0.5f)};
};
struct DiffuseTransmissionMaterial {
  RgbParameter reflectance{Rgb(0.25f)}, transmittance{Rgb(0.25f)};
};
struct ConductorMaterial {
  RgbParameter eta{Rgb(0.2f, 0.92f, 1.1f)}, k{Rgb(3.9f, 2.45f, 2.14f)};
  RgbParameter reflectance;  ///< used instead of eta and k when `use_reflectance`
  bool use_reflectance = false;
  Roughness roughness;
};
struct DielectricMaterial {
  float eta = 1.5f;
  float abbe_number = 0;  ///< 0: no dispersion; else Cauchy's equation through V_d
  Roughness roughness;
  bool thin = false;  ///< ThinDielectric: both faces at once, no refraction
};
struct CoatedDiffuseMaterial {
  RgbParameter reflectance{Rgb(0.5f)};
  float eta = 1.5f;
  Roughness roughness;
};
struct CoatedConductorMaterial {
  float interface_eta = 1.5f;
  Roughness interface_roughness;
  ConductorMaterial conductor;
};
/// glTF 2.0 metallic-roughness and its KHR extensions, under the specification's names.
struct GltfMaterial {
  RgbParameter base_colour;
  FloatParameter metallic{1}, roughness{1};
  float ior = 1.5f;
  float dispersion = 0;  ///< 20 / V_d (KHR_materials_dispersion)
  FloatParameter specular{1};
  RgbParameter specular_colour;
  FloatParameter clearcoat{0}, clearcoat_roughness{0};
  TextureId clearcoat_normal = no_texture;
  RgbParameter sheen_colour{Rgb(0.0f)};
  FloatParameter sheen_roughness{0};
  float anisotropy = 0, anisotropy_rotation = 0;  ///< strength; radians
  TextureId anisotropy_texture = no_texture;      ///< rg: direction, b: strength
  FloatParameter iridescence{0};
  float iridescence_ior = 1.3f, iridescence_thickness_min = 100, iridescence_thickness_max = 400;  ///< nm
  FloatParameter iridescence_thickness{1};
  FloatParameter transmission{0};
  bool thin_walled = true;  ///< false when KHR_materials_volume gives a thickness
};
/// Chooses `b` with probability `amount`, else `a`, by a hash of the place (so that an image averages them).
struct MixMaterial {
  MaterialId a = no_material, b = no_material;
  FloatParameter amount{0.5f};
};

using MaterialModel = std::variant<DiffuseMaterial, DiffuseTransmissionMaterial, ConductorMaterial, DielectricMaterial,
                                   CoatedDiffuseMaterial, CoatedConductorMaterial, GltfMaterial, MixMaterial>;

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

struct Material {
  std::string name;
  MaterialModel model = DiffuseMaterial{};
  TextureId normal_map = no_texture;  ///< tangent space, 0.5 is zero, +y up (OpenGL convention)
  float normal_scale = 1;
  AlphaMode alpha_mode = AlphaMode::opaque;
  FloatParameter alpha{1};  ///< mask: solid where alpha >= cutoff; blend: solid with probability alpha
  float alpha_cutoff = 0.5f;
  Rgb absorption{0.0f};      ///< inside of closed surfaces [1/m] (Beer-Lambert)
  bool double_sided = true;  ///< false: the back of the surface lets rays pass (glTF's culling)
};

class MaterialSet {
 public:
  MaterialId add(Material m);
  std::size_t size() const { return materials_.size(); }
  const Material& operator[](MaterialId id) const { return materials_[id]; }
  Material& operator[](MaterialId id) { return materials_[id]; }
  bool is_mix(MaterialId id) const { return std::holds_alternative<MixMaterial>(materials_[id].model); }
  /// Follows mixes to a leaf; `hash` decides (see MixMaterial). Throws nothing; cycles are refused by validate().
  MaterialId resolve(MaterialId id, const TextureSet& textures, const TextureCoordinates& at, std::uint64_t hash) const;
  /// Throws Error when a mix refers to an unknown material or, through others, to itself.
  void validate() const;

 private:
  std::vector<Material> materials_;
};

/// The scattering model at a point; `material` must not be a mix (see MaterialSet::resolve).
Bsdf make_bsdf(const Material& material, const TextureSet& textures, const MaterialContext& context);
/// True when its refraction depends on the wavelength.
bool is_dispersive(const Material& material);
/// Whether a ray passes through the surface here; `u` in [0,1) decides for blended alpha.
bool alpha_passes(const Material& material, const TextureSet& textures, const TextureCoordinates& at,
                  float vertex_alpha, float u);

}  // namespace lambert
