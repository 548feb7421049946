#pragma once
/// What all subcommands share.

#include "cli_fwd.h"

#include <functional>
#include <vector>

namespace lambert::cli {

/// Exit statuses (docs/guide/command-line.md).
inline constexpr int done = 0, failed = 1, usage_error = 2, interrupted = 130;
/// Of 'compare', whose 0 to 3 are verdicts.
inline constexpr int not_compared = 4;

/// Registers a subcommand; what it returns is run when the subcommand was given, and its result is the exit status.
using Command = std::function<std::function<int()>(CLI::App& app)>;

std::function<int()> add_render(CLI::App& app);
std::function<int()> add_info(CLI::App& app);
std::function<int()> add_methods(CLI::App& app);
std::function<int()> add_image(CLI::App& app);
std::function<int()> add_polygon(CLI::App& app);
std::function<int()> add_lab(CLI::App& app);
std::function<int()> add_tonemap(CLI::App& app);
std::function<int()> add_compare(CLI::App& app);
std::function<int()> add_hdr(CLI::App& app);
std::function<int()> add_probe(CLI::App& app);
std::function<int()> add_composite(CLI::App& app);
std::function<int()> add_denoise(CLI::App& app);
std::function<int()> add_completion(CLI::App& app);

}  // namespace lambert::cli
