#pragma once
#include "lambert/image/probe/texels.h"

#include <array>
#include <vector>

namespace lambert::probe {

/// Radiance in a texel as a linear function of direction, L(d) = L0 + g · (d - m / Ω) with Ω = ∫ dω and m = ∫ d dω over
/// the texel: its mean is the texel's colour L0, so the flux stays what it is.
struct LinearRadiance {
  Rgb mean;
  Vec3d middle{0};                  ///< m / Ω
  std::array<Vec3d, 3> gradient{};  ///< of r, g, b

  Rgb operator()(Vec3d d) const {
    const auto change = [&](std::size_t k) { return static_cast<float>(dot(gradient[k], d - middle)); };
    return mean + Rgb(change(0), change(1), change(2));
  }
};

/// As finite volumes reconstruct it (Barth and Jespersen, "The Design and Application of Upwind Schemes on Unstructured
/// Meshes", 1989): g fits the texels at the sides best, weighted by the inverse square of the distance, which is exact
/// where radiance is linear; at the rim of a disk texels across it count too. g is shortened so that within the texel
/// nothing leaves the neighbours' range by more than half of that range, so that a smooth peak keeps its shape, and
/// nothing is negative where they are not. It is 0 where the texel and the brightest around it differ by more than a
/// factor of 30, as at a sun and beside it, and in texels of about a hemisphere or more.
LinearRadiance linear_radiance(const Probe& probe, const Texel& texel);

/// ∫ L d dω over a texel, of r, g, b: of one colour where it is narrow, else of linear radiance, as Irradiance takes
/// it.
std::array<Vec3d, 3> radiance_moments(const Probe& probe, const Texel& texel);

/// All texels whose linear_radiance may change with this one's colour, itself too; more than once, some.
void add_touched(const Probe& probe, const Texel& texel, std::vector<Texel>& touched);

}  // namespace lambert::probe
