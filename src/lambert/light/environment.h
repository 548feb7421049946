#pragma once
#include "lambert/base/transform.h"
#include "lambert/image/image.h"
#include "lambert/light/light.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace lambert {

class EnvironmentMap;

/// How directions index an environment image.
enum class EnvironmentMapping : std::uint8_t {
  lat_long,    ///< row 0 is +y, the centre column is -z (before `to_world`), columns go from there towards +x
  equal_area,  ///< pbrt-v4's equal-area octahedral square (Clarberg 2008), +z up
};

/// Light from infinity: constant, or an image importance-sampled by luminance times solid angle (row PT-21, E-PT-08).
class EnvironmentLight {
 public:
  explicit EnvironmentLight(Rgb constant);
  /// Of `to_world` the rotation (and mirroring) matters. Throws Error when the image is empty, holds a value that is
  /// not finite, or is not square where the mapping wants that; negative values count as 0.
  EnvironmentLight(Image image, EnvironmentMapping mapping, Rgb scale, const Transform& to_world);

  Rgb radiance(Vec3 direction) const;  ///< that arrives from unit world `direction` (pointing away from the scene)
  float pdf_omega(Vec3 direction) const;
  std::optional<LightSample> sample(const LightContext&, Vec3 p, Vec2 u) const;
  LightBounds bounds(const LightContext&) const;

 private:
  std::shared_ptr<const EnvironmentMap> map_;  // none: constant
  Rgb scale_{1.0f};
  Transform to_world_;
};

/// A soft studio: bright overhead softbox, dim fill, dark floor (for scenes that have no light).
EnvironmentLight studio_environment();

}  // namespace lambert
