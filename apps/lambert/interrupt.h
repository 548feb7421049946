#pragma once
#include <stop_token>

namespace lambert::cli {

/// From now on the first Ctrl-C (or SIGTERM) requests a stop of the returned token; a second one ends the process at
/// once.
std::stop_token stop_on_interrupt();

}  // namespace lambert::cli
