#pragma once
#include "lambert/base/progress.h"

#include <string>
#include <vector>

namespace lambert::cli {

/// tty: a bar on standard error; ndjson: a JSON object a line on standard error; none; empty: tty if standard error is
/// a terminal.
std::vector<std::string> progress_styles();
/// Throws Error for an unknown style.
ProgressSink progress_sink(const std::string& style);

/// "1.23 M"
std::string with_unit(double value);
/// "2 min 5 s"
std::string duration(double seconds);

}  // namespace lambert::cli
