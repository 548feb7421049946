#pragma once
#include "lambert/base/settings.h"
#include "lambert/camera/camera.h"
#include "lambert/image/filter/filter_sampler.h"
#include "lambert/render/film.h"
#include "lambert/sampling/sampler.h"
#include "lambert/scene/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// What a method is, for `lambert methods` and the guide.
struct MethodInfo {
  std::string name;
  std::string summary;
  std::string light_paths;  ///< which transport it solves, in Heckbert's notation
  bool unbiased = false;
};

/// A way of making an image. Chosen once per run, hence virtual. prepare() is called once, then radiance() from many
/// threads.
class Method {
 public:
  virtual ~Method() = default;
  virtual MethodInfo info() const = 0;
  virtual SettingTable settings() = 0;
  virtual void prepare(const Scene& scene) = 0;

  struct Estimate {
    Rgb radiance;
    Features features;  ///< filled when asked for
    std::uint32_t rays = 0;
  };
  /// One sample of the radiance that arrives along a camera ray. Deterministic in its arguments.
  virtual Estimate radiance(const CameraRay& ray, Sampler& sampler, bool want_features) const = 0;
  /// The same sample as far as its guide goes; its radiance says nothing. Cheaper where a method can stop there.
  virtual Estimate guide(const CameraRay& ray, Sampler& sampler) const { return radiance(ray, sampler, true); }
};

/// Throws Error for an unknown name.
std::unique_ptr<Method> make_method(std::string_view name);
std::vector<std::string> method_names();

}  // namespace lambert
