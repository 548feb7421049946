#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

namespace lambert {

/// Calls f(line, number) for every line of `text`, without the "\n" that ends it; numbers count from 1. The last line
/// need not be ended.
template <class F>
void for_lines(std::string_view text, F&& f) {
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    f(text.substr(begin, end - begin), ++number);
    begin = end + 1;
  }
}

}  // namespace lambert
