#pragma once
/// --progress and --quiet, which mean the same in every command that may take long.

#include "cli_fwd.h"

#include "lambert/base/progress.h"

#include <string>

namespace lambert::cli {

struct WorkOptions {
  std::string progress;  ///< a style of progress_styles(); empty: a bar on a terminal, once the work takes long
  bool quiet = false;    ///< no progress, and of all words only errors
};
/// --progress and -q,--quiet. A style that is none is an error while flags are read.
void add_work_options(CLI::App& app, WorkOptions& o);

/// Where the work tells how far it is; empty for nowhere. With --quiet nothing but errors is logged from now on.
ProgressSink progress_of(const WorkOptions& o);
/// The same for a work that knows no more than its fraction, which may call it at any rate: a bar appears when the work
/// has taken half a second (at once if it was asked for) and changes ten times a second.
FractionSink start_work(const WorkOptions& o);

}  // namespace lambert::cli
