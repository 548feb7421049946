#include "lambert/scene/accelerator.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"

#include <embree3/rtcore.h>

#include <cassert>
#include <unordered_map>

namespace lambert {
namespace {

void report(void*, RTCError, const char* message) { log::error(std::string("embree: ") + message); }

/// One device for the process; it is never released, since threads of Embree may outlive static objects.
RTCDevice device() {
  static const RTCDevice instance = [] {
    RTCDevice d = rtcNewDevice("verbose=0");
    if (!d) throw Error("embree cannot be started on this processor");
    rtcSetDeviceErrorFunction(d, report, nullptr);
    return d;
  }();
  return instance;
}

/// What callbacks know: the surface itself, or, in geometry shared by instances, the instance the ray came through.
struct Binding {
  const Scene::State* scene = nullptr;
  std::uint32_t surface = 0;
};

std::uint32_t surface_of(const Binding& binding, const RTCHit& hit) {
  return hit.instID[0] != RTC_INVALID_GEOMETRY_ID ? hit.instID[0] : binding.surface;
}

void filter(const RTCFilterFunctionNArguments* args) {
  assert(args->N == 1);
  const auto& binding = *static_cast<const Binding*>(args->geometryUserPtr);
  const auto& ray = *reinterpret_cast<const RTCRay*>(args->ray);
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  if (ray_passes(*binding.scene, surface_of(binding, hit), hit.primID, {hit.u, hit.v},
                 {ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}, {hit.Ng_x, hit.Ng_y, hit.Ng_z}))
    args->valid[0] = 0;
}

Ray ray_of(const RTCRay& r) {
  return {{r.org_x, r.org_y, r.org_z}, {r.dir_x, r.dir_y, r.dir_z}, r.tnear, r.tfar, r.time};
}

/// The nearest hit on an analytic shape: the ray goes to the shape's space unnormalised, so that t means the same
/// there. Alpha is decided for the nearest hit only; what passes goes on from just behind it.
std::optional<ShapeHit> intersect_shape(const Binding& binding, const RTCRay& embree_ray, Vec3& world_normal) {
  const CompiledSurface& s = binding.scene->surfaces[binding.surface];
  const Ray world = ray_of(embree_ray);
  const Transform to_object = s.to_world.inverse();
  Ray local = to_object.ray(world);
  for (int passed = 0; passed < 64; ++passed) {
    const auto hit = std::visit([&](const auto& shape) { return shape.intersect(local); }, *s.shape);
    if (!hit) return std::nullopt;
    world_normal = s.to_world.normal(hit->normal);
    if (!s.needs_filter ||
        !ray_passes(*binding.scene, binding.surface, 0, hit->uv, world.origin, world.direction, world_normal))
      return hit;
    local.t_min = std::nextafter(hit->t, std::numeric_limits<float>::infinity());
  }
  return std::nullopt;
}

void shape_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& binding = *static_cast<const Binding*>(args->geometryUserPtr);
  const CompiledSurface& s = binding.scene->surfaces[binding.surface];
  const Bounds3 b = s.to_world.bounds(std::visit([](const auto& shape) { return shape.bounds(); }, *s.shape));
  const Vec3 margin = 1e-5f * (glm::abs(b.min) + glm::abs(b.max) + b.diagonal());
  const Vec3 lower = b.min - margin, upper = b.max + margin;
  *args->bounds_o = {lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z, 0};
}

void shape_intersect(const RTCIntersectFunctionNArguments* args) {
  assert(args->N == 1);
  if (!args->valid[0]) return;
  const auto& binding = *static_cast<const Binding*>(args->geometryUserPtr);
  auto& query = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  Vec3 normal;
  const auto hit = intersect_shape(binding, query.ray, normal);
  if (!hit) return;
  query.ray.tfar = hit->t;
  query.hit.u = hit->uv.x, query.hit.v = hit->uv.y;
  query.hit.Ng_x = normal.x, query.hit.Ng_y = normal.y, query.hit.Ng_z = normal.z;
  query.hit.geomID = binding.surface, query.hit.primID = 0;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

void shape_occluded(const RTCOccludedFunctionNArguments* args) {
  assert(args->N == 1);
  if (!args->valid[0]) return;
  const auto& binding = *static_cast<const Binding*>(args->geometryUserPtr);
  auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
  Vec3 normal;
  if (intersect_shape(binding, ray, normal)) ray.tfar = -std::numeric_limits<float>::infinity();
}

RTCRay embree_ray(const Ray& r) {
  RTCRay q;
  q.org_x = r.origin.x, q.org_y = r.origin.y, q.org_z = r.origin.z;
  q.dir_x = r.direction.x, q.dir_y = r.direction.y, q.dir_z = r.direction.z;
  q.tnear = r.t_min, q.tfar = r.t_max, q.time = r.time;
  q.mask = ~0u, q.id = 0, q.flags = 0;
  return q;
}

}  // namespace

struct Accelerator::Embree {
  RTCScene scene = nullptr;
  std::unordered_map<const TriangleMesh*, RTCScene> shared;  // meshes that are placed several times
  std::vector<Binding> bindings;                             // per surface
  ~Embree() {
    for (const auto& [mesh, s] : shared) rtcReleaseScene(s);
    if (scene) rtcReleaseScene(scene);
  }

  RTCScene new_scene(bool robust) const {
    RTCScene s = rtcNewScene(device());
    rtcSetSceneFlags(s, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    return s;
  }

  static RTCGeometry mesh_geometry(const TriangleMesh& mesh, Binding& binding, bool needs_filter) {
    RTCGeometry g = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0, sizeof(Vec3),
                               mesh.positions.size());
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(Triangle), mesh.triangles.size());
    rtcSetGeometryUserData(g, &binding);
    if (needs_filter) {
      rtcSetGeometryIntersectFilterFunction(g, filter);
      rtcSetGeometryOccludedFilterFunction(g, filter);
    }
    rtcCommitGeometry(g);
    return g;
  }

  static RTCGeometry shape_geometry(Binding& binding) {
    RTCGeometry g = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, 1);
    rtcSetGeometryUserData(g, &binding);
    rtcSetGeometryBoundsFunction(g, shape_bounds, nullptr);
    rtcSetGeometryIntersectFunction(g, shape_intersect);
    rtcSetGeometryOccludedFunction(g, shape_occluded);
    rtcCommitGeometry(g);
    return g;
  }

  /// The filter is set if any placement needs it; ray_passes() then decides for each.
  RTCGeometry instance_geometry(const CompiledSurface& s, Binding& binding, bool robust, bool any_needs_filter) {
    RTCScene& inner = shared[s.mesh.get()];
    if (!inner) {
      inner = new_scene(robust);
      RTCGeometry g = mesh_geometry(*s.mesh, binding, any_needs_filter);
      rtcAttachGeometry(inner, g);
      rtcReleaseGeometry(g);
      rtcCommitScene(inner);
    }
    RTCGeometry g = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(g, inner);
    rtcSetGeometryTransform(g, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &s.to_world.matrix()[0][0]);
    rtcCommitGeometry(g);
    return g;
  }
};

Accelerator::Accelerator(const Scene::State& scene, bool robust) : embree_(std::make_unique<Embree>()) {
  Embree& e = *embree_;
  e.scene = e.new_scene(robust);
  e.bindings.resize(scene.surfaces.size());
  std::unordered_map<const TriangleMesh*, bool> filtered;
  for (const CompiledSurface& s : scene.surfaces) filtered[s.mesh.get()] |= s.needs_filter;
  for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
    const CompiledSurface& s = scene.surfaces[i];
    Binding& binding = e.bindings[i] = {&scene, i};
    RTCGeometry g = s.shape       ? Embree::shape_geometry(binding)
                    : s.instanced ? e.instance_geometry(s, binding, robust, filtered[s.mesh.get()])
                                  : Embree::mesh_geometry(*s.mesh, binding, s.needs_filter);
    rtcAttachGeometryByID(e.scene, g, i);
    rtcReleaseGeometry(g);
  }
  rtcCommitScene(e.scene);
  if (rtcGetDeviceError(device()) != RTC_ERROR_NONE) throw Error("the scene does not fit into memory");
}

Accelerator::~Accelerator() = default;

bool Accelerator::intersect(const Ray& ray, Hit& hit) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit q;
  q.ray = embree_ray(ray);
  q.hit.geomID = q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &q);
  if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit.t = q.ray.tfar;
  hit.barycentric = {q.hit.u, q.hit.v};
  hit.surface = q.hit.instID[0] != RTC_INVALID_GEOMETRY_ID ? q.hit.instID[0] : q.hit.geomID;
  hit.primitive = q.hit.primID;
  hit.ng = {q.hit.Ng_x, q.hit.Ng_y, q.hit.Ng_z};
  return true;
}

bool Accelerator::occluded(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay q = embree_ray(ray);
  rtcOccluded1(embree_->scene, &context, &q);
  return q.tfar < 0;
}

}  // namespace lambert
