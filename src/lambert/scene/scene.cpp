#include "lambert/scene/scene.h"

#include "lambert/scene/accelerator.h"
#include "lambert/scene/compiled.h"

namespace lambert {

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

bool Scene::intersect(const Ray& ray, Hit& hit) const { return state_->accelerator->intersect(ray, hit); }
bool Scene::occluded(const Ray& ray) const { return state_->accelerator->occluded(ray); }

Rgb Scene::emitted(const SurfacePoint& point, Vec3 wo) const {
  const auto& emission = state_->surfaces[point.surface].emission;
  if (!emission || (!emission->two_sided && dot(wo, point.ng) <= 0)) return {};
  TextureCoordinates at;
  at.uv = point.uv, at.uv1 = point.uv1, at.position = point.position;
  return emission->radiance.eval(state_->textures, at);
}

bool Scene::casts_light(const SurfacePoint& point) const {
  const auto& emission = state_->surfaces[point.surface].emission;
  return emission && emission->casts_light;
}

float Scene::light_pdf_omega(const SurfacePoint& point, Vec3 from) const {
  const Light& light = state_->lights[point.light];
  if (const auto* quad = std::get_if<QuadLight>(&light)) return quad->pdf_omega(from, point.position);
  if (const auto* triangle = std::get_if<TriangleLight>(&light)) return triangle->pdf_omega(from, point.position);
  if (const auto* shape = std::get_if<ShapeLight>(&light)) return shape->pdf_omega(from, point.position, point.ng);
  return 0;
}

Rgb Scene::environment_radiance(Vec3 direction) const {
  Rgb sum;
  for (const std::uint32_t i : state_->environment_lights)
    sum += std::get<EnvironmentLight>(state_->lights[i]).radiance(direction);
  return sum;
}

const std::vector<Light>& Scene::lights() const { return state_->lights; }
const std::vector<std::uint32_t>& Scene::environment_lights() const { return state_->environment_lights; }
const LightChooser& Scene::light_chooser() const { return state_->chooser; }
const LightContext& Scene::light_context() const { return state_->light_context; }
const MaterialSet& Scene::materials() const { return state_->materials; }
const TextureSet& Scene::textures() const { return state_->textures; }
const std::vector<Camera>& Scene::cameras() const { return state_->cameras; }
const SceneFileSettings& Scene::settings() const { return state_->settings; }
const Bounds3& Scene::bounds() const { return state_->bounds; }
std::size_t Scene::triangle_count() const { return state_->triangle_count; }
std::string Scene::object_name(std::uint32_t object) const { return state_->object_names[object]; }

}  // namespace lambert
