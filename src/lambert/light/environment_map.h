#pragma once
#include "lambert/image/image.h"
#include "lambert/light/environment.h"
#include "lambert/sampling/distribution.h"

#include <optional>
#include <vector>

namespace lambert {

/// The directions of an image, in its own frame. Radiance is interpolated bilinearly across the borders of the map; the
/// density is constant in each texel and proportional to the mean luminance of the interpolant there, so it is positive
/// wherever there is radiance.
class EnvironmentMap {
 public:
  struct Sample {
    Vec3 direction;
    Rgb radiance;
    float pdf_omega;
  };
  /// Throws as EnvironmentLight's constructor does.
  EnvironmentMap(const Image& image, EnvironmentMapping mapping);

  Rgb radiance(Vec3 direction) const;
  float pdf_omega(Vec3 direction) const;
  std::optional<Sample> sample(Vec2 u) const;  ///< none when the map is black
  Rgb mean_radiance() const { return mean_; }  ///< over the sphere

 private:
  Vec2 to_square(Vec3 direction) const;
  Vec3 to_direction(Vec2 uv) const;
  float square_to_omega(float pdf_uv, float v) const;
  Rgb texel(int x, int y) const;
  Rgb lookup(Vec2 uv) const;
  Rgb cell_mean(int x, int y) const;

  EnvironmentMapping mapping_;
  int width_, height_;
  std::vector<Rgb> texels_;
  Rgb mean_;
  std::optional<PiecewiseConstant2D> distribution_;  // none: black
};

}  // namespace lambert
