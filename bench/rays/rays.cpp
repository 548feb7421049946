/// Rays per second of lambert::Scene beside Embree alone, on the same triangles and the same rays, in turn.
///
/// Three kinds of rays as a path tracer makes them: camera rays, diffuse bounces from where those hit, and shadow rays
/// from there to a small lamp. Medians of several rounds, one thread.

#include "lambert/base/frame.h"
#include "lambert/base/hash.h"
#include "lambert/base/parallel.h"
#include "lambert/geometry/generators.h"
#include "lambert/render/render.h"
#include "lambert/scene/cornell_box.h"
#include "lambert/scene/scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace lambert {
namespace {

constexpr int rounds = 7;
constexpr int side = 512;

/// All triangles of a graph in world space, for Embree alone.
TriangleMesh flatten(const SceneGraph& graph) {
  TriangleMesh all;
  for (NodeId n = 0; n < graph.node_count(); ++n)
    for (const Surface& s : graph.surfaces(n)) {
      const auto* mesh = std::get_if<TriangleMesh>(&graph.geometry(s.geometry));
      if (!mesh) continue;
      const auto first = static_cast<std::uint32_t>(all.positions.size());
      for (const Vec3 p : mesh->positions) all.positions.push_back(graph.world_transform(n).point(p));
      for (const Triangle& t : mesh->triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  return all;
}

class RawEmbree {
 public:
  explicit RawEmbree(TriangleMesh mesh)
      : mesh_(std::move(mesh)), device_(rtcNewDevice("threads=2")), scene_(rtcNewScene(device_)) {
    mesh_.positions.emplace_back(0);  // Embree reads 16 bytes at the last vertex
    RTCGeometry g = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh_.positions.data(), 0, sizeof(Vec3),
                               mesh_.positions.size() - 1);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh_.triangles.data(), 0,
                               sizeof(Triangle), mesh_.triangles.size());
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene_, g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene_);
  }
  RawEmbree(const RawEmbree&) = delete;
  RawEmbree& operator=(const RawEmbree&) = delete;
  ~RawEmbree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  bool intersect(const Ray& r, float& t) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit q{};
    set(q.ray, r);
    q.hit.geomID = q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &q);
    t = q.ray.tfar;
    return q.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }
  bool occluded(const Ray& r) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay q{};
    set(q, r);
    rtcOccluded1(scene_, &context, &q);
    return q.tfar < 0;
  }

 private:
  static void set(RTCRay& q, const Ray& r) {
    q.org_x = r.origin.x, q.org_y = r.origin.y, q.org_z = r.origin.z;
    q.dir_x = r.direction.x, q.dir_y = r.direction.y, q.dir_z = r.direction.z;
    q.tnear = r.t_min, q.tfar = r.t_max, q.mask = ~0u;
  }
  TriangleMesh mesh_;
  RTCDevice device_;
  RTCScene scene_;
};

float random(std::size_t i, int dimension) {
  return hash_to_float(hash_values(static_cast<std::uint64_t>(i), dimension));
}

struct Rays {
  std::vector<Ray> camera, bounce, shadow;
};

Rays make_rays(const Scene& scene, const Camera& camera) {
  Rays rays;
  const Vec3 lamp(scene.bounds().centre().x, scene.bounds().max.y - 0.02f * scene.bounds().diagonal().y,
                  scene.bounds().centre().z);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x);
      const Ray ray = camera.ray({static_cast<float>(x) + random(i, 0), static_cast<float>(y) + random(i, 1)}).ray;
      rays.camera.push_back(ray);
      Hit hit;
      if (!scene.intersect(ray, hit)) continue;
      const SurfacePoint p = scene.surface_point(ray, hit);
      const Vec3 n = dot(p.ng, ray.direction) > 0 ? -p.ng : p.ng;
      const float radius = std::sqrt(random(i, 2)), angle = 2 * pi * random(i, 3);
      const Vec3 local(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - radius * radius));
      const Vec3 origin = offset_ray_origin(p.position, n);
      rays.bounce.push_back({origin, Frame(n).to_world(local)});
      rays.shadow.push_back({origin, lamp - origin, 0, 1});
    }
  return rays;
}

double median_rate(const std::vector<Ray>& rays, const std::function<std::size_t(const std::vector<Ray>&)>& trace,
                   std::vector<double>& rates) {
  const auto start = std::chrono::steady_clock::now();
  volatile std::size_t hits = trace(rays);
  static_cast<void>(hits);
  rates.push_back(static_cast<double>(rays.size()) /
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 1e6);
  std::vector<double> sorted = rates;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

template <class Query>
std::size_t count_hits(const std::vector<Ray>& rays, const Query& query) {
  return static_cast<std::size_t>(std::count_if(rays.begin(), rays.end(), query));
}

/// Prints one line; the rate of raw Embree in Mrays/s.
double compare(const char* scene_name, const char* kind, const std::vector<Ray>& rays,
               const std::function<std::size_t(const std::vector<Ray>&)>& raw,
               const std::function<std::size_t(const std::vector<Ray>&)>& ours,
               const std::function<std::size_t(const std::vector<Ray>&)>& shaded) {
  std::vector<double> raw_rates, our_rates, shaded_rates;
  double a = 0, b = 0, c = 0;
  for (int round = 0; round < rounds; ++round) {
    a = median_rate(rays, raw, raw_rates);
    b = median_rate(rays, ours, our_rates);
    if (shaded) c = median_rate(rays, shaded, shaded_rates);
  }
  fmt::print("{:<14} {:<8} embree {:6.2f}  lambert {:6.2f} Mrays/s ({:3.0f} %)", scene_name, kind, a, b, 100 * b / a);
  if (shaded) fmt::print("  with surface point {:6.2f} ({:3.0f} %)", c, 100 * c / a);
  fmt::print("\n");
  return a;
}

/// The whole path tracer on one thread against the time that raw Embree takes for as many rays of the same kinds: one
/// camera ray a sample, and as many bounces as shadow rays among the rest.
void compare_renderer(const char* name, const Scene& scene, const Camera& camera, double raw_camera, double raw_bounce,
                      double raw_shadow) {
  set_thread_count(1);
  const auto method = make_method("path");
  method->settings().set("max-depth", "8");
  std::vector<double> rates;
  double camera_share = 0;
  for (int round = 0; round < 3; ++round) {
    const RenderStatistics s = render(scene, camera, *method, {.samples_per_pixel = 16}).statistics;
    rates.push_back(static_cast<double>(s.rays) / s.seconds / 1e6);
    camera_share = static_cast<double>(s.samples) / static_cast<double>(s.rays);
  }
  set_thread_count(0);
  std::sort(rates.begin(), rates.end());
  const double rest = (1 - camera_share) / 2;
  const double raw = 1 / (camera_share / raw_camera + rest / raw_bounce + rest / raw_shadow);
  fmt::print("{:<14} {:<8} embree {:6.2f}  lambert {:6.2f} Mrays/s ({:3.0f} %), whole path tracer, shading included\n",
             name, "paths", raw, rates[1], 100 * rates[1] / raw);
}

void run(const char* name, SceneGraph graph) {
  const Camera camera = graph.cameras().at(0).with_resolution({side, side});
  const RawEmbree raw(flatten(graph));
  const Scene scene = compile(std::move(graph));
  const Rays rays = make_rays(scene, camera);
  const auto raw_closest = [&](const std::vector<Ray>& all) {
    float t = 0;
    return count_hits(all, [&](const Ray& r) { return raw.intersect(r, t); });
  };
  const auto our_closest = [&](const std::vector<Ray>& all) {
    Hit hit;
    return count_hits(all, [&](const Ray& r) { return scene.intersect(r, hit); });
  };
  const auto our_surface = [&](const std::vector<Ray>& all) {
    Hit hit;
    return count_hits(all,
                      [&](const Ray& r) { return scene.intersect(r, hit) && scene.surface_point(r, hit).ng.x < 2; });
  };
  const double raw_camera = compare(name, "camera", rays.camera, raw_closest, our_closest, our_surface);
  const double raw_bounce = compare(name, "bounce", rays.bounce, raw_closest, our_closest, our_surface);
  const double raw_shadow = compare(
      name, "shadow", rays.shadow,
      [&](const auto& all) { return count_hits(all, [&](const Ray& r) { return raw.occluded(r); }); },
      [&](const auto& all) { return count_hits(all, [&](const Ray& r) { return scene.occluded(r); }); }, {});
  compare_renderer(name, scene, camera, raw_camera, raw_bounce, raw_shadow);
}

SceneGraph cornell_box_with_knot() {
  SceneGraph graph = cornell_box();
  const NodeId node = graph.add_node(graph.root(), "knot",
                                     Transform::translate({-0.278f, 0.274f, -0.28f}) * Transform::scale(Vec3(0.07f)));
  graph.add_surface(node, {.geometry = graph.add_geometry(torus_knot(2, 3, 2000, 125)), .material = 0});
  return graph;
}

}  // namespace
}  // namespace lambert

int main() {
  lambert::run("cornell box", lambert::cornell_box());
  lambert::run("with knot", lambert::cornell_box_with_knot());
}
