#pragma once
/// The words of an expression's text.

#include "lambert/base/json_events.h"

#include <string>
#include <string_view>

namespace lambert::composite {

enum class TokenKind { word, quoted, number, sign, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;  ///< a word, what is quoted without its quotes, or one of ( ) [ ] , : =
  double number = 0;
  TextRange at;
  bool is(char sign) const { return kind == TokenKind::sign && text[0] == sign; }
};

/// A word that may name a file without quotes.
bool looks_like_file(std::string_view word);
/// True if `word` is one token, a word.
bool is_bare(std::string_view word);

class Lexer {
 public:
  Lexer(std::string_view text, std::string name) : text_(text), name_(std::move(name)) { next(); }
  const Token& token() const { return token_; }
  /// The token, which is left behind. Throws Error for a quote that does not end.
  Token next();
  /// The character behind the token and blanks; 0 at the end.
  char following() const;
  /// Throws Error "name:line:column: expected …, found …" at the token.
  [[noreturn]] void fail(const std::string& expected) const;
  [[noreturn]] void fail_at(std::size_t offset, const std::string& message) const;
  std::string found() const;

 private:
  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  Token token_;
};

}  // namespace lambert::composite
