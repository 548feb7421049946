#pragma once
/// Real spherical harmonics, orthonormal over the sphere, polar axis +z, without the Condon-Shortley sign, as
/// Ramamoorthi and Hanrahan have them ("An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001):
///   Y00 = 0.282095, Y1-1 = 0.488603 y, Y10 = 0.488603 z, Y11 = 0.488603 x, Y2-2 = 1.092548 xy, ...
/// Coefficient (l, m) stands at l² + l + m.

#include "lambert/image/probe/layout.h"

#include <span>
#include <vector>

namespace lambert::probe {

inline constexpr int highest_sh_order = 32;
constexpr std::size_t sh_count(int order) { return static_cast<std::size_t>((order + 1) * (order + 1)); }

/// All Y_lm of a unit direction up to l = order (at most highest_sh_order), into sh_count(order) numbers.
void sh_basis(int order, Vec3 direction, std::span<double> values);

struct ShColour {
  double r = 0, g = 0, b = 0;
};
/// L_lm = ∫ L Y_lm dω with exact solid angles, by one to four points a texel; texels that are wide are cut, and
/// radiance in them is linear (linear_radiance.h). Values must be finite. Throws Error for an order out of [0,
/// highest_sh_order].
std::vector<ShColour> sh_project(const Probe& probe, int order);
/// Radiance; `coefficients` has sh_count(order) entries.
Rgb sh_radiance(std::span<const ShColour> coefficients, Vec3 direction);
/// Coefficients of irradiance: E_lm = A_l L_lm with A_0 = π, A_1 = 2π/3, A_2 = π/4, 0 for other odd l.
std::vector<ShColour> sh_irradiance(std::span<const ShColour> radiance);
double cosine_lobe(int l);  ///< A_l

/// The environment that the coefficients stand for; negative radiance (ringing) stays.
Probe sh_map(std::span<const ShColour> coefficients, const AnyProjection& projection, TexelRule texels, int rows);

}  // namespace lambert::probe
