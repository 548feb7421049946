#include "lambert/image/composite/lexer.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <utility>

namespace lambert::composite {
namespace {

constexpr std::string_view signs = "()[],:=";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool ends_word(char c) { return is_blank(c) || c == '"' || c == '\'' || signs.find(c) != std::string_view::npos; }

std::size_t behind_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

bool parse_number(std::string_view word, double& number) {
  const char* end = word.data() + word.size();
  return parse_double(word.data(), end, number) == end;
}

}  // namespace

bool looks_like_file(std::string_view word) {
  return word == "-" || word.find_first_of("./#%") != std::string_view::npos;
}

bool is_bare(std::string_view word) {
  double number = 0;
  if (word.empty() || parse_number(word, number)) return false;
  for (const char c : word)
    if (ends_word(c)) return false;
  return true;
}

Token Lexer::next() {
  Token left = std::move(token_);
  token_ = {};
  at_ = behind_blanks(text_, at_);
  token_.at = {at_, at_};
  if (at_ == text_.size()) return left;
  const char first = text_[at_];
  if (signs.find(first) != std::string_view::npos) {
    token_.kind = TokenKind::sign;
    token_.text = first;
    ++at_;
  } else if (first == '"' || first == '\'') {
    token_.kind = TokenKind::quoted;
    for (++at_; at_ < text_.size() && text_[at_] != first; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      token_.text += text_[at_];
    }
    if (at_ == text_.size()) fail_at(token_.at.begin, std::string("no closing ") + first);
    ++at_;
  } else {
    while (at_ < text_.size() && !ends_word(text_[at_])) ++at_;
    token_.text = std::string(text_.substr(token_.at.begin, at_ - token_.at.begin));
    token_.kind = parse_number(token_.text, token_.number) ? TokenKind::number : TokenKind::word;
  }
  token_.at.end = at_;
  return left;
}

char Lexer::following() const {
  const std::size_t at = behind_blanks(text_, at_);
  return at < text_.size() ? text_[at] : '\0';
}

std::string Lexer::found() const {
  return token_.kind == TokenKind::end ? "the end" : "'" + printable(token_.at.in(text_)) + "'";
}

void Lexer::fail(const std::string& expected) const {
  fail_at(token_.at.begin, "expected " + expected + ", found " + found());
}

void Lexer::fail_at(std::size_t offset, const std::string& message) const {
  throw Error(location_in(text_, name_, offset), message);
}

}  // namespace lambert::composite
