#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/image.h"
#include "lambert/image/tonemap/operators.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// The operator of that name with its defaults; throws Error for an unknown one.
ToneOperator tone_operator(std::string_view name);
std::vector<std::string> tone_operator_names();
std::string tone_operator_name(const ToneOperator& op);
std::string tone_operator_summary(const ToneOperator& op);
/// The settings of an operator, which must outlive the table.
SettingTable tone_operator_settings(ToneOperator& op);

/// What an operator is applied to (E-LF-10). Luminance: colours keep their ratios, c' = (c/L)^saturation L'. Rgb: each
/// channel is mapped as though it were the luminance, which takes saturation from bright colours; statistics are
/// those of the luminance.
enum class ToneChannels { luminance, rgb };
ToneChannels tone_channels(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> tone_channels_names();

/// Places the log-average of the luminances between two percentiles at the key.
struct AutoExposure {
  float key = 0.18f;
  float low = 1, high = 99;  ///< percentiles; 0 <= low < high <= 100
};

struct ToneSettings {
  ToneOperator op = tone::Linear{};
  float exposure = 0;                     ///< in stops: radiance is first scaled by 2^exposure
  std::optional<AutoExposure> automatic;  ///< found first; `exposure` is added to it
  std::optional<ToneChannels> channels;   ///< by default as the operator was published
  float saturation = 1;
};

/// Maps colours to the display: linear display light in [0, 1]. The image's other channels are dropped, except A, which
/// is kept (in [0, 1]): premultiplied colours are divided by it, mapped and multiplied again; where A is 0 they are
/// mapped as they are. Grey images stay grey. NaN and negative values are black, infinite ones white. The result
/// does not depend on the number of threads.
Image tonemap(const Image& image, const ToneSettings& settings);
/// The same in the memory of the image where its channels allow.
Image tonemap(Image&& image, const ToneSettings& settings);

/// The factor on radiance, as a power of 2, that `automatic` asks for.
float auto_exposure_stops(const Image& image, const AutoExposure& automatic);

}  // namespace lambert
