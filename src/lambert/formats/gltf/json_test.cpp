#include "lambert/formats/gltf/json.h"

#include "lambert/formats/format_test_tools.h"

namespace lambert::gltf {
namespace {

const std::string file = "f.gltf";

std::string error_in(const std::string& text) {
  return error_of([&] { parse_json(text, file); });
}

TEST(GltfJson, ValuesOfAllKinds) {
  const Json json = parse_json(R"({"a": [1, -2.5, 3e2], "b": true, "s": "x\u00e9", "n": null, "o": {"k": 7}})", file);
  const JsonView root(json, file);
  EXPECT_EQ(root["a"].numbers(), (std::vector<float>{1, -2.5f, 300}));
  EXPECT_TRUE(root["b"].boolean(false));
  EXPECT_EQ(root["s"].text(), "x\xc3\xa9");
  EXPECT_EQ(root["o"]["k"].count(), 7u);
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"a", "b", "s", "n", "o"}));
  EXPECT_TRUE(root["n"].exists());
}

TEST(GltfJson, AbsentMembersTakeTheFallback) {
  const Json json = parse_json("{}", file);
  const JsonView nothing = JsonView(json, file)["x"]["y"][std::size_t{3}];
  EXPECT_FALSE(nothing);
  EXPECT_EQ(nothing.number(2), 2);
  EXPECT_EQ(nothing.text("d"), "d");
  EXPECT_EQ(nothing.size(), 0u);
  EXPECT_EQ(nothing.vec3({1, 2, 3}), glm::vec3(1, 2, 3));
  EXPECT_EQ(error_of([&] { nothing.number(); }), "f.gltf: /x/y/3: expected a number, found nothing");
}

TEST(GltfJson, ErrorsSayWhereAndWhatIsThere) {
  const Json json = parse_json(R"({"a/b~c": [0, "word"], "v": [1, 2], "big": 1e300, "half": 0.5, "minus": -1})", file);
  const JsonView root(json, file);
  EXPECT_EQ(error_of([&] { root["a/b~c"][1].number(); }), "f.gltf: /a~1b~0c/1: expected a number, found a string");
  EXPECT_EQ(error_of([&] { root["v"]["k"]; }), "f.gltf: /v: expected an object, found an array");
  EXPECT_EQ(error_of([&] { root["v"].vec3({}); }), "f.gltf: /v: expected 3 numbers, found 2");
  EXPECT_EQ(error_of([&] { root["big"].number(); }), "f.gltf: /big: this number is too large");
  for (const char* name : {"half", "minus", "big"})
    EXPECT_NE(error_of([&] { root[name].count(); }).find("whole number"), std::string::npos) << name;
  EXPECT_EQ(error_of([&] { root.fail("no"); }), "f.gltf: /: no");
}

TEST(GltfJson, MalformedTextIsNamedByLineAndColumn) {
  EXPECT_TRUE(error_in("{\"a\": 1,\n \"b\" 2}").starts_with("f.gltf:2:6"));
  EXPECT_TRUE(error_in("").starts_with("f.gltf:1:1"));
  EXPECT_TRUE(error_in("{} x").starts_with("f.gltf:1:4"));
  EXPECT_NE(error_in("[1e999]").find("this number is too large"), std::string::npos);
  EXPECT_NE(error_in("[nan]").find("malformed JSON"), std::string::npos);
  EXPECT_NE(error_in("[\"\xff\"]").find("malformed JSON"), std::string::npos);
}

TEST(GltfJson, NestingIsLimited) {
  EXPECT_NO_THROW(parse_json(std::string(256, '[') + std::string(256, ']'), file));
  EXPECT_NE(error_in(std::string(1'000'000, '[')).find("nested deeper than 256"), std::string::npos);
}

}  // namespace
}  // namespace lambert::gltf
