#include "lambert/formats/pbrt/tokenizer.h"

#include "lambert/base/number.h"

#include <limits>
#include <utility>

namespace lambert::pbrt {
namespace {

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
bool ends_word(char c) { return is_space(c) || c == '"' || c == '[' || c == ']' || c == '#'; }
bool starts_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }

const char* parse_int32(const char* p, const char* end, int& value) {
  std::int64_t wide = 0;
  const char* last = parse_int(p, end, wide);
  if (wide < std::numeric_limits<int>::min() || wide > std::numeric_limits<int>::max()) return nullptr;
  value = static_cast<int>(wide);
  return last;
}

}  // namespace

std::string describe(const Token& t) {
  if (t.kind == TokenKind::end) return "the end of the file";
  const char* quote = t.kind == TokenKind::string ? "\"" : "'";
  return quote + printable(t.text) + quote;
}

Tokenizer::Tokenizer(std::string_view text, std::string file)
    : p_(text.data()),
      end_(text.data() + text.size()),
      line_start_(p_),
      file_(std::make_shared<const std::string>(std::move(file))) {}

Token Tokenizer::next() {
  if (std::exchange(has_peeked_, false)) return peeked_;
  return scan();
}

const Token& Tokenizer::peek() {
  if (!has_peeked_) peeked_ = scan();
  has_peeked_ = true;
  return peeked_;
}

void Tokenizer::skip_space() {
  for (; p_ != end_; ++p_) {
    if (*p_ == '#') {
      while (p_ != end_ && *p_ != '\n') ++p_;
      if (p_ == end_) return;
    }
    if (!is_space(*p_)) return;
    if (*p_ == '\n') ++line_, line_start_ = p_ + 1;
  }
}

const char* Tokenizer::word_end(const char* p) const {
  while (p != end_ && !ends_word(*p)) ++p;
  return p;
}

Token Tokenizer::scan() {
  skip_space();
  Token t{TokenKind::end, {}, line_, static_cast<std::size_t>(p_ - line_start_) + 1};
  if (p_ == end_) return t;
  if (*p_ == '"') return scan_string(t);
  if (*p_ == '[' || *p_ == ']') {
    t.kind = *p_ == '[' ? TokenKind::open : TokenKind::close;
    t.text = {p_++, 1};
    return t;
  }
  t.kind = starts_number(*p_) ? TokenKind::number : TokenKind::word;
  const char* last = word_end(p_);
  t.text = {p_, static_cast<std::size_t>(last - p_)};
  p_ = last;
  return t;
}

Token Tokenizer::scan_string(Token t) {
  t.kind = TokenKind::string;
  const char* first = ++p_;
  for (; p_ != end_ && *p_ != '\n'; ++p_) {
    if (*p_ == '"') {
      t.text = {first, static_cast<std::size_t>(p_ - first)};
      ++p_;
      return t;
    }
    if (*p_ == '\\' && p_ + 1 != end_ && p_[1] != '\n') ++p_;
  }
  fail(t, "this string has no closing quote on its line");
}

std::string Tokenizer::string_value(const Token& t) const {
  std::string s;
  s.reserve(t.text.size());
  for (std::size_t i = 0; i < t.text.size(); ++i) {
    char c = t.text[i];
    if (c == '\\' && i + 1 < t.text.size()) {
      constexpr std::string_view codes = "bfnrt\\'\"", meanings = "\b\f\n\r\t\\'\"";
      const std::size_t code = codes.find(t.text[++i]);
      if (code == std::string_view::npos) {
        Token at = t;
        at.column += i;
        fail(at, std::string("unknown escape '\\") + printable(t.text.substr(i, 1)) + "' (known: b f n r t \\ ' \")");
      }
      c = meanings[code];
    }
    s += c;
  }
  return s;
}

std::string Tokenizer::expect_string(const char* what) {
  const Token t = next();
  if (t.kind != TokenKind::string) {
    fail(t, std::string("expected ") + what + " in quotes, found " + describe(t));
  }
  return string_value(t);
}

float Tokenizer::expect_number(const char* what) {
  const Token t = next();
  float value = 0;
  const char* last = t.text.data() + t.text.size();
  if (t.kind != TokenKind::number || parse_float(t.text.data(), last, value) != last) {
    fail(t, std::string("expected ") + what + ", a finite number, found " + describe(t));
  }
  return value;
}

template <class Number, class Parse>
void Tokenizer::read_run(std::vector<Number>& out, const Parse& parse, const char* expected) {
  if (std::exchange(has_peeked_, false)) {
    p_ = peeked_.text.data() - (peeked_.kind == TokenKind::string ? 1 : 0);
    if (peeked_.kind == TokenKind::end) p_ = end_;
  }
  for (;;) {
    skip_space();
    if (p_ == end_ || !starts_number(*p_)) return;
    Number value{};
    const char* last = parse(p_, end_, value);
    if (!last || (last != end_ && !ends_word(*last))) {
      const Token t = scan();
      fail(t, std::string("expected ") + expected + ", found " + describe(t));
    }
    out.push_back(value);
    p_ = last;
  }
}

void Tokenizer::read_numbers(std::vector<float>& out) { read_run(out, parse_float, "a finite number"); }
void Tokenizer::read_numbers(std::vector<int>& out) { read_run(out, parse_int32, "an integer of 32 bits"); }

}  // namespace lambert::pbrt
