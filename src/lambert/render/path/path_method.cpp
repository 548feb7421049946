#include "lambert/render/path/path_method.h"

#include "lambert/render/path/path_tracer.h"

namespace lambert {

MethodInfo PathMethod::info() const {
  return {"path", "path tracing with next-event estimation and multiple importance sampling", "L(S|D)*E", true};
}

SettingTable PathMethod::settings() {
  return SettingTable({
      {"max-depth",
       "most scattering events of a path; 0: emission alone, 1: direct light",
       &settings_.max_depth,
       {},
       0},
      {"roulette-depth", "scattering events before Russian roulette may end a path", &settings_.roulette_depth, {}, 0},
      {"roulette-threshold",
       "throughput below which paths survive with a probability, and to which survivors are raised",
       &settings_.roulette_threshold,
       {},
       0},
      {"clamp",
       "largest component of a contribution after the first bounce; 0: off (clamping biases)",
       &settings_.clamp,
       {},
       0},
  });
}

Method::Estimate PathMethod::radiance(const CameraRay& ray, Sampler& sampler, bool want_features) const {
  return trace_path(*scene_, settings_, ray, sampler,
                    want_features ? PathGoal::radiance_and_features : PathGoal::radiance);
}

Method::Estimate PathMethod::guide(const CameraRay& ray, Sampler& sampler) const {
  return trace_path(*scene_, settings_, ray, sampler, PathGoal::guide);
}

}  // namespace lambert
