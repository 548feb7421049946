#pragma once
/// Reconstruction and resampling kernels: even functions of one variable, in pixels, centred on 0; in the plane a
/// kernel is the product of one along each axis. Values are not normalised: who uses a kernel divides by its sum or
/// integral.

#include "lambert/base/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// 1 for |x| <= radius.
double box_kernel(double x, double radius);
/// Bartlett's window: 1 at 0, falling straight to 0 at `radius`.
double triangle_kernel(double x, double radius);
/// exp(-x² / 2σ²), for every x.
double gaussian_kernel(double x, double sigma);
/// The piecewise cubics of Mitchell and Netravali 1988, 0 from |x| = 2 on: (1/3, 1/3) is theirs, (0, 1/2) Catmull-Rom,
/// (1, 0) the B-spline.
double cubic_kernel(double x, double b, double c);
/// sinc(x) sinc(x / lobes), 0 from |x| = lobes on (Duchon 1979).
double lanczos_kernel(double x, double lobes);
/// The minimum four-term window of Harris 1978 stretched over [-radius, radius], 1 at 0.
double blackman_harris_kernel(double x, double radius);

enum class FilterKind { box, triangle, gaussian, mitchell, catmull_rom, lanczos, blackman_harris };
/// "bartlett" is the triangle. Throws Error for an unknown name.
FilterKind filter_kind(std::string_view name);
std::vector<std::string> filter_names();

struct FilterSettings {
  FilterKind kind = FilterKind::blackman_harris;
  Vec2 radius{0};  ///< half extent in pixels; 0 means the kind's default (box .5, triangle 1, gaussian 1.5, mitchell
                   ///< and catmull-rom 2, lanczos 3, blackman-harris 1.5). Cubics and windows are stretched to it,
                   ///< lanczos has that many lobes.
  float sigma = 0.5f;                ///< gaussian
  float b = 1.0f / 3, c = 1.0f / 3;  ///< mitchell
  bool truncated = false;  ///< gaussian: cut off at the radius; otherwise less its value there, so that it ends at 0
};

/// A kernel along one axis; 0 beyond its radius.
class Kernel {
 public:
  enum class Axis { x, y };
  /// Throws Error when radius or sigma is not positive and finite.
  Kernel(const FilterSettings& settings, Axis axis);
  double operator()(double x) const;
  double radius() const { return radius_; }

 private:
  FilterSettings settings_;
  double radius_ = 0, pedestal_ = 0;
};

}  // namespace lambert
