#include "lambert/formats/obj/lines.h"

#include "lambert/base/number.h"

#include <algorithm>

namespace lambert::obj {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

}  // namespace

void Words::skip_blanks() { position_ = std::min(line_.find_first_not_of(blanks, position_), line_.size()); }

bool Words::at_end() {
  skip_blanks();
  return position_ == line_.size();
}

std::string_view Words::next() {
  skip_blanks();
  word_ = position_;
  position_ = std::min(line_.find_first_of(blanks, word_), line_.size());
  return line_.substr(word_, position_ - word_);
}

std::string_view Words::rest() {
  skip_blanks();
  word_ = position_;
  position_ = line_.size();
  const std::size_t last = line_.find_last_not_of(blanks);
  return last == std::string_view::npos || last < word_ ? std::string_view() : line_.substr(word_, last + 1 - word_);
}

std::optional<float> Words::try_number() {
  const std::size_t before = position_;
  const std::string_view word = next();
  float value = 0;
  const char* last = word.data() + word.size();
  if (!word.empty() && parse_float(word.data(), last, value) == last) return value;
  position_ = before;
  return std::nullopt;
}

float Words::number(const char* what) {
  if (const auto value = try_number()) return *value;
  const std::string_view word = next();
  const std::string found = word.empty() ? "the end of the line" : "'" + printable(word) + "'";
  fail(std::string("expected ") + what + ", a finite number, found " + found);
}

std::string_view LineReader::take_line() {
  const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
  std::string_view line = text_.substr(offset_, end - offset_);
  offset_ = end + 1;
  ++line_;
  line = line.substr(0, line.find('#'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

bool LineReader::next(Words& words) {
  if (offset_ >= text_.size()) return false;
  std::string_view line = take_line();
  const std::size_t number = line_;
  if (line.ends_with('\\')) {
    joined_.clear();
    while (line.ends_with('\\')) {
      joined_.append(line.substr(0, line.size() - 1)) += ' ';
      line = offset_ < text_.size() ? take_line() : std::string_view();
    }
    joined_.append(line);
    line = joined_;
  }
  words = Words(line, number, &file_);
  return true;
}

}  // namespace lambert::obj
