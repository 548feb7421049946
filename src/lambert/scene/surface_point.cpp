#include "lambert/base/hash.h"
#include "lambert/scene/compiled.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

template <class T>
T interpolate(const std::vector<T>& values, const Triangle& t, Vec2 b) {
  return (1 - b.x - b.y) * values[t[0]] + b.x * values[t[1]] + b.y * values[t[2]];
}

Vec2 corner_uv(const TriangleMesh& mesh, const Triangle& t, std::size_t corner) {
  return mesh.uvs.empty() ? default_uv(static_cast<int>(corner)) : mesh.uvs[t[corner]];
}

Vec2 uv_at(const TriangleMesh& mesh, const Triangle& t, Vec2 b) {
  return mesh.uvs.empty() ? b : interpolate(mesh.uvs, t, b);
}

/// Along ∂p/∂u, which is (d2.y e1 - d1.y e2) / (d1 x d2), from two edges and their texture coordinates; any edge where
/// those are degenerate.
Vec3 tangent_of(Vec3 e1, Vec3 e2, Vec2 d1, Vec2 d2, float determinant) {
  return determinant != 0 ? std::copysign(1.0f, determinant) * (d2.y * e1 - d1.y * e2) : e1;
}

Vec3 normalized_or(Vec3 v, Vec3 fallback) {
  const float squared = dot(v, v);
  return squared > 0 ? v * (1 / std::sqrt(squared)) : fallback;
}

/// Unit vectors of vertices, mapped and made unit before they are interpolated, as transformed() does: a mesh looks the
/// same however often it is placed.
template <class V, class Map>
Vec3 interpolate_mapped(const std::vector<V>& values, const Triangle& t, Vec2 b, const Map& map) {
  const auto corner = [&](std::size_t i) { return normalized_or(map(Vec3(values[t[i]])), Vec3(0)); };
  return (1 - b.x - b.y) * corner(0) + b.x * corner(1) + b.y * corner(2);
}

void fill_from_mesh(SurfacePoint& point, const CompiledSurface& s, const Hit& hit) {
  const TriangleMesh& mesh = *s.mesh;
  const Triangle& t = mesh.triangles[hit.primitive];
  const Vec2 b = hit.barycentric;
  Vec3 p0 = mesh.positions[t[0]], e1 = mesh.positions[t[1]] - p0, e2 = mesh.positions[t[2]] - p0;
  if (s.instanced) p0 = s.to_world.point(p0), e1 = s.to_world.vector(e1), e2 = s.to_world.vector(e2);
  // From the vertices: more precise than along the ray.
  point.position = p0 + b.x * e1 + b.y * e2;
  const Vec3 face = cross(e1, e2);
  const float twice_area = length(face);
  const float inverse_area = twice_area > 0 ? 1 / twice_area : 0;
  point.ng = twice_area > 0 ? face * inverse_area : Vec3(0, 0, 1);
  if (s.instanced && s.to_world.swaps_handedness()) point.ng = -point.ng;
  point.ns = point.ng;
  if (!mesh.normals.empty()) {
    const auto map = [&](Vec3 n) { return s.to_world.normal(n); };
    const Vec3 n = s.instanced ? interpolate_mapped(mesh.normals, t, b, map) : interpolate(mesh.normals, t, b);
    point.ns = normalized_or(n, point.ng);
  }

  point.uv = uv_at(mesh, t, b);
  point.uv1 = mesh.uvs1.empty() ? point.uv : interpolate(mesh.uvs1, t, b);
  if (!mesh.colours.empty()) point.colour = interpolate(mesh.colours, t, b);
  const Vec2 uv0 = corner_uv(mesh, t, 0), d1 = corner_uv(mesh, t, 1) - uv0, d2 = corner_uv(mesh, t, 2) - uv0;
  const float uv_area = d1.x * d2.y - d1.y * d2.x;
  point.uv_per_length = std::sqrt(std::abs(uv_area) * inverse_area);
  if (mesh.tangents.empty()) {
    point.tangent = tangent_of(e1, e2, d1, d2, uv_area);
    point.bitangent_sign = uv_area < 0 ? -1.0f : 1.0f;
  } else {
    const auto map = [&](Vec3 v) { return s.to_world.vector(v); };
    const Vec4 tangent = interpolate(mesh.tangents, t, b);
    point.tangent = s.instanced ? interpolate_mapped(mesh.tangents, t, b, map) : Vec3(tangent);
    point.bitangent_sign = tangent.w < 0 ? -1.0f : 1.0f;
  }
  if (s.instanced && s.to_world.swaps_handedness()) point.bitangent_sign = -point.bitangent_sign;
}

void fill_from_shape(SurfacePoint& point, const CompiledSurface& s, const Ray& ray, const Hit& hit) {
  point.ng = point.ns = normalize(hit.ng);
  point.uv = point.uv1 = hit.barycentric;
  // Once more in the shape's space, from nearby: the first hit's t may be far along the ray.
  const Transform to_object = s.to_world.inverse();
  const Vec3 near_hit = ray.at(hit.t);
  // Not from before the ray's own start: it may lie inside a shape that is smaller than the step.
  const float step = std::min(1e-3f * (1 + length(near_hit)), hit.t);
  const Ray close{near_hit - step * ray.direction, ray.direction};
  const auto again = std::visit([&](const auto& shape) { return shape.intersect(to_object.ray(close)); }, *s.shape);
  point.position = again && again->t < 2 * step ? close.at(again->t) : near_hit;
  if (again && again->t < 2 * step) point.tangent = s.to_world.vector(again->dpdu);
  const float l = length(point.tangent);
  point.uv_per_length = l > 0 ? 1 / l : 0;
}

}  // namespace

SurfacePoint Scene::surface_point(const Ray& ray, const Hit& hit) const {
  const CompiledSurface& s = state_->surfaces[hit.surface];
  SurfacePoint point;
  if (s.mesh) {
    fill_from_mesh(point, s, hit);
  } else {
    fill_from_shape(point, s, ray, hit);
  }
  if (s.flip) point.ng = -point.ng, point.bitangent_sign = -point.bitangent_sign;
  if (dot(point.ns, point.ng) < 0) point.ns = -point.ns;
  point.material = s.material;
  point.surface = hit.surface;
  point.object = s.object;
  point.primitive = hit.primitive;
  if (!s.lights.empty()) point.light = s.lights[hit.primitive];
  return point;
}

WorldTriangle world_triangle(const CompiledSurface& s, std::uint32_t primitive) {
  const Triangle& t = s.mesh->triangles[primitive];
  WorldTriangle w;
  for (std::size_t i = 0; i < 3; ++i) {
    w.p[i] = s.instanced ? s.to_world.point(s.mesh->positions[t[i]]) : s.mesh->positions[t[i]];
    w.uv[i] = corner_uv(*s.mesh, t, i);
  }
  if (s.flip != (s.instanced && s.to_world.swaps_handedness())) std::swap(w.p[1], w.p[2]), std::swap(w.uv[1], w.uv[2]);
  return w;
}

bool ray_passes(const Scene::State& scene, std::uint32_t surface, std::uint32_t primitive, Vec2 barycentric,
                Vec3 origin, Vec3 direction, Vec3 ng) {
  const CompiledSurface& s = scene.surfaces[surface];
  if (!s.needs_filter) return false;
  const Material& material = scene.materials[s.material];
  if (!material.double_sided && (dot(direction, ng) > 0) != s.flip) return true;
  if (material.alpha_mode == AlphaMode::opaque) return false;
  TextureCoordinates at;
  float vertex_alpha = 1;
  at.uv = at.uv1 = barycentric;
  if (s.mesh) {
    const Triangle& t = s.mesh->triangles[primitive];
    at.uv = uv_at(*s.mesh, t, barycentric);
    at.uv1 = s.mesh->uvs1.empty() ? at.uv : interpolate(s.mesh->uvs1, t, barycentric);
    if (!s.mesh->colours.empty()) vertex_alpha = interpolate(s.mesh->colours, t, barycentric).w;
  }
  // A ray may meet one shape twice, each time by its own chance; of a mesh it meets other primitives.
  const Vec2 place = s.shape ? barycentric : Vec2(0);
  const float u = hash_to_float(hash_values(origin, direction, primitive, surface, place));
  return alpha_passes(material, scene.textures, at, vertex_alpha, u);
}

}  // namespace lambert
