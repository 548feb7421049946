#pragma once
#include "lambert/image/image.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class ToneOperator {
  linear,    ///< clip
  reinhard,  ///< L/(1+L) on luminance (row LF-24)
  filmic,    ///< a fit of the ACES reference rendering curve per channel (Narkowicz 2015)
};
ToneOperator tone_operator(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> tone_operator_names();

struct ToneSettings {
  ToneOperator curve = ToneOperator::linear;
  float exposure = 0;  ///< in stops: radiance is first scaled by 2^exposure
};
/// Maps the colour channels (R, G, B) to [0,1], still linear; other channels are dropped except A.
Image tonemap(const Image& image, const ToneSettings& settings);

}  // namespace lambert
