#include "lambert/base/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace lambert {
namespace {

/// The number, if the whole text is one.
std::optional<float> whole_float(std::string_view text) {
  float value = 0;
  const char* last = text.data() + text.size();
  return parse_float(text.data(), last, value) == last ? std::optional(value) : std::nullopt;
}
std::optional<std::int64_t> whole_int(std::string_view text) {
  std::int64_t value = 0;
  const char* last = text.data() + text.size();
  return parse_int(text.data(), last, value) == last ? std::optional(value) : std::nullopt;
}

TEST(Number, FloatsInAllSpellings) {
  EXPECT_EQ(whole_float("1"), 1.0f);
  EXPECT_EQ(whole_float("-1.5"), -1.5f);
  EXPECT_EQ(whole_float("+.25"), 0.25f);
  EXPECT_EQ(whole_float("3."), 3.0f);
  EXPECT_EQ(whole_float("-1e-3"), -1e-3f);
  EXPECT_EQ(whole_float("2E+2"), 200.0f);
  EXPECT_EQ(whole_float("3.40282347e38"), std::numeric_limits<float>::max());
}

TEST(Number, TooSmallIsZeroTooLargeIsNone) {
  EXPECT_EQ(whole_float("1e-999"), 0.0f);
  EXPECT_EQ(whole_float("-1e-60"), -0.0f);
  EXPECT_EQ(whole_float("1e999"), std::nullopt);
  EXPECT_EQ(whole_float("3.5e38"), std::nullopt);
}

TEST(Number, DoublesGoOutAndInUnchanged) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = number_text(value);
    double back = 0;
    ASSERT_EQ(parse_double(text.data(), text.data() + text.size(), back), text.data() + text.size()) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(back)) << text;
  }
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.0), "-0");
  double huge = 0;
  const std::string_view too_large = "1e309";
  EXPECT_EQ(parse_double(too_large.begin(), too_large.end(), huge), nullptr);
}

TEST(Number, WhatIsNoNumber) {
  for (const char* text : {"", "-", "+", ".", "+-1", "--1", "inf", "-inf", "nan", "abc", "e5"}) {
    EXPECT_EQ(whole_float(text), std::nullopt) << text;
  }
  for (const char* text : {"", "-", "+", "+-1", "1.5", "99999999999999999999", "x"}) {
    EXPECT_EQ(whole_int(text), std::nullopt) << text;
  }
  EXPECT_EQ(whole_int("-17"), -17);
  EXPECT_EQ(whole_int("+17"), 17);
}

TEST(Number, PrintableIsShortAndPlain) {
  EXPECT_EQ(printable("a\x01\xffz"), "a??z");
  EXPECT_LT(printable(std::string(1000, 'x')).size(), 50u);
  EXPECT_EQ(printable("évil 漢 \xf0\x9f\x8c\x8d"), "évil 漢 \xf0\x9f\x8c\x8d");
  EXPECT_EQ(printable("\xc3"), "?") << "cut off";
  EXPECT_EQ(printable("\xc0\xaf"), "??") << "overlong";
  EXPECT_EQ(printable("\xc2\x9b"
                      "1m"),
            "??1m")
      << "a terminal's escape";
  EXPECT_EQ(printable("\xed\xa0\x80"), "???") << "half of a surrogate pair";
}

}  // namespace
}  // namespace lambert
