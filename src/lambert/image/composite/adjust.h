#pragma once
/// Operators on one element (Porter and Duff 1984, section 4.5), and what else is done to single pixels.

#include "lambert/image/composite/porter_duff.h"

namespace lambert::composite {

/// Scales the light only: 0 black, 1 as it is, above 1 brighter. `factor` at least 0.
constexpr Pixel darken(Pixel p, float factor) { return {factor * p.r, factor * p.g, factor * p.b, p.a}; }
/// Scales light and coverage: 0 gone, 1 as it is. `amount` in [0, 1].
constexpr Pixel dissolve(Pixel p, float amount) { return amount * p; }
/// Scales the coverage only: 1 as it is, 0 light that hides nothing. `amount` in [0, 1]. Colours may exceed alpha
/// after it, so clip (`clamp`) only when all is composited.
constexpr Pixel opaque(Pixel p, float amount) { return {p.r, p.g, p.b, amount * p.a}; }
/// Straight colour to premultiplied.
constexpr Pixel premultiply(Pixel p) { return {p.r * p.a, p.g * p.a, p.b * p.a, p.a}; }
/// The colour itself, R/alpha …; where alpha is 0 there is none, and the pixel stays.
constexpr Pixel unpremultiply(Pixel p) { return p.a != 0 ? Pixel{p.r / p.a, p.g / p.a, p.b / p.a, p.a} : p; }
/// Every channel to [0, 1], NaN to 0.
constexpr Pixel clamp(Pixel p) { return {coverage(p.r), coverage(p.g), coverage(p.b), coverage(p.a)}; }

/// A matte as an element: white in proportion to its coverage, (m, m, m, m).
constexpr Pixel matte_pixel(float m) { return {m, m, m, m}; }

/// 0 up to `low`, 1 from `high` on, linear between; a step at `low` when high <= low.
constexpr float ramp(float value, float low, float high) {
  return high > low ? coverage((value - low) / (high - low)) : (value >= low ? 1.0f : 0.0f);
}

/// a + b - ab for values in [0, 1], the union of two mattes, and of two lights on film; above 1 the part that screens
/// is 1, so that it stays symmetric and never falls: a + b - min(a, 1) min(b, 1).
constexpr float screen(float a, float b) { return a + b - (a < 1 ? a : 1.0f) * (b < 1 ? b : 1.0f); }

}  // namespace lambert::composite
