#pragma once

#include "cli_fwd.h"

#include <limits>
#include <string>

namespace lambert::cli {

/// What a number may be: from `low` on and below `below`, which also keeps out what is not finite.
struct NumberRange {
  std::string expected;  ///< in words
  double low = 0, below = std::numeric_limits<double>::max();
};

/// Makes the parser throw Error for a number out of `range`, naming the option, the word and what was expected. A word
/// that is no number is left to the parser.
void expect_number(CLI::Option* option, const NumberRange& range);

}  // namespace lambert::cli
