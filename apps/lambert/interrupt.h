#pragma once
#include <stop_token>

namespace lambert::cli {

/// From now on Ctrl-C (or SIGTERM, or a terminal that is closed) ends the process at once with the status
/// `interrupted`. Files that are being written are removed, then and when the reader of a pipe goes away: each output
/// is there whole, as it was before, or not at all.
void end_on_interrupt();

/// From now on the first one requests a stop of the returned token instead; a second one ends the process. After
/// end_on_interrupt().
std::stop_token stop_on_interrupt();

}  // namespace lambert::cli
