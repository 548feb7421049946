#pragma once
/// Lines of words: the shape of OBJ and MTL files.

#include "lambert/base/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lambert::obj {

/// The words of one line, taken one by one.
class Words {
 public:
  Words() = default;
  Words(std::string_view line, std::size_t number, const std::string* file)
      : line_(line), number_(number), file_(file) {}

  std::string_view next();  ///< empty at the end of the line
  std::string_view rest();  ///< all that is left, without the blanks around it
  bool at_end();
  /// A finite number if one stands next, else nothing is taken.
  std::optional<float> try_number();
  /// Throws Error saying that `what` was expected.
  float number(const char* what);
  /// Throws Error at the word last taken.
  [[noreturn]] void fail(const std::string& message) const { throw Error({*file_, number_, word_ + 1}, message); }

 private:
  void skip_blanks();

  std::string_view line_;
  std::size_t number_ = 0, position_ = 0, word_ = 0;
  const std::string* file_ = nullptr;
};

/// Cuts a text into lines: without comments, a backslash at a line's end joins the next one to it.
class LineReader {
 public:
  /// Both must outlive the reader.
  LineReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}
  /// False at the end. The words refer to the reader until the next call.
  bool next(Words& words);

 private:
  std::string_view take_line();

  std::string_view text_;
  const std::string& file_;
  std::size_t offset_ = 0, line_ = 0;
  std::string joined_;
};

}  // namespace lambert::obj
