#include "lambert/formats/pbrt/parameters.h"

#include "lambert/formats/format_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::pbrt {
namespace {

ParameterList parse(const std::string& text) {
  Tokenizer tokens(text, "a.pbrt");
  ParameterList list("Thing \"x\"", tokens.place(tokens.peek()));
  parse_parameters(tokens, ColourSpace(), list);
  return list;
}

TEST(PbrtParameters, AllTypes) {
  const ParameterList p = parse(
      "\"integer i\" 3 \"float f\" [ 1.5 ] \"point2 p2\" [ 1 2 ] \"vector2 v2\" [ 1 2 ] \"point3 p\" [ 1 2 3 4 5 6 ]\n"
      "\"vector3 v\" [ 1 2 3 ] \"normal n\" [ 0 0 1 ] \"point old\" [ 1 2 3 ] \"rgb c\" [ .1 .2 .3 ]\n"
      "\"blackbody b\" 5000 \"spectrum s\" \"metal-Au-eta\" \"spectrum t\" [ 400 1 700 2 ] \"bool yes\" true\n"
      "\"bool no\" [ \"false\" ] \"string words\" [ \"a\" \"b\" ] \"texture t2\" \"wood\"");
  EXPECT_EQ(p.integer("i", 0), 3);
  EXPECT_EQ(p.number("f", 0), 1.5f);
  EXPECT_EQ(p.vectors2("p2", ParameterType::point2), std::vector<Vec2>{Vec2(1, 2)});
  EXPECT_EQ(p.vectors3("p", ParameterType::point3), (std::vector<Vec3>{Vec3(1, 2, 3), Vec3(4, 5, 6)}));
  EXPECT_EQ(p.point("old", Vec3(0)), Vec3(1, 2, 3));
  EXPECT_TRUE(p.boolean("yes", false));
  EXPECT_FALSE(p.boolean("no", true));
  EXPECT_EQ(p.strings("words"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(p.find("s", {ParameterType::spectrum})->strings[0], "metal-Au-eta");
  EXPECT_EQ(p.find("t", {ParameterType::spectrum})->floats.size(), 4u);
  EXPECT_EQ(p.number("absent", 7), 7);
}

TEST(PbrtParameters, UnusedOnesAreNoted) {
  const ParameterList p = parse("\"float used\" 1\n  \"float forgotten\" 2");
  p.number("used", 0);
  Notes notes;
  p.note_unused(notes);
  ASSERT_EQ(notes.counts().size(), 1u);
  EXPECT_EQ(notes.counts().begin()->first, "a.pbrt:2:3: unused parameter 'forgotten' of Thing \"x\"");
}

TEST(PbrtParameters, InheritedOnesGiveWayAndNeedNoUse) {
  ParameterList list = parse("\"float own\" 1");
  Parameter a, b;
  a.name = "own", a.floats = {5}, a.inherited = true;
  b.name = "other", b.floats = {6}, b.inherited = true;
  list.inherit({a, b});
  EXPECT_EQ(list.number("own", 0), 1);
  Notes notes;
  list.note_unused(notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(list.number("other", 0), 6);
}

TEST(PbrtParameters, WrongTypesAndCounts) {
  const auto fails = [](const std::string& text, const auto& use) { return error_of([&] { use(parse(text)); }); };
  EXPECT_EQ(fails(" \"string radius\" \"big\"", [](const auto& p) { p.number("radius", 1); }),
            "a.pbrt:1:2: parameter 'radius' of Thing \"x\" has the type 'string', expected 'float'");
  EXPECT_EQ(fails("\"float r\" [ 1 2 ]", [](const auto& p) { p.number("r", 1); }),
            "a.pbrt:1:1: parameter 'r' of Thing \"x\" takes 1 value, found 2");
  EXPECT_EQ(fails("\"point3 p\" [ 1 2 3 4 5 6 ]", [](const auto& p) { p.point("p", Vec3(0)); }),
            "a.pbrt:1:1: parameter 'p' of Thing \"x\" takes 3 numbers, found 6");
}

TEST(PbrtParameters, Syntax) {
  EXPECT_EQ(error_of([] { parse("\"point3 p\" [ 1 2 ]"); }),
            "a.pbrt:1:1: parameter 'p' of type 'point3' takes 3 numbers per value, found 2");
  EXPECT_EQ(error_of([] { parse("\"float r\" [ ]"); }), "a.pbrt:1:1: parameter 'r' has no values");
  EXPECT_EQ(error_of([] { parse("\"float r\" [ 1 2"); }),
            "a.pbrt:1:1: the values of parameter 'r' have no closing ']'");
  EXPECT_EQ(error_of([] { parse("\"float r\" [ \"a\" ]"); }),
            "a.pbrt:1:13: expected a number for parameter 'r' of type 'float', found \"a\"");
  EXPECT_EQ(error_of([] { parse("\"float r\" 1 \"float r\" 2"); }), "a.pbrt:1:13: parameter 'r' is given twice");
  EXPECT_EQ(error_of([] { parse("\"radius\" 1"); }),
            "a.pbrt:1:1: expected a parameter as \"type name\", found \"radius\"");
  EXPECT_EQ(error_of([] { parse("\"bool b\" maybe"); }), "a.pbrt:1:10: expected true or false, found 'maybe'");
  EXPECT_NE(error_of([] { parse("\"flaot r\" 1"); }).find("a.pbrt:1:1: unknown parameter type 'flaot'; did you mean"),
            std::string::npos);
}

TEST(PbrtParameters, OldColoursAreExplained) {
  const std::string message = error_of([] { parse("\"color Kd\" [ 1 1 1 ]"); });
  EXPECT_NE(message.find("pbrt-v2 or v3: pbrt-v4 calls it 'rgb'"), std::string::npos) << message;
}

}  // namespace
}  // namespace lambert::pbrt
