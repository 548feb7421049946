#pragma once
#include "lambert/base/progress.h"

#include <string>
#include <vector>

namespace lambert::cli {

/// tty: a bar on standard error; ndjson: a JSON object a line on standard error; none; empty: tty if standard error is
/// a terminal.
std::vector<std::string> progress_styles();
/// Throws Error for an unknown style. When the last copy of the sink goes away, so does a bar that is not at its end:
/// its line is ended.
ProgressSink progress_sink(const std::string& style);

/// What is printed next stands on a line of its own, even if a bar is being drawn.
void end_bar_line();

/// "1.23 M"
std::string with_unit(double value);
/// "2 min 5 s"
std::string duration(double seconds);

}  // namespace lambert::cli
