#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/fast_math.h"
#include "lambert/image/tonemap/luminance_map.h"
#include "lambert/image/tonemap/rgb_matrix.h"

#include <algorithm>
#include <cmath>

namespace lambert::tone {

/// One side of a sigmoid about its pivot is x/(1 + (x/scale)^p)^(1/p). The scale with which it comes to `rise` where a
/// straight line of the pivot's slope would be at `straight`; what is not more than `rise` counts as a little more.
float sigmoid_scale(float straight, float rise, float power);

/// A display transform in the manner of Sobotka's AgX, made from its published description and not from its tables: the
/// Rec. 709 primaries are drawn towards white, so that bright saturated colours mix channels and go to white instead
/// of to the corners of the cube; log2 encoding of 16.5 stops about 0.18; a sigmoid that keeps 0.18 where a display
/// curve of 2.2 would put it; display decoding, and the primaries are pushed out again (`outset`).
struct Agx {
  static constexpr const char *name = "agx", *summary = "in the manner of AgX: log encoding, sigmoid, inset primaries";
  float inset = 0.2f, outset = 0.2f;
  float contrast = 2.2f;  ///< slope of the sigmoid at the pivot
  float below = 10, above = 6.5f;

  std::vector<Setting> settings() {
    return {{"inset", "by which the primaries go towards white before the curve", &inset, {}, 0, {}, 0.9f},
            {"outset", "by which they are taken back after it", &outset, {}, 0, {}, 0.9f},
            {"contrast", "slope of the curve at its middle, in log space", &contrast, {}, {}, 1.7f, 8.0f},
            {"below", "stops below 0.18 that become black", &below, {}, 4, {}, 30.0f},
            {"above", "stops above 0.18 that become white", &above, {}, 2, {}, 30.0f}};
  }

  static constexpr float display_power = 2.2f, power = 1.5f;
  auto colour_curve(const LuminanceMap&) const {
    const RgbMatrix in(inset_matrix(static_cast<double>(inset)));
    const RgbMatrix out(glm::inverse(inset_matrix(static_cast<double>(outset))));
    const float middle = std::log2(0.18f), range = below + above, pivot = below / range;
    const float level = std::pow(0.18f, 1 / display_power);
    const float toe = sigmoid_scale(contrast * pivot, level, power);
    const float shoulder = sigmoid_scale(contrast * (1 - pivot), 1 - level, power);
    return [ =, slope = contrast, least = middle - below, per_stop = 1 / range ](Rgb c) __attribute__((always_inline)) {
      const auto channel = [&](float v) __attribute__((always_inline)) {
        const float stops = (fast_log2(at_least(v, 1e-30f)) - least) * per_stop;
        const float x = slope * (at_most(at_least(stops, 0.0f), 1.0f) - pivot);
        // The sides share the power, so one formula with the scale of the side serves.
        const float scale = chosen(x > 0, shoulder, toe), far = at_least(std::abs(x) / scale, 1e-10f);
        const float code = level + x * fast_pow(1 + fast_pow(far, power), -1 / power);
        const float shown = fast_pow(at_least(code, 1e-6f), display_power);
        return chosen(stops > 0, shown, 0.0f);
      };
      const Rgb v = in(c);
      return out(Rgb(channel(v.r), channel(v.g), channel(v.b)));
    };
  }

  /// Rec. 709 as seen by primaries that lie on the lines from its own away from white, 1/(1-amount) as far.
  static Matrix3d inset_matrix(double amount);
};

}  // namespace lambert::tone
