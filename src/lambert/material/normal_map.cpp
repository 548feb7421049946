#include "lambert/material/normal_map.h"

#include <cmath>

namespace lambert {
namespace {

/// KHR_materials_anisotropy: the texture's red and green are a direction in the tangent plane, (1, 0) without one; it
/// is turned counter-clockwise by the rotation.
Vec3 anisotropy_direction(const GltfMaterial& m, const TextureSet& textures, const TextureCoordinates& at, Vec3 ns,
                          Vec3 tangent, float bitangent_sign) {
  Vec2 d(1, 0);
  if (m.anisotropy_texture != no_texture) {
    const Texel t = textures.eval(m.anisotropy_texture, at);
    d = 2.0f * Vec2(t.x, t.y) - 1.0f;
  }
  const float cos = std::cos(m.anisotropy_rotation), sin = std::sin(m.anisotropy_rotation);
  const Frame frame = Frame::from_tangent(ns, tangent);
  return (cos * d.x - sin * d.y) * frame.s + (sin * d.x + cos * d.y) * bitangent_sign * frame.t;
}

}  // namespace

Vec3 mapped_normal(Vec3 texel, float scale, Vec3 ns, Vec3 tangent, float bitangent_sign) {
  const Frame frame = Frame::from_tangent(ns, tangent);
  const Vec3 n = 2.0f * texel - 1.0f;
  const Vec3 bent = scale * n.x * frame.s + scale * n.y * bitangent_sign * frame.t + n.z * frame.n;
  const float squared = length_squared(bent);
  return squared > 0 ? bent / std::sqrt(squared) : ns;
}

Frame shading_frame(const Material& material, const TextureSet& textures, const TextureCoordinates& at, Vec3 ng,
                    Vec3 ns, Vec3 tangent, float bitangent_sign, Vec3 wo) {
  Vec3 n = ns;
  if (material.normal_map != no_texture) {
    const Texel t = textures.eval(material.normal_map, at);
    n = mapped_normal({t.x, t.y, t.z}, material.normal_scale, ns, tangent, bitangent_sign);
  }
  constexpr float least_cos = 0.02f;
  const Vec3 visible = dot(wo, ng) < 0 ? -wo : wo;
  const float cos = dot(n, visible);
  // dot(n + (c - cos) w, w) = c
  if (cos < least_cos) n = normalize(n + (least_cos - cos) * visible);
  const auto* gltf = std::get_if<GltfMaterial>(&material.model);
  if (!gltf || gltf->anisotropy == 0) return Frame::from_tangent(n, tangent);
  return Frame::from_tangent(n, anisotropy_direction(*gltf, textures, at, ns, tangent, bitangent_sign));
}

}  // namespace lambert
