#include "lambert/image/tonemap/tonemap.h"

#include "lambert/image/tonemap/fast_math.h"
#include "lambert/image/tonemap/job.h"

#include <cmath>
#include <utility>

namespace lambert {

using namespace tone;

namespace {

void tonemap_into(Image& out, const Image& image, const ToneSettings& settings) {
  const float automatic = settings.automatic ? auto_exposure_stops(image, *settings.automatic) : 0;
  const Job job{.rows = RadianceRows(image),
                .out = &out,
                .scale = std::exp2(settings.exposure + automatic),
                .channels = settings.channels,
                .saturation = settings.saturation};
  std::visit([&](const auto& op) { job.run(op); }, settings.op);
}

}  // namespace

float auto_exposure_stops(const Image& image, const AutoExposure& a) {
  const LuminanceMap map = RadianceRows(image).luminance_map(1);
  const float low = map.percentile(a.low), high = map.percentile(a.high);
  double sum = 0;
  std::size_t counted = 0;
  for (const float l : map.luminance.values)
    if (l >= least_luminance && l >= low && l <= high) {
      sum += static_cast<double>(fast_log2(l));
      ++counted;
    }
  return counted == 0 ? 0 : std::log2(a.key) - static_cast<float>(sum / static_cast<double>(counted));
}

Image tonemap(const Image& image, const ToneSettings& settings) {
  Image out = empty_display(image);
  tonemap_into(out, image, settings);
  return out;
}

Image tonemap(Image&& image, const ToneSettings& settings) {
  if (image.channels() != display_channels(image)) return tonemap(image, settings);
  tonemap_into(image, image, settings);
  return std::move(image);
}

}  // namespace lambert
