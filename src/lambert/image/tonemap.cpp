#include "lambert/image/tonemap.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lambert {
namespace {

constexpr std::array<std::pair<std::string_view, ToneOperator>, 3> operators{{
    {"linear", ToneOperator::linear},
    {"reinhard", ToneOperator::reinhard},
    {"filmic", ToneOperator::filmic},
}};

float filmic(float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); }

/// Beyond this everything is white; it keeps the curves from dividing infinities.
constexpr float white = 1e9f;

Rgb mapped(Rgb c, ToneOperator curve) {
  switch (curve) {
    case ToneOperator::linear: return c;
    case ToneOperator::reinhard: return c / (1 + std::max(0.0f, luminance(c)));
    case ToneOperator::filmic: {
      // The curve was fitted for an exposure of 0.6.
      const Rgb x = max(c * 0.6f, Rgb(0.0f));
      return {filmic(x.r), filmic(x.g), filmic(x.b)};
    }
  }
  return c;
}

/// NaN is black.
float displayable(float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; }

}  // namespace

ToneOperator tone_operator(std::string_view name) {
  for (const auto& [known, value] : operators)
    if (known == name) return value;
  throw Error("unknown tone operator " + unknown_word(name, tone_operator_names()));
}

std::vector<std::string> tone_operator_names() {
  std::vector<std::string> names;
  for (const auto& entry : operators) names.emplace_back(entry.first);
  return names;
}

Image tonemap(const Image& image, const ToneSettings& settings) {
  const auto alpha = image.channel("A");
  Image out(image.width(), image.height(), alpha ? rgba_channels() : rgb_channels());
  out.metadata = image.metadata;
  const float scale = std::exp2(settings.exposure);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Rgb c = image.rgb(x, y) * scale;
      const Rgb shown = mapped({std::min(c.r, white), std::min(c.g, white), std::min(c.b, white)}, settings.curve);
      out.set_rgb(x, y, {displayable(shown.r), displayable(shown.g), displayable(shown.b)});
      if (alpha) out.at(x, y, 3) = image.at(x, y, *alpha);
    }
  return out;
}

}  // namespace lambert
