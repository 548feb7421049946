#include "lambert/formats/obj/mtl_material.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/io.h"

#include <algorithm>
#include <cmath>

namespace lambert::obj {
namespace {

enum class Channel { colour, scalar, opacity };

class Converter {
 public:
  Converter(SceneGraph& graph, const MtlMaterial& mtl, const std::filesystem::path& folder, Notes& notes)
      : graph_(graph), mtl_(mtl), folder_(folder), notes_(notes) {}

  ConvertedMaterial convert(const std::string& name) {
    Material m;
    m.name = name;
    m.model = model();
    if (!is_glass()) set_opacity(m);
    m.normal_map = load(mtl_.normal_map, Channel::scalar).texture;
    m.normal_scale = mtl_.normal_map.multiplier;
    ConvertedMaterial converted;
    converted.emission = emission();
    converted.material = graph_.materials.add(std::move(m));
    return converted;
  }

 private:
  struct Loaded {
    TextureId texture = no_texture;
    bool has_alpha = false;
  };

  bool is_transparent() const { return mtl_.dissolve.value_or(1) < 1; }
  bool is_glass() const {
    const int i = mtl_.illumination;
    return i == 6 || i == 7 || ((i == 4 || i == 9) && is_transparent());
  }

  MaterialModel model() {
    if (is_glass()) {
      DielectricMaterial glass;
      glass.eta = std::clamp(mtl_.ni.value_or(1.5f), 1.0f, 10.0f);
      return glass;
    }
    if (mtl_.illumination == 5 && !mtl_.has_pbr_keys()) {
      ConductorMaterial mirror;
      mirror.use_reflectance = true;
      mirror.reflectance.value = clamp(mtl_.ks.value_or(Rgb(1.0f)), 0, 1);
      return mirror;
    }
    const bool shines = mtl_.illumination >= 2 && !is_black(mtl_.ks.value_or(Rgb()));
    if (!shines && !mtl_.has_pbr_keys()) return DiffuseMaterial{coloured(mtl_.kd, mtl_.map_kd)};
    return metallic_roughness();
  }

  GltfMaterial metallic_roughness() {
    GltfMaterial m;
    m.base_colour = coloured(mtl_.kd, mtl_.map_kd);
    m.metallic = scaled(mtl_.metallic.value_or(mtl_.map_metallic.file.empty() ? 0.0f : 1.0f), mtl_.map_metallic);
    // Blinn-Phong's exponent as a microfacet width, alpha² = 2 / (Ns + 2) (Walter et al. 2007); glTF's roughness is
    // the root of alpha.
    const float from_exponent = std::pow(2 / (std::max(mtl_.ns.value_or(0), 0.0f) + 2), 0.25f);
    const float roughness = mtl_.roughness.value_or(mtl_.ns                           ? from_exponent
                                                    : mtl_.map_roughness.file.empty() ? 0.5f
                                                                                      : 1);
    m.roughness = scaled(std::clamp(roughness, 0.0f, 1.0f), mtl_.map_roughness);
    m.ior = mtl_.ni ? std::clamp(*mtl_.ni, 1.0f, 10.0f) : 1.5f;
    if (mtl_.ks && !mtl_.roughness) m.specular_colour.value = max(*mtl_.ks * 2.0f, Rgb()), m.ior = 1.5f;
    m.clearcoat.value = std::clamp(mtl_.clearcoat.value_or(0), 0.0f, 1.0f);
    m.clearcoat_roughness.value = std::clamp(mtl_.clearcoat_roughness.value_or(0), 0.0f, 1.0f);
    m.sheen_colour.value = Rgb(std::clamp(mtl_.sheen.value_or(0), 0.0f, 1.0f));
    m.sheen_roughness.value = 0.5f;
    m.anisotropy = std::clamp(mtl_.anisotropy.value_or(0), 0.0f, 1.0f);
    m.anisotropy_rotation = mtl_.anisotropy_rotation.value_or(0) * 2 * pi;
    return m;
  }

  void set_opacity(Material& m) {
    m.alpha.value = std::clamp(mtl_.dissolve.value_or(1), 0.0f, 1.0f);
    const Loaded map = load(mtl_.map_dissolve, Channel::opacity);
    m.alpha.texture = map.texture;
    m.alpha.channel = map.has_alpha ? 3 : 0;
    if (is_transparent() || map.texture != no_texture) m.alpha_mode = AlphaMode::blend;
  }

  std::optional<Emission> emission() {
    if (is_black(mtl_.ke.value_or(Rgb())) && mtl_.map_ke.file.empty()) return std::nullopt;
    Emission e;
    e.radiance = coloured(mtl_.ke, mtl_.map_ke);
    e.two_sided = true;
    return e;
  }

  RgbParameter coloured(const std::optional<Rgb>& colour, const MtlMap& map) {
    const TextureId texture = load(map, Channel::colour).texture;
    const Rgb without_map = max(colour.value_or(Rgb(0.5f)), Rgb());
    if (texture == no_texture) return {without_map};
    return {!colour || is_black(without_map) ? Rgb(1.0f) : without_map, texture};
  }
  FloatParameter scaled(float value, const MtlMap& map) { return {value, load(map, Channel::scalar).texture}; }

  Loaded load(const MtlMap& map, Channel channel) {
    if (map.file.empty()) return {};
    try {
      const std::filesystem::path path = folder_ / map.file;
      const MappedFile file(path);
      Texels texels = decode_texels(file.bytes(), path.string());
      Loaded loaded;
      loaded.has_alpha = channel == Channel::opacity && texels.channels % 2 == 0;
      MipMap::Settings settings;
      settings.srgb = channel == Channel::colour && !texels.bytes.empty();
      settings.wrap_u = settings.wrap_v = map.clamp ? EdgeMode::clamp : EdgeMode::repeat;
      ImageTexture texture;
      texture.image = std::make_shared<const MipMap>(std::move(texels), settings);
      texture.uv.matrix = uv_matrix(map);
      loaded.texture = graph_.textures.add(texture);
      return loaded;
    } catch (const Error& e) {
      notes_.add(std::string("MTL: a texture is left out: ") + e.what());
      return {};
    }
  }

  // MTL transforms (u, v) with v upwards, u' = s u + o; meshes here have v downwards, v = 1 - v_down.
  static glm::mat3x2 uv_matrix(const MtlMap& map) {
    return {map.scale.x, 0, 0, map.scale.y, map.offset.x, 1 - map.scale.y - map.offset.y};
  }

  SceneGraph& graph_;
  const MtlMaterial& mtl_;
  const std::filesystem::path& folder_;
  Notes& notes_;
};

}  // namespace

ConvertedMaterial add_mtl_material(SceneGraph& graph, const std::string& name, const MtlMaterial& mtl,
                                   const std::filesystem::path& folder, Notes& notes) {
  return Converter(graph, mtl, folder, notes).convert(name);
}

}  // namespace lambert::obj
