#include "lambert/base/json_events.h"

#include "lambert/base/number.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace lambert {
namespace {

/// Counts how much of the text the library has consumed, which its events do not tell.
class CountedIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedIterator(const char* at, std::size_t* consumed) : at_(at), consumed_(consumed) {}
  reference operator*() const { return *at_; }
  CountedIterator& operator++() {
    ++at_;
    ++*consumed_;
    return *this;
  }
  CountedIterator operator++(int) {
    CountedIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountedIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountedIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* consumed_;
};

bool is_between_values(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':'; }
bool is_in_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E'; }

/// Finds the place of each of the library's events and hands it on.
class Placed {
 public:
  Placed(std::string_view text, const std::string& name, JsonEvents& events)
      : text_(text), name_(name), events_(events), end_(text.starts_with("\xef\xbb\xbf") ? 3 : 0) {}

  void parse() {
    const CountedIterator first(text_.data(), &consumed_), last(text_.data() + text_.size(), &consumed_);
    nlohmann::json::sax_parse(first, last, this);
  }

  bool null() { return (events_.null(next(consumed_)), true); }
  bool boolean(bool b) { return (events_.boolean(b, next(consumed_)), true); }
  // Zero comes this way with its sign only: "-0".
  bool number_integer(std::int64_t i) { return number_float(i == 0 ? -0.0 : static_cast<double>(i), {}); }
  bool number_unsigned(std::uint64_t i) { return number_float(static_cast<double>(i), {}); }
  bool number_float(double d, const std::string&) {
    // Only the character behind a number ends it; it is consumed too, unless the text ends.
    const std::size_t end = is_in_number(text_[consumed_ - 1]) ? consumed_ : consumed_ - 1;
    return (events_.number(d, next(end)), true);
  }
  bool string(std::string& s) { return (events_.string(std::move(s), next(consumed_)), true); }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool key(std::string& k) { return (events_.key(std::move(k), next(consumed_)), true); }
  bool start_object(std::size_t) { return (events_.begin_object(open()), true); }
  bool start_array(std::size_t) { return (events_.begin_array(open()), true); }
  bool end_object() { return (--depth_, events_.end_object(next(consumed_)), true); }
  bool end_array() { return (--depth_, events_.end_array(next(consumed_)), true); }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& e) {
    const std::string_view what = e.what();
    const std::size_t expected = what.rfind("; expected ");
    std::string why = what.find("out_of_range") != what.npos ? "this number is too large" : "malformed JSON";
    if (!token.empty()) why += " at '" + printable(token) + "'";
    if (expected != what.npos) why += ": expected " + std::string(what.substr(expected + 11));
    throw Error(location_in(text_, name_, std::max<std::size_t>(position, 1) - 1), why);
  }

 private:
  TextRange next(std::size_t end) {
    while (end_ < end && is_between_values(text_[end_])) ++end_;
    const std::size_t begin = end_;
    end_ = end;
    return {begin, end};
  }
  TextRange open() {
    const TextRange at = next(consumed_);
    if (++depth_ > max_json_depth)
      throw Error(location_in(text_, name_, at.begin), "JSON nested deeper than " + std::to_string(max_json_depth));
    return at;
  }

  std::string_view text_;
  const std::string& name_;
  JsonEvents& events_;
  std::size_t consumed_ = 0, end_, depth_ = 0;
};

}  // namespace

SourceLocation location_in(std::string_view text, const std::string& name, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') + 1;
  const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  return {name, lines + 1, before.size() - line_start + 1};
}

void parse_json_events(std::string_view text, const std::string& name, JsonEvents& events) {
  Placed(text, name, events).parse();
}

}  // namespace lambert
