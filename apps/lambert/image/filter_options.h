#pragma once
/// What the verbs of `lambert image` that filter share.

#include "../cli_fwd.h"
#include "../work.h"

#include "lambert/base/vec.h"
#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/image.h"

#include <string>
#include <vector>

namespace lambert::cli {

struct FilterOptions {
  std::string input;
  std::vector<std::string> outputs;
  std::string edge = "clamp";
  WorkOptions work;
};

/// IN, -o OUT…, --progress and --quiet.
void add_image_paths(CLI::App& app, FilterOptions& o);
void add_edge_option(CLI::App& app, FilterOptions& o);
/// Throws Error, before it reads, when an output could not be written.
Image read_input(const FilterOptions& o, const FractionSink& progress);
/// To every output; prints the paths.
void write_outputs(const FilterOptions& o, Image image, const FractionSink& progress);

/// "5" for both axes or "5x3", each from `low` to `high`. Throws Error.
Vec2 parse_per_axis(const std::string& flag, const std::string& text, float low, float high);

std::string listed(const std::vector<std::string>& names);

}  // namespace lambert::cli
