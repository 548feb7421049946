#pragma once

#include "cli_fwd.h"

#include <cstdint>
#include <limits>
#include <string>

namespace lambert::cli {

/// What a number may be: from `low` on and below `below`, which also keeps out what is not finite.
struct NumberRange {
  std::string expected;  ///< in words
  double low = 0, below = std::numeric_limits<double>::max();
};

/// "a whole number from 1 to 64"
NumberRange whole_number(std::uint64_t first, std::uint64_t last);
/// "an angle from 0 to 180 degrees"
NumberRange angle_in_degrees(double first, double last);

/// Makes the parser throw Error for a number out of `range`, naming the option, the word and what was expected. A word
/// that is no number is left to the parser.
void expect_number(CLI::Option* option, const NumberRange& range);

/// --seed of 64 bits.
void add_seed(CLI::App& app, std::uint64_t& seed, const std::string& help);

}  // namespace lambert::cli
