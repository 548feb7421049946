#include "work.h"

#include "progress_report.h"

#include "lambert/base/log.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <memory>

namespace lambert::cli {

void add_work_options(CLI::App& app, WorkOptions& o) {
  app.add_option("--progress", o.progress, "tty, ndjson or none; by default a bar if standard error is a terminal")
      ->check(CLI::IsMember(progress_styles()));
  app.add_flag("-q,--quiet", o.quiet, "Of words only errors; paths, numbers and JSON stay");
}

ProgressSink progress_of(const WorkOptions& o) {
  if (o.quiet) log::set_level(log::Level::error);
  return o.quiet ? ProgressSink() : progress_sink(o.progress);
}

FractionSink start_work(const WorkOptions& o) {
  const ProgressSink sink = progress_of(o);
  if (!sink) return {};
  using Clock = std::chrono::steady_clock;
  struct State {
    Clock::time_point start = Clock::now();
    double next = 0;  // when to tell again, in seconds
    bool told = false;
  };
  const auto state = std::make_shared<State>();  // one of all copies
  if (o.progress.empty()) state->next = 0.5;
  state->told = !o.progress.empty();
  return [sink, state](double fraction) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - state->start).count();
    if (elapsed < state->next && !(fraction >= 1 && state->told)) return;
    state->next = elapsed + 0.1;
    state->told = true;
    sink({.fraction = fraction,
          .elapsed_seconds = elapsed,
          .remaining_seconds = fraction > 0 ? elapsed / fraction * (1 - fraction) : 0});
  };
}

}  // namespace lambert::cli
