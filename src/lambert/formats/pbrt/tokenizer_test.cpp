#include "lambert/formats/pbrt/tokenizer.h"

#include "lambert/formats/format_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::pbrt {
namespace {

TEST(PbrtTokenizer, KindsAndPlaces) {
  Tokenizer t("Shape \"sphere\" # [ not this\n  [ -1.5e3 ]true", "a.pbrt");
  const TokenKind kinds[] = {TokenKind::word,  TokenKind::string, TokenKind::open, TokenKind::number,
                             TokenKind::close, TokenKind::word,   TokenKind::end};
  const std::string_view texts[] = {"Shape", "sphere", "[", "-1.5e3", "]", "true", ""};
  const std::size_t columns[] = {1, 7, 3, 5, 12, 13, 17};
  for (std::size_t i = 0; i < 7; ++i) {
    const Token token = t.next();
    EXPECT_EQ(token.kind, kinds[i]) << i;
    EXPECT_EQ(token.text, texts[i]) << i;
    EXPECT_EQ(token.line, i < 2 ? 1u : 2u) << i;
    EXPECT_EQ(token.column, columns[i]) << i;
  }
}

TEST(PbrtTokenizer, Escapes) {
  Tokenizer t(R"("a\"b\\c\tn" "C:\quatsch")", "a.pbrt");
  EXPECT_EQ(t.expect_string("a string"), "a\"b\\c\tn");
  EXPECT_EQ(error_of([&] { t.expect_string("a string"); }),
            "a.pbrt:1:17: unknown escape '\\q' (known: b f n r t \\ ' \")");
}

TEST(PbrtTokenizer, StringsEndOnTheirLine) {
  Tokenizer t("\n  \"abc\n\"", "a.pbrt");
  EXPECT_EQ(error_of([&] { t.next(); }), "a.pbrt:2:3: this string has no closing quote on its line");
  Tokenizer u("\"abc\\", "a.pbrt");
  EXPECT_EQ(error_of([&] { u.next(); }), "a.pbrt:1:1: this string has no closing quote on its line");
}

TEST(PbrtTokenizer, RunsOfNumbers) {
  Tokenizer t("1 2\n3 # four\n.5]", "a.pbrt");
  EXPECT_EQ(t.peek().text, "1");
  std::vector<float> numbers;
  t.read_numbers(numbers);
  EXPECT_EQ(numbers, (std::vector<float>{1, 2, 3, 0.5f}));
  const Token close = t.next();
  EXPECT_EQ(close.kind, TokenKind::close);
  EXPECT_EQ(close.line, 3u);
  EXPECT_EQ(close.column, 3u);
}

TEST(PbrtTokenizer, HostileNumbers) {
  const auto message = [](const char* text) {
    return error_of([&] {
      Tokenizer t(text, "a.pbrt");
      std::vector<float> numbers;
      t.read_numbers(numbers);
    });
  };
  EXPECT_EQ(message("1 2 1e999 3"), "a.pbrt:1:5: expected a finite number, found '1e999'");
  EXPECT_EQ(message("-inf"), "a.pbrt:1:1: expected a finite number, found '-inf'");
  EXPECT_EQ(message("1.2.3"), "a.pbrt:1:1: expected a finite number, found '1.2.3'");
  Tokenizer t("1 1.5", "a.pbrt");
  std::vector<int> integers;
  EXPECT_EQ(error_of([&] { t.read_numbers(integers); }), "a.pbrt:1:3: expected an integer of 32 bits, found '1.5'");
  Tokenizer u("4294967296", "a.pbrt");
  EXPECT_NE(error_of([&] { u.read_numbers(integers); }).find("found '4294967296'"), std::string::npos);
}

}  // namespace
}  // namespace lambert::pbrt
