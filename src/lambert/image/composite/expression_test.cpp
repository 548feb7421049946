#include "lambert/image/composite/expression.h"

#include "lambert/base/error.h"
#include "lambert/base/hash.h"

#include <gtest/gtest.h>

#include <string>

namespace lambert::composite {
namespace {

std::string error_of(const std::string& text) {
  try {
    parse_expression(text);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

/// Grows trees from hashed numbers.
class Grower {
 public:
  explicit Grower(std::uint64_t seed) : seed_(seed) {}
  Expression tree(int depth) {
    Expression e;
    const auto words = all_words();
    const Word* word = depth > 0 ? &words[pick(words.size())] : nullptr;
    if (!word || pick(4) == 0) {
      static const char* files[] = {"a.exr", "shots/b.####.exr", "title card", "over", "a \"b\" \\.png",
                                    "0.5",   "x=1.exr"};
      e.text = files[pick(7)];
      return e;
    }
    e.word = word;
    if (!word->text.empty()) e.text = pick(2) ? "albedo" : "a b";
    const std::size_t inputs = word->form == Form::generator ? 0 : (word->form == Form::infix || word->second ? 2 : 1);
    for (std::size_t i = 0; i < inputs; ++i) e.inputs.push_back(tree(depth - 1));
    for (const Parameter& p : word->parameters) {
      const bool left_out = p.otherwise && pick(2) == 0;
      e.numbers.push_back(left_out ? Number{*p.otherwise, {}} : number(p));
    }
    if (word->more)
      for (std::size_t i = 2 * pick(3); i > 0; --i) e.numbers.push_back(number(word->parameters[0]));
    return e;
  }

 private:
  std::size_t pick(std::size_t n) { return hash_values(seed_, ++count_) % n; }
  double value(const Parameter& p) { return p.low + (p.high - p.low) * static_cast<double>(pick(1000)) / 1000; }
  Number number(const Parameter& p) {
    if (pick(3) > 0) return {value(p), {}};
    Number n;
    for (std::size_t i = 0; i <= pick(3); ++i) n.keys.push_back({static_cast<double>(i * 10) - 4.5, value(p)});
    return n;
  }
  std::uint64_t seed_, count_ = 0;
};

TEST(Expression, TreesReadBackFromTextAndJson) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Expression e = Grower(seed).tree(static_cast<int>(seed % 7));
    const std::string text = to_text(e), json = to_json(e);
    EXPECT_EQ(parse_expression(text), e) << text;
    EXPECT_EQ(parse_json_expression(json, "a.json"), e) << json;
  }
}

TEST(Expression, InfixFromTheLeftPostfixFirst) {
  EXPECT_EQ(parse_expression("a.exr over b.exr in c.exr"), parse_expression("(a.exr over b.exr) in c.exr"));
  EXPECT_NE(parse_expression("a.exr over b.exr in c.exr"), parse_expression("a.exr over (b.exr in c.exr)"));
  EXPECT_EQ(parse_expression("a.exr over b.exr opaque 0.7"), parse_expression("a.exr over (b.exr opaque 0.7)"));
  EXPECT_EQ(to_text(parse_expression("((a.exr) mask (m.png)) over (b.exr plus c.exr)")),
            "a.exr mask m.png over (b.exr plus c.exr)");
  EXPECT_EQ(to_text(parse_expression("colour( .1,.2 , .3)blur 2")), "colour(0.1, 0.2, 0.3) blur 2");
  EXPECT_EQ(parse_expression("a.exr key-colour 0 1 0 spill=0.5 inner=0.2").numbers,
            parse_expression("a.exr key-colour 0 1 0 inner=0.2 spill=0.5").numbers);
}

TEST(Expression, NumbersMove) {
  const Expression e = parse_expression("a.exr dissolve [1:0, 5:1 9:0.5]");
  const Number& n = e.numbers[0];
  EXPECT_EQ(n.at(-3), 0);
  EXPECT_EQ(n.at(1), 0);
  EXPECT_EQ(n.at(3), 0.5);
  EXPECT_EQ(n.at(5), 1);
  EXPECT_EQ(n.at(8), 0.625);
  EXPECT_EQ(n.at(100), 0.5);
}

TEST(Expression, ErrorsNamePlaceWordAndWhatWasExpected) {
  EXPECT_EQ(error_of("a.exr over"),
            "expression:1:11: expected a file, '(' or a generator (colour, disk …), found the end");
  EXPECT_NE(error_of("a.exr ovre b.exr")
                .find("expression:1:7: expected an operator or the end, found 'ovre'; did you mean 'over'?"),
            std::string::npos);
  EXPECT_EQ(error_of("a.exr over\n  b.exr dissolve 1.5"), "expression:2:18: expected amount from 0 to 1, found 1.5");
  EXPECT_EQ(error_of("(a.exr"), "expression:1:7: expected an operator or ')', found the end");
  EXPECT_EQ(error_of("a.exr dissolve [2:0 2:1]"), "expression:1:16: expected a frame after 2, found 2");
  EXPECT_EQ(error_of("a.exr luminance low=0 low=1"), "expression:1:23: 'low' is given twice");
  EXPECT_NE(error_of("a.exr luminance hi=1").find("1:17: luminance has no option 'hi'"), std::string::npos);
  EXPECT_NE(error_of("disk(1, 2)").find("1:10: expected a further number"), std::string::npos);
  EXPECT_NE(error_of("colour(1,1,1,a=0.5,0.2)").find("expected ')'"), std::string::npos);
  EXPECT_NE(error_of("polygon(0,0,1,0,1,1,2)").find("further number"), std::string::npos);
  EXPECT_NE(error_of("plate").find("needs quotes"), std::string::npos);
  EXPECT_EQ(error_of("\"a.exr"), "expression:1:1: no closing \"");
  for (const char* bad :
       {"", "()", "a.exr b.exr", "a.exr blur", "a.exr blur nan", "a.exr dissolve []", "a.exr dissolve [1:]",
        "a.exr layer", "disk", "disk()", "1", "=", "a.exr key-colour 0 1", "\"\"", "a.exr crop 1 2 3 -4"})
    EXPECT_NE(error_of(bad), "no error") << bad;
}

TEST(Expression, HostileTreesEnd) {
  EXPECT_NE(error_of(std::string(100000, '(')).find("more than 256 parentheses"), std::string::npos);
  std::string chain = "a.exr";
  for (int i = 0; i < 1999; ++i) chain += " over a.exr";
  EXPECT_EQ(parse_expression(to_text(parse_expression(chain))), parse_expression(chain));
  EXPECT_EQ(parse_json_expression(to_json(parse_expression(chain)), "a.json"), parse_expression(chain))
      << "as one array";
  chain += " over a.exr";
  EXPECT_NE(error_of(chain).find("deeper than 2000"), std::string::npos);
  std::string blurred = "a.exr";
  for (int i = 0; i < 3000; ++i) blurred += " clamp";
  EXPECT_NE(error_of(blurred).find("deeper than 2000"), std::string::npos);
}

TEST(Expression, JsonErrorsNameThePlace) {
  const auto error = [](const char* text) -> std::string {
    try {
      parse_json_expression(text, "a.json");
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(error("{\"word\": \"blur\", \"numbers\": [3]}"), "a.json:1:1: blur: expected \"inputs\", an array of 1");
  EXPECT_EQ(error("{\"word\": \"over\", \"inputs\": [\"a\"]}"),
            "a.json:1:28: over: expected \"inputs\", an array of 2 or more");
  EXPECT_NE(error("{\"word\": \"ovre\"}").find("a.json:1:10: unknown word 'ovre'; did you mean 'over'?"),
            std::string::npos);
  EXPECT_NE(
      error("{\"word\": \"blur\", \"numbers\": {\"size\": 3}, \"inputs\": [\"a\"]}").find("unknown member 'size'"),
      std::string::npos);
  for (const char* bad :
       {"", "1", "[]", "{}", "{\"file\": 1}", "{\"file\": \"\"}", "{\"file\": \"a\", \"word\": \"over\"}",
        "{\"word\": \"disk\", \"numbers\": [1, 2]}", "{\"word\": \"disk\", \"numbers\": [1, 2, \"3\"]}",
        "{\"word\": \"disk\", \"numbers\": [1, 2, []]}", "{\"word\": \"layer\", \"inputs\": [\"a\"]}",
        "{\"word\": \"clamp\", \"text\": \"a\", \"inputs\": [\"a\"]}"})
    EXPECT_NE(error(bad), "no error") << bad;
}

}  // namespace
}  // namespace lambert::composite
