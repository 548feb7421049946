#include "lambert/render/path/path_tracer.h"

#include "lambert/base/frame.h"
#include "lambert/base/hash.h"
#include "lambert/material/normal_map.h"
#include "lambert/material/spectrum.h"
#include "lambert/render/path/bodies.h"
#include "lambert/sampling/mis.h"
#include "lambert/sampling/roulette.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// The numbers of one scattering event. Each has its own dimension and is drawn only where it decides something, so
/// that every event uses the same well-stratified pairs and none is computed in vain.
enum EventDimension : std::uint32_t {
  wavelength_dimension,
  light_dimension,
  light_choice_dimension,
  direction_dimension,
  lobe_dimension,
  roulette_dimension,
  dimensions_per_event,
};

constexpr int long_path = 16;           // scattering events
constexpr int most_guide_mirrors = 16;  // mirrors and panes through which a denoiser's guide is sought

/// A surface point made ready for scattering.
struct Vertex {
  const SurfacePoint& point;
  Vec3 wo;         // towards the previous vertex
  Rgb absorption;  // behind the surface
  Frame frame;
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

  Method::Estimate trace(PathGoal goal) {
    const bool want_features = goal != PathGoal::radiance;
    guiding_ = want_features;
    for (depth_ = 0;; ++depth_) {
      Hit hit;
      ++result_.rays;
      if (!scene_.intersect(ray_, hit)) {
        if (guiding_) leave_guide_in_the_sky();
        add_environment();
        break;
      }
      const SurfacePoint point = scene_.surface_point(ray_, hit);
      if (!bodies_.empty()) absorb(bodies_.absorption(), hit.t);
      add_emission(point);
      if (depth_ == settings_.max_depth && !(want_features && depth_ == 0)) break;
      const Vertex v = prepare(point, hit.t);
      if (want_features && depth_ == 0) record_features(v, hit.t);
      if (guiding_) record_guide(v, hit.t);
      if (goal == PathGoal::guide && !guiding_) break;
      if (depth_ == settings_.max_depth) break;
      if (!v.bsdf.is_specular()) add_direct_light(v);
      if (!scatter(v, hit.t) || !survives_roulette()) break;
    }
    return result_;
  }

 private:
  Sampler& at(EventDimension dimension) {
    sampler_.set_dimension(first_dimension_ + static_cast<std::uint32_t>(depth_) * dimensions_per_event + dimension);
    return sampler_;
  }

  /// Adds β L, with the clamp if there is one.
  void add(Rgb contribution) {
    if (settings_.clamp > 0 && depth_ > 0) {
      const float largest = max_component(contribution);
      if (largest > settings_.clamp) contribution *= settings_.clamp / largest;
    }
    result_.radiance += contribution;
    if (guiding_) result_.features.guide.emission += contribution;
  }

  void absorb(Rgb sigma, float distance) {
    if (is_black(sigma)) return;
    const Rgb passed = exp(sigma * -distance);
    throughput_ *= passed, guide_throughput_ *= passed;
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

  void add_emission(const SurfacePoint& point) {
    const Rgb radiance = scene_.emitted(point, -ray_.direction);
    if (is_black(radiance)) return;
    if (found_only_by_scattering()) return add(throughput_ * radiance);
    if (point.light == no_light || !scene_.casts_light(point)) return;
    const float choice = scene_.light_chooser().probability(previous_position_, previous_normal_, point.light);
    const float pdf_light = choice * scene_.light_pdf_omega(point, previous_position_);
    add(throughput_ * radiance * power_heuristic(pdf_omega_, pdf_light));
  }

  /// Material, scattering model and frame at the vertex; absorption and dispersion on the way there.
  Vertex prepare(const SurfacePoint& point, float distance) {
    const Vec3 wo = -ray_.direction;
    MaterialContext context;
    context.at.uv = point.uv, context.at.uv1 = point.uv1, context.at.position = point.position;
    context.at.footprint = cone_.at(distance) * point.uv_per_length;
    context.vertex_colour = Rgb(point.colour.x, point.colour.y, point.colour.z);

    const MaterialSet& materials = scene_.materials();
    MaterialId id = point.material;
    if (materials.is_mix(id))
      id = materials.resolve(id, scene_.textures(), context.at, hash_values(point.position, wo, point.primitive));
    const Material& material = materials[id];

    // A path that began inside a body learns of it here.
    if (bodies_.empty() && dot(wo, point.ng) < 0) absorb(material.absorption, distance);
    if (wavelength_ == 0 && is_dispersive(material)) {
      wavelength_ = sample_wavelength(at(wavelength_dimension).next2().x);
      throughput_ *= wavelength_rgb(wavelength_);
    }
    context.wavelength_nm = wavelength_;
    return {.point = point,
            .wo = wo,
            .absorption = material.absorption,
            .frame = shading_frame(material, scene_.textures(), context.at, point.ng, point.ns, point.tangent,
                                   point.bitangent_sign, wo),
            .bsdf = make_bsdf(material, scene_.textures(), context)};
  }

  void record_features(const Vertex& v, float distance) {
    Features& f = result_.features;
    f.albedo = v.bsdf.albedo(v.frame.to_local(v.wo));
    f.normal = v.frame.n;
    f.position = v.point.position;
    f.depth = distance;
    f.object = v.point.object + 1;
  }

  /// Of a mirror too, in case the path ends there; what is seen in it replaces it.
  void record_guide(const Vertex& v, float distance) {
    Guide& g = result_.features.guide;
    g.albedo = guide_throughput_ * v.bsdf.albedo(v.frame.to_local(v.wo));
    g.normal = v.frame.n;
    g.distance += distance;
    guiding_ = v.bsdf.is_specular() && depth_ < most_guide_mirrors;
  }

  void leave_guide_in_the_sky() {
    Guide& g = result_.features.guide;
    g = {.emission = g.emission};
  }

  void add_direct_light(const Vertex& v) {
    const LightChooser& chooser = scene_.light_chooser();
    const float u_choice = chooser.has_choice() ? at(light_choice_dimension).next() : 0;
    const LightChooser::Choice choice = chooser.choose(v.point.position, v.frame.n, u_choice);
    if (!(choice.probability > 0)) return;
    const Light& light = scene_.lights()[choice.light];
    const auto sample = sample_light(light, scene_.light_context(), v.point.position, at(light_dimension).next2());
    if (!sample || is_black(sample->radiance)) return;

    const Vec3 wo = v.frame.to_local(v.wo), wi = v.frame.to_local(sample->wi);
    const Rgb f = v.bsdf.eval(wo, wi);
    if (is_black(f) || !visible(v, *sample)) return;
    const float pdf_light = choice.probability * sample->pdf_omega;
    const float weight = sample->delta ? 1.0f : power_heuristic(pdf_light, v.bsdf.pdf(wo, wi));
    Rgb radiance = sample->radiance;
    if (const Rgb sigma = absorption_towards(v, sample->wi); !is_black(sigma))
      radiance *= exp(sigma * -sample->distance);
    add(throughput_ * f * radiance * (weight / pdf_light));
  }

  /// Of the body into which `direction` leads from the vertex.
  Rgb absorption_towards(const Vertex& v, Vec3 direction) const {
    const float out = dot(direction, v.point.ng);
    if (out * dot(v.wo, v.point.ng) > 0) return bodies_.absorption();
    if (out < 0) return v.absorption;
    Bodies after = bodies_;
    after.leave(v.point.surface);
    return after.absorption();
  }

  /// A surface that does not refract may be a sheet: it counts as a body's only if that absorbs.
  void pass_through(const Vertex& v, const BsdfSample& sample, Vec3 direction) {
    if (sample.eta == 1 && is_black(v.absorption)) return;
    if (dot(direction, v.point.ng) < 0) {
      bodies_.enter(v.point.surface, v.absorption);
    } else {
      bodies_.leave(v.point.surface);
    }
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
    const Vec2 u = at(direction_dimension).next2();
    const float u_lobe = at(lobe_dimension).next();
    const auto sample = v.bsdf.sample(v.frame.to_local(v.wo), u_lobe, u);
    if (!sample) return false;
    throughput_ *= sample->weight;
    if (guiding_) guide_throughput_ *= sample->weight;
    if (is_black(throughput_)) return false;
    pdf_omega_ = sample->pdf;
    specular_ = sample->specular;
    previous_position_ = v.point.position, previous_normal_ = v.frame.n;
    const Vec3 direction = v.frame.to_world(sample->wi);
    if (sample->transmitted) {
      eta_scale_ *= sample->eta * sample->eta;
      pass_through(v, *sample, direction);
    }

    cone_.width = cone_.at(distance);
    const float time = ray_.time;
    ray_ = Ray{v.offset_origin(direction), direction};
    ray_.time = time;
    return true;
  }

  bool survives_roulette() {
    if (depth_ + 1 < settings_.roulette_depth) return true;
    // Undoing the scaling of radiance by refraction: a path inside glass is not worth less for it.
    const float worth = max_component(throughput_) * eta_scale_;
    // Among white walls or inside glass a path may lose nothing: from here on it ends all the same.
    const float most = depth_ < long_path ? 1.0f : 0.95f;
    if (worth >= settings_.roulette_threshold && most == 1) return true;
    const float survival = std::min(most, worth / settings_.roulette_threshold);
    const float factor = russian_roulette(survival, at(roulette_dimension).next());
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
  Rgb guide_throughput_{1.0f};  // of mirrors and glass alone, without roulette and colours of wavelengths
  bool guiding_ = false;        // the guide is not found yet
  float eta_scale_ = 1;
  Bodies bodies_;
  float wavelength_ = 0;  // 0 until dispersion is met

  // How the present ray was found.
  Vec3 previous_position_{0}, previous_normal_{0};
  float pdf_omega_ = 0;
  bool specular_ = false;

  Method::Estimate result_;
};

}  // namespace

Method::Estimate trace_path(const Scene& scene, const PathSettings& settings, const CameraRay& camera_ray,
                            Sampler& sampler, PathGoal goal) {
  return PathTracer(scene, settings, camera_ray, sampler).trace(goal);
}

}  // namespace lambert
