#include "lambert/base/json_events.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lambert {
namespace {

/// Every event's kind and own text.
struct Recorder : JsonEvents {
  explicit Recorder(std::string_view json) : text(json) {}
  void add(char kind, TextRange at) {
    if (!text.empty()) seen.push_back(std::string(1, kind) + std::string(at.in(text)));
  }
  void null(TextRange at) override { add('0', at); }
  void boolean(bool, TextRange at) override { add('b', at); }
  void number(double value, TextRange at) override {
    add('n', at);
    numbers.push_back(value);
  }
  void string(std::string, TextRange at) override { add('s', at); }
  void begin_array(TextRange at) override { add(' ', at); }
  void end_array(TextRange at) override { add(' ', at); }
  void begin_object(TextRange at) override { add(' ', at); }
  void key(std::string, TextRange at) override { add('k', at); }
  void end_object(TextRange at) override { add(' ', at); }

  std::string_view text;
  std::vector<std::string> seen;
  std::vector<double> numbers;
};

TEST(JsonEvents, EveryValueKnowsItsOwnText) {
  const std::string text =
      "\xef\xbb\xbf {\"a\\\"\" :\t[ 1,-2.5e1 ,null],\n\"b\":{\"c\":true},\"d\":[\"x, :\",[]],\"e\":7}";
  Recorder events(text);
  parse_json_events(text, "f", events);
  EXPECT_EQ(events.seen,
            (std::vector<std::string>{" {",        "k\"a\\\"\"", " [",     "n1",    "n-2.5e1", "0null",  " ]",
                                      "k\"b\"",    " {",         "k\"c\"", "btrue", " }",      "k\"d\"", " [",
                                      "s\"x, :\"", " [",         " ]",     " ]",    "k\"e\"",  "n7",     " }"}));
  EXPECT_EQ(events.numbers, (std::vector<double>{1, -25, 7}));
}

TEST(JsonEvents, ANumberMayEndTheText) {
  for (const std::string text : {"12", " 12 ", "12\n"}) {
    Recorder events(text);
    parse_json_events(text, "f", events);
    EXPECT_EQ(events.seen, std::vector<std::string>{"n12"}) << text;
  }
}

TEST(JsonEvents, NumbersKeepTheirSigns) {
  Recorder events("");
  parse_json_events("[-0, 0, -0.0, -1, 9223372036854775807, -9223372036854775808, 18446744073709551616]", "f", events);
  EXPECT_EQ(events.numbers, (std::vector<double>{0, 0, 0, -1, 0x1p63, -0x1p63, 0x1p64}));
  EXPECT_TRUE(std::signbit(events.numbers[0]));
  EXPECT_FALSE(std::signbit(events.numbers[1]));
  EXPECT_TRUE(std::signbit(events.numbers[2]));
}

TEST(JsonEvents, PlacesCountFromOne) {
  EXPECT_EQ(location_in("ab\ncd", "f", 0).to_string(), "f:1:1");
  EXPECT_EQ(location_in("ab\ncd", "f", 2).to_string(), "f:1:3");
  EXPECT_EQ(location_in("ab\ncd", "f", 4).to_string(), "f:2:2");
  EXPECT_EQ(location_in("ab\ncd", "f", 99).to_string(), "f:2:3");
}

}  // namespace
}  // namespace lambert
