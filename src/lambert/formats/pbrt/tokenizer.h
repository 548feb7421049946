#pragma once
/// The words of pbrt text: names, quoted strings, numbers and brackets; `#` starts a comment.

#include "lambert/base/error.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::pbrt {

/// A place in one of the files of a scene; cheap to keep.
struct Place {
  std::shared_ptr<const std::string> file;
  std::size_t line = 0, column = 0;
  operator SourceLocation() const { return {file ? *file : std::string(), line, column}; }
};

enum class TokenKind : std::uint8_t { word, string, number, open, close, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;  ///< of strings: what stands between the quotes, escapes as written
  std::size_t line = 0, column = 0;
};

class Tokenizer {
 public:
  /// `text` must outlive the tokenizer.
  Tokenizer(std::string_view text, std::string file);

  Token next();
  const Token& peek();
  Place place(const Token& t) const { return {file_, t.line, t.column}; }
  const std::string& file() const { return *file_; }
  [[noreturn]] void fail(const Token& at, const std::string& message) const { throw Error(place(at), message); }

  /// What a string token means, its escapes resolved.
  std::string string_value(const Token& t) const;
  /// The next token as a string, word or finite number; throws Error saying that `what` was expected.
  std::string expect_string(const char* what);
  float expect_number(const char* what);
  /// Appends all numbers that stand next; the loop that reads big meshes.
  void read_numbers(std::vector<float>& out);
  void read_numbers(std::vector<int>& out);

 private:
  void skip_space();
  Token scan();
  Token scan_string(Token t);
  const char* word_end(const char* p) const;
  template <class Number, class Parse>
  void read_run(std::vector<Number>& out, const Parse& parse, const char* expected);

  const char *p_, *end_, *line_start_;
  std::size_t line_ = 1;
  std::shared_ptr<const std::string> file_;
  Token peeked_;
  bool has_peeked_ = false;
};

/// How a message names a token: 'word', "string" or the end of the file.
std::string describe(const Token& t);

}  // namespace lambert::pbrt
