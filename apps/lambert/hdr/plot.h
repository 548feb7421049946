#pragma once
#include "lambert/image/hdr/response.h"

#include <string>

namespace lambert::cli {

/// Code over the exposure behind it, a curve for each channel: .svg or pixels.
void plot_response(const std::string& path, const hdr::Response& response);

}  // namespace lambert::cli
