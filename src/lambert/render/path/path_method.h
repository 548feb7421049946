#pragma once
#include "lambert/render/method.h"
#include "lambert/render/path/path_settings.h"

namespace lambert {

/// The method `path`: see path_tracer.h.
class PathMethod final : public Method {
 public:
  MethodInfo info() const override;
  SettingTable settings() override;
  void prepare(const Scene& scene) override { scene_ = &scene; }
  Estimate radiance(const CameraRay& ray, Sampler& sampler, bool want_features) const override;
  Estimate guide(const CameraRay& ray, Sampler& sampler) const override;

 private:
  PathSettings settings_;
  const Scene* scene_ = nullptr;
};

}  // namespace lambert
