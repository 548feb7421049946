#include "lambert/render/path/path_tracer.h"

#include "lambert/base/frame.h"
#include "lambert/base/hash.h"
#include "lambert/material/normal_map.h"
#include "lambert/material/spectrum.h"
#include "lambert/sampling/mis.h"
#include "lambert/sampling/roulette.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

// Dimensions of one scattering event; a fixed number, so that every event uses the same well-stratified pairs.
constexpr std::uint32_t dimensions_per_event = 5;

/// A surface point made ready for scattering.
struct Vertex {
  SurfacePoint point;
  Vec3 wo;  // towards the previous vertex
  Frame frame;
  const Material* material = nullptr;
  Bsdf bsdf;

  Vec3 offset_origin(Vec3 towards) const {
    return offset_ray_origin(point.position, dot(towards, point.ng) < 0 ? -point.ng : point.ng);
  }
};

class PathTracer {
 public:
  PathTracer(const Scene& scene, const PathSettings& settings, const CameraRay& camera_ray, Sampler& sampler)
      : scene_(scene),
        settings_(settings),
        sampler_(sampler),
        ray_(camera_ray.ray),
        cone_(camera_ray.cone),
        first_dimension_(sampler.dimension()) {}

  Method::Estimate trace(bool want_features) {
    for (depth_ = 0;; ++depth_) {
      Hit hit;
      ++result_.rays;
      if (!scene_.intersect(ray_, hit)) {
        add_environment();
        break;
      }
      Vertex v;
      v.point = scene_.surface_point(ray_, hit);
      v.wo = -ray_.direction;
      add_emission(v);
      if (depth_ == settings_.max_depth && !(want_features && depth_ == 0)) break;
      sampler_.set_dimension(first_dimension_ + static_cast<std::uint32_t>(depth_) * dimensions_per_event);
      prepare(v, hit.t);
      if (want_features && depth_ == 0) record_features(v, hit.t);
      if (depth_ == settings_.max_depth) break;
      if (!v.bsdf.is_specular()) add_direct_light(v);
      if (!scatter(v, hit.t) || !survives_roulette()) break;
    }
    return result_;
  }

 private:
  /// Adds β L, with the clamp if there is one.
  void add(Rgb contribution) {
    if (settings_.clamp > 0 && depth_ > 0) {
      const float largest = max_component(contribution);
      if (largest > settings_.clamp) contribution *= settings_.clamp / largest;
    }
    result_.radiance += contribution;
  }

  bool found_only_by_scattering() const { return depth_ == 0 || specular_; }

  void add_environment() {
    for (const std::uint32_t index : scene_.environment_lights()) {
      const auto& light = std::get<EnvironmentLight>(scene_.lights()[index]);
      const Rgb radiance = light.radiance(ray_.direction);
      if (is_black(radiance)) continue;
      float weight = 1;
      if (!found_only_by_scattering()) {
        const float choice = scene_.light_chooser().probability(previous_position_, previous_normal_, index);
        weight = power_heuristic(pdf_omega_, choice * light.pdf_omega(ray_.direction));
      }
      add(throughput_ * radiance * weight);
    }
  }

  void add_emission(const Vertex& v) {
    const Rgb radiance = scene_.emitted(v.point, v.wo);
    if (is_black(radiance)) return;
    if (found_only_by_scattering()) return add(throughput_ * radiance);
    if (v.point.light == no_light || !scene_.casts_light(v.point)) return;
    const float choice = scene_.light_chooser().probability(previous_position_, previous_normal_, v.point.light);
    const float pdf_light = choice * scene_.light_pdf_omega(v.point, previous_position_);
    add(throughput_ * radiance * power_heuristic(pdf_omega_, pdf_light));
  }

  /// Material, scattering model and frame at the vertex; absorption and dispersion on the way there.
  void prepare(Vertex& v, float distance) {
    const Vec2 u = sampler_.next2();
    MaterialContext context;
    context.at.uv = v.point.uv, context.at.uv1 = v.point.uv1, context.at.position = v.point.position;
    context.at.footprint = cone_.at(distance) * v.point.uv_per_length;
    context.vertex_colour = Rgb(v.point.colour.x, v.point.colour.y, v.point.colour.z);

    const MaterialSet& materials = scene_.materials();
    const std::uint64_t hash = hash_values(v.point.position, v.wo, v.point.primitive);
    v.material = &materials[materials.resolve(v.point.material, scene_.textures(), context.at, hash)];

    const bool inside = dot(v.wo, v.point.ng) < 0;
    if (inside && !is_black(v.material->absorption)) throughput_ *= exp(v.material->absorption * -distance);
    if (wavelength_ == 0 && is_dispersive(*v.material)) {
      wavelength_ = sample_wavelength(u.x);
      throughput_ *= wavelength_rgb(wavelength_);
    }
    context.wavelength_nm = wavelength_;
    v.bsdf = make_bsdf(*v.material, scene_.textures(), context);
    v.frame = shading_frame(*v.material, scene_.textures(), context.at, v.point.ng, v.point.ns, v.point.tangent,
                            v.point.bitangent_sign, v.wo);
  }

  void record_features(const Vertex& v, float distance) {
    Features& f = result_.features;
    f.albedo = v.bsdf.albedo(v.frame.to_local(v.wo));
    f.normal = v.frame.n;
    f.position = v.point.position;
    f.depth = distance;
    f.object = v.point.object + 1;
  }

  void add_direct_light(const Vertex& v) {
    const Vec2 u_light = sampler_.next2();
    const float u_choice = sampler_.next();
    const LightChooser::Choice choice = scene_.light_chooser().choose(v.point.position, v.frame.n, u_choice);
    if (!(choice.probability > 0)) return;
    const Light& light = scene_.lights()[choice.light];
    const auto sample = sample_light(light, scene_.light_context(), v.point.position, u_light);
    if (!sample || is_black(sample->radiance)) return;

    const Vec3 wo = v.frame.to_local(v.wo), wi = v.frame.to_local(sample->wi);
    const Rgb f = v.bsdf.eval(wo, wi);
    if (is_black(f) || !visible(v, *sample)) return;
    const float pdf_light = choice.probability * sample->pdf_omega;
    const float weight = sample->delta ? 1.0f : power_heuristic(pdf_light, v.bsdf.pdf(wo, wi));
    add(throughput_ * f * sample->radiance * (weight / pdf_light));
  }

  bool visible(const Vertex& v, const LightSample& sample) {
    Ray shadow;
    shadow.time = ray_.time;
    shadow.origin = v.offset_origin(sample.wi);
    if (std::isinf(sample.distance)) {
      shadow.direction = sample.wi;
    } else {
      // From offset point to offset point, so that neither surface shadows itself.
      Vec3 target = v.point.position + sample.wi * sample.distance;
      if (sample.normal != Vec3(0))
        target = offset_ray_origin(target, dot(sample.normal, sample.wi) > 0 ? -sample.normal : sample.normal);
      shadow.direction = target - shadow.origin;
      shadow.t_max = 1;
    }
    ++result_.rays;
    return !scene_.occluded(shadow);
  }

  /// Continues the path by the scattering model; false when it is absorbed.
  bool scatter(const Vertex& v, float distance) {
    sampler_.set_dimension(first_dimension_ + static_cast<std::uint32_t>(depth_) * dimensions_per_event + 3);
    const Vec2 u = sampler_.next2();
    const Vec2 u_lobe = sampler_.next2();
    const auto sample = v.bsdf.sample(v.frame.to_local(v.wo), u_lobe.x, u);
    if (!sample) return false;
    throughput_ *= sample->weight;
    if (is_black(throughput_)) return false;
    u_roulette_ = u_lobe.y;
    pdf_omega_ = sample->pdf;
    specular_ = sample->specular;
    previous_position_ = v.point.position, previous_normal_ = v.frame.n;
    if (sample->transmitted) eta_scale_ *= sample->eta * sample->eta;

    cone_.width = cone_.at(distance);
    const Vec3 direction = normalize(v.frame.to_world(sample->wi));
    const float time = ray_.time;
    ray_ = Ray{v.offset_origin(direction), direction};
    ray_.time = time;
    return true;
  }

  bool survives_roulette() {
    if (depth_ + 1 < settings_.roulette_depth) return true;
    // Undoing the scaling of radiance by refraction: a path inside glass is not worth less for it.
    const float survival = std::min(0.95f, max_component(throughput_) * eta_scale_);
    const float factor = russian_roulette(survival, u_roulette_);
    throughput_ *= factor;
    return factor > 0;
  }

  const Scene& scene_;
  const PathSettings& settings_;
  Sampler& sampler_;
  Ray ray_;
  RayCone cone_;
  std::uint32_t first_dimension_;
  int depth_ = 0;

  Rgb throughput_{1.0f};
  float eta_scale_ = 1;
  float wavelength_ = 0;  // 0 until dispersion is met
  float u_roulette_ = 0;

  // How the present ray was found.
  Vec3 previous_position_{0}, previous_normal_{0};
  float pdf_omega_ = 0;
  bool specular_ = false;

  Method::Estimate result_;
};

}  // namespace

Method::Estimate trace_path(const Scene& scene, const PathSettings& settings, const CameraRay& camera_ray,
                            Sampler& sampler, bool want_features) {
  return PathTracer(scene, settings, camera_ray, sampler).trace(want_features);
}

}  // namespace lambert
