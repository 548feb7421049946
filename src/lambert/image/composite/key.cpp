#include "lambert/image/composite/key.h"

#include "lambert/base/error.h"
#include "lambert/image/composite/adjust.h"

#include <algorithm>
#include <cmath>

namespace lambert::composite {
namespace {

int largest_channel(Rgb c) { return c.r >= c.g && c.r >= c.b ? 0 : (c.g >= c.b ? 1 : 2); }

/// By how much channel `i` exceeds the larger of the others.
float excess(Rgb c, int i) { return c[i] - std::max(c[(i + 1) % 3], c[(i + 2) % 3]); }

struct Difference {
  float red, blue;
};
Difference colour_difference(Rgb c) { return {c.r - luminance(c), c.b - luminance(c)}; }

/// What is left of `p` when the backing that shows through it is taken away: never below 0, NaN to 0.
Pixel without_backing(Pixel p, float m, Rgb backing, Rgb key, float spill) {
  const auto rest = [&](float value, float behind) {
    const float v = m > 0 ? value - (1 - m) * p.a * behind : 0.0f;
    return v > 0 ? v : 0.0f;
  };
  const Rgb c = suppress_spill({rest(p.r, backing.r), rest(p.g, backing.g), rest(p.b, backing.b)}, key, spill);
  return {c.r, c.g, c.b, m * p.a};
}

/// The colour that keys look at.
Rgb straight(Pixel p) {
  const Pixel q = unpremultiply(p);
  return {q.r, q.g, q.b};
}

void check_ramp(float low, float high, const char* names) {
  if (!(low >= 0 && low < high)) throw Error(std::string("expected 0 <= ") + names);
}

}  // namespace

Rgb suppress_spill(Rgb rgb, Rgb key, float amount) {
  const int i = largest_channel(key);
  const float held = amount * std::max(0.0f, excess(rgb, i));
  if (i == 0) return {rgb.r - held, rgb.g, rgb.b};
  if (i == 1) return {rgb.r, rgb.g - held, rgb.b};
  return {rgb.r, rgb.g, rgb.b - held};
}

void check(const ColourKey& key) {
  if (!is_finite(key.colour) || !(min_component(key.colour) >= 0)) throw Error("expected a colour of numbers from 0");
  if (!(max_component(key.colour) - min_component(key.colour) > 1e-4f * max_component(key.colour)))
    throw Error("a grey has no hue to key by");
  check_ramp(key.inner, key.outer, "inner < outer");
}

float matte(const ColourKey& key, Rgb c) {
  const Difference k = colour_difference(key.colour), d = colour_difference(c);
  const float size = std::hypot(k.red, k.blue);
  return ramp(std::hypot(d.red - k.red, d.blue - k.blue) / size, key.inner, key.outer);
}

Pixel apply(const ColourKey& key, Pixel p) {
  return without_backing(p, matte(key, straight(p)), key.colour, key.colour, key.spill);
}

void check(const ScreenKey& key) {
  if (!is_finite(key.colour) || !(min_component(key.colour) >= 0)) throw Error("expected a colour of numbers from 0");
  if (!(excess(key.colour, largest_channel(key.colour)) > 1e-4f * max_component(key.colour)))
    throw Error("expected a colour of which one channel exceeds the others");
  check_ramp(key.low, key.high, "low < high");
}

float matte(const ScreenKey& key, Rgb c) {
  const int i = largest_channel(key.colour);
  return ramp(1 - excess(c, i) / excess(key.colour, i), key.low, key.high);
}

Pixel apply(const ScreenKey& key, Pixel p) {
  return without_backing(p, matte(key, straight(p)), key.colour, key.colour, key.spill);
}

void check(const DifferenceKey& key) { check_ramp(key.low, key.high, "low < high"); }

float matte(const DifferenceKey& key, Rgb c, Rgb clean) {
  const float d = std::max({std::abs(c.r - clean.r), std::abs(c.g - clean.g), std::abs(c.b - clean.b)});
  return ramp(d, key.low, key.high);
}

Pixel apply(const DifferenceKey& key, Pixel p, Pixel clean) {
  const Rgb behind = straight(clean);
  return without_backing(p, matte(key, straight(p), behind), behind, behind, 0);
}

}  // namespace lambert::composite
