#include "options.h"

#include "../exposure_flag.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <string_view>
#include <tuple>
#include <utility>

namespace lambert::cli {
namespace {

std::pair<float, float> percentiles(const std::string& text) {
  const auto read = [&](std::string_view word) {
    float value = -1;
    const bool whole = parse_float(word.data(), word.data() + word.size(), value) == word.data() + word.size();
    return whole ? value : -1.0f;
  };
  const auto comma = text.find(',');
  const float low = read(std::string_view(text).substr(0, comma));
  const float high = comma == std::string::npos ? -1.0f : read(std::string_view(text).substr(comma + 1));
  if (!(low >= 0 && low < high && high <= 100))
    throw Error("--percentiles: expected LOW,HIGH with 0 <= LOW < HIGH <= 100, got '" + printable(text) + "'");
  return {low, high};
}

}  // namespace

ToneSettings common_settings(const TonemapOptions& o) {
  AutoExposure automatic{.key = o.key};
  if (!o.percentiles.empty()) std::tie(automatic.low, automatic.high) = percentiles(o.percentiles);
  ToneSettings settings{.saturation = o.saturation};
  set_exposure(settings, o.exposure, automatic);
  if (!o.channels.empty()) settings.channels = tone_channels(o.channels);
  return settings;
}

ToneOperator configured_operator(const std::string& name, const std::vector<std::string>& assignments) {
  ToneOperator op = tone_operator(name);
  SettingTable table = tone_operator_settings(op);
  for (const std::string& assignment : assignments) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos) throw Error("--set: expected key=value, got '" + printable(assignment) + "'");
    table.set(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  return op;
}

}  // namespace lambert::cli
