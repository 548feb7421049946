#pragma once
/// Scenes of one body in a uniform environment, and the mean of what a path tracer sees there.

#include "lambert/geometry/generators.h"
#include "lambert/render/render.h"
#include "statistics/chi_square.h"

#include <map>
#include <string>

namespace lambert {

using MethodWords = std::map<std::string, std::string>;

struct SeenMean {
  Rgb mean;
  double standard_error = 0;  ///< of the luminance, from the spread between pixels' samples
};

inline SeenMean path_mean(const Scene& scene, const Camera& camera, const MethodWords& words = {}, int samples = 64,
                          std::uint64_t seed = 1) {
  const auto method = make_method("path");
  SettingTable table = method->settings();
  for (const auto& [key, value] : words) table.set(key, value);
  RenderSettings settings{.samples_per_pixel = samples, .seed = seed, .sampler = SamplerKind::independent};
  settings.filter.kind = FilterKind::box;
  const RenderResult result = render(scene, camera, *method, settings);
  SeenMean seen;
  double variance = 0;
  const float pixels = static_cast<float>(camera.resolution.x * camera.resolution.y);
  for (int y = 0; y < camera.resolution.y; ++y)
    for (int x = 0; x < camera.resolution.x; ++x) {
      seen.mean += result.film.mean({x, y}) / pixels;
      variance += result.film.variance_of_mean({x, y});
    }
  seen.standard_error = std::sqrt(variance) / static_cast<double>(pixels);
  return seen;
}

/// A camera at (0, 0, 4) that sees no more than a disk of radius 0.9 or so about the origin.
inline Camera facing_camera(float half_width = 0.15f) {
  Camera camera;
  camera.to_world = Transform::translate({0, 0, 4});
  camera.projection = Perspective{.half_width = half_width, .half_height = half_width};
  camera.resolution = {8, 8};
  return camera;
}

/// `geometry` of `material` in an environment of radiance 1.
inline Scene in_white(Geometry geometry, Material material, const Transform& place = {}) {
  SceneGraph graph;
  const MaterialId id = graph.materials.add(std::move(material));
  graph.add_surface(graph.add_node(graph.root(), "body", place),
                    {.geometry = graph.add_geometry(std::move(geometry)), .material = id});
  graph.add_light(EnvironmentLight(Rgb(1)));
  return compile(std::move(graph));
}

}  // namespace lambert
