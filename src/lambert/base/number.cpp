#include "lambert/base/number.h"

#include <algorithm>
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

namespace {

/// Bytes of the character that `text` begins with, if it is one of UTF-8 beyond ASCII (RFC 3629, C1 controls and
/// overlong forms apart), else 0.
std::size_t utf8_size(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t size = lead >= 0xc2 && lead <= 0xdf ? 2 : lead >= 0xe0 && lead <= 0xef ? 3 : 0;
  if (size == 0 && (lead < 0xf0 || lead > 0xf4)) return 0;
  const std::size_t bytes = size == 0 ? 4 : size;
  if (text.size() < bytes) return 0;
  for (std::size_t i = 1; i < bytes; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool wrong = (lead == 0xc2 && second < 0xa0) || (lead == 0xe0 && second < 0xa0) ||
                     (lead == 0xed && second > 0x9f) || (lead == 0xf0 && second < 0x90) ||
                     (lead == 0xf4 && second > 0x8f);
  return wrong ? 0 : bytes;
}

}  // namespace

std::string printable(std::string_view word) {
  constexpr std::size_t most = 40;  // bytes
  std::string s;
  while (!word.empty() && s.size() < most) {
    const bool plain = word[0] >= ' ' && word[0] <= '~';
    const std::size_t size = plain ? 1 : utf8_size(word);
    s += size == 0 ? std::string_view("?") : word.substr(0, size);
    word.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return word.empty() ? s : s + "…";
}

}  // namespace lambert
