#include "number_range.h"

#include "lambert/base/error.h"

#include <CLI/CLI.hpp>

#include <cstdlib>

namespace lambert::cli {

void expect_number(CLI::Option* option, const NumberRange& range) {
  option->check([option, range](const std::string& word) -> std::string {
    char* end = nullptr;
    const long double value = std::strtold(word.c_str(), &end);  // double does not know the last seed from 2^64
    const bool is_number = !word.empty() && *end == '\0';
    const auto low = static_cast<long double>(range.low), below = static_cast<long double>(range.below);
    if (is_number && !(value >= low && value < below))
      throw Error(option->get_name() + ": expected " + range.expected + ", got '" + word + "'");
    return {};
  });
}

}  // namespace lambert::cli
