#include "lambert/base/number.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace lambert {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// from_chars says "out of range" for overflow and underflow alike.
template <class Real>
bool parse_extreme(const char* p, const char* last, Real& value) {
  const double wide = std::strtod(std::string(p, last).c_str(), nullptr);
  if (!(std::abs(wide) <= static_cast<double>(std::numeric_limits<Real>::max()))) return false;
  value = static_cast<Real>(wide);
  return true;
}

template <class Real>
const char* parse_real(const char* p, const char* end, Real& value) {
  const bool plus = p != end && *p == '+';
  if (plus) ++p;
  const char* digits = p;
  if (!plus && digits != end && *digits == '-') ++digits;
  if (digits == end || !(is_digit(*digits) || (*digits == '.' && digits + 1 != end && is_digit(digits[1])))) {
    return nullptr;
  }
  const auto [last, error] = std::from_chars(p, end, value);
  if (error == std::errc()) return last;
  return error == std::errc::result_out_of_range && parse_extreme(p, last, value) ? last : nullptr;
}

template <class Real>
void append_real(std::string& text, Real value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace

const char* parse_float(const char* p, const char* end, float& value) { return parse_real(p, end, value); }
const char* parse_double(const char* p, const char* end, double& value) { return parse_real(p, end, value); }

const char* parse_int(const char* p, const char* end, std::int64_t& value) {
  if (p != end && *p == '+') {
    if (++p != end && !is_digit(*p)) return nullptr;
  }
  const auto [last, error] = std::from_chars(p, end, value);
  return error == std::errc() ? last : nullptr;
}

void append_number(std::string& text, double value) { append_real(text, value); }
void append_number(std::string& text, float value) { append_real(text, value); }

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string printable(std::string_view word) {
  std::string s(word.substr(0, 40));
  for (char& c : s) {
    if (c < ' ' || c > '~') c = '?';
  }
  return word.size() > 40 ? s + "…" : s;
}

}  // namespace lambert
