#pragma once
/// What the verbs of `lambert hdr` share.

#include "../cli_fwd.h"
#include "../work.h"

#include "lambert/image/hdr/align.h"
#include "lambert/image/hdr/recover.h"
#include "lambert/image/hdr/stack.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace lambert::cli {

/// Photographs and their exposures, and what is done with them before any merging.
struct StackOptions {
  std::vector<std::string> files;
  std::string list, times, stops;
  std::string align = "rigid";
  int largest_shift = 64;
  int reference = -1;  ///< -1: the one with most usable pixels
  WorkOptions work;
};
void add_stack_options(CLI::App& app, StackOptions& o);

struct LoadedStack {
  hdr::ExposureStack stack;  ///< aligned
  std::vector<hdr::Motion> motions;
  std::size_t reference = 0;
};
/// Reads, checks and aligns. Throws Error.
LoadedStack load_stack(const StackOptions& o, const FractionSink& progress);

struct RecoveryOptions {
  std::string response = "auto";  ///< a method of recovery, or a known response
  hdr::RecoverySettings settings;
};
void add_recovery_options(CLI::App& app, RecoveryOptions& o);
/// Recovers, or takes the known response (with no samples).
hdr::Recovery response_for(const RecoveryOptions& o, const hdr::ExposureStack& stack);
/// The noise at the middle code of the channel that has most.
double middle_noise(const hdr::CodeNoise& noise);

std::function<int()> add_hdr_merge(CLI::App& app);
std::function<int()> add_hdr_response(CLI::App& app);
std::function<int()> add_hdr_expose(CLI::App& app);
std::function<int()> add_hdr_range(CLI::App& app);

}  // namespace lambert::cli
