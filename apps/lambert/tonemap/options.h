#pragma once
#include "../work.h"

#include "lambert/image/tonemap/tonemap.h"

#include <string>
#include <vector>

namespace lambert::cli {

/// What was typed behind `lambert tonemap`.
struct TonemapOptions {
  std::vector<std::string> inputs, outputs, operators, assignments;
  std::string exposure = "0", channels, percentiles;
  float key = AutoExposure{}.key;
  float saturation = 1;
  bool montage = false, list = false, json = false;
  int columns = 0, tile_width = 400;
  WorkOptions work;
};

/// Exposure, channels and saturation. Throws Error naming the flag and the word.
ToneSettings common_settings(const TonemapOptions& o);
/// The operator of that name with settings "key=value". Throws Error as well.
ToneOperator configured_operator(const std::string& name, const std::vector<std::string>& assignments);

/// The operators with their settings, as text or JSON.
void print_operators(bool json);

}  // namespace lambert::cli
