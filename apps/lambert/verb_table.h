#pragma once

#include "cli_fwd.h"

#include <functional>
#include <span>

namespace lambert::cli {

/// A verb below a command: `lambert polygon union`.
struct Verb {
  const char *name, *summary;
  std::function<int()> (*add)(CLI::App&);
};

/// Registers the verbs, of which one must be given; what is returned runs it.
std::function<int()> add_verbs(CLI::App& app, std::span<const Verb> verbs);

}  // namespace lambert::cli
