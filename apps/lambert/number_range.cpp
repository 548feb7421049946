#include "number_range.h"

#include "lambert/base/error.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdlib>

namespace lambert::cli {

NumberRange whole_number(std::uint64_t first, std::uint64_t last) {
  return {.expected = fmt::format("a whole number from {} to {}", first, last),
          .low = static_cast<double>(first),
          .below = static_cast<double>(last) + 1};
}

NumberRange angle_in_degrees(double first, double last) {
  return {.expected = fmt::format("an angle from {} to {} degrees", first, last),
          .low = first,
          .below = std::nextafter(static_cast<float>(last), std::numeric_limits<float>::max())};
}

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

void add_seed(CLI::App& app, std::uint64_t& seed, const std::string& help) {
  expect_number(app.add_option("--seed", seed, help)->capture_default_str(),
                whole_number(0, std::numeric_limits<std::uint64_t>::max()));
}

}  // namespace lambert::cli
