#include "lambert/image/tonemap.h"

#include "lambert/base/error.h"

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
      out.set_rgb(x, y, clamp(mapped(image.rgb(x, y) * scale, settings.curve), 0, 1));
      if (alpha) out.at(x, y, 3) = image.at(x, y, *alpha);
    }
  return out;
}

}  // namespace lambert
