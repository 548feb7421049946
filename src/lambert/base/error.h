#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// A place in an input: line and column count from 1; 0 means unknown (binary files give an offset in the message).
struct SourceLocation {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string to_string() const;  ///< "file:line:column", without the parts that are unknown
};

/// What the user gave cannot be used. `what()` is one line: "file:line:column: message".
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
  Error(const SourceLocation& where, const std::string& message);
};

/// "'word' (known: a, b, c)" with the nearest of `allowed` suggested when the word looks like a slip of it.
std::string unknown_word(std::string_view word, const std::vector<std::string>& allowed);

}  // namespace lambert
