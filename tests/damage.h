#pragma once
/// For tests of readers: whatever is damaged is read or refused with an Error, never anything else.

#include "lambert/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>

namespace lambert {

/// The message of the Error that `f` throws; fails the test when it throws none.
template <class F>
std::string error_of(F&& f) {
  try {
    f();
  } catch (const Error& e) {
    return e.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return {};
}

/// Damages `text` in one of several ways: cut off, bytes changed, pieces doubled or removed, numbers replaced.
inline std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  static constexpr std::string_view nasty[] = {"-1", "1e999", "nan", "4294967295", "\"", "[",
                                               "]",  "\\",    "#",   "\n",         " "};
  for (std::size_t edits = 1 + below(3); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = below(text.size()), length = 1 + below(std::min<std::size_t>(text.size() - at, 40));
    switch (below(5)) {
      case 0: text.resize(at); break;
      case 1: text[at] = static_cast<char>(below(256)); break;
      case 2: text.insert(at, text.substr(at, length)); break;
      case 3: text.erase(at, length); break;
      default: text.replace(at, std::min<std::size_t>(length, 4), nasty[below(std::size(nasty))]);
    }
  }
  return text;
}

/// Reads `count` damaged versions of `text`: each is either read or refused with an Error.
template <class Read>
void expect_survives_damage(const std::string& text, int count, const Read& read) {
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    try {
      read(mutated(text, random));
    } catch (const Error& e) {
      ++refused;
      ASSERT_STRNE(e.what(), "");
    }
  }
  EXPECT_GT(refused, count / 10) << "the damage should show";
}

}  // namespace lambert
