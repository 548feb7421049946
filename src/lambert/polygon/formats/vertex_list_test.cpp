#include "lambert/polygon/formats/vertex_list.h"

#include "damage.h"

namespace lambert::polygon {
namespace {

Feature parse(const std::string& text) { return parse_vertex_list(text, "f.txt").features.at(0); }
std::string error_in(const std::string& text) {
  return error_of([&] { parse(text); });
}

TEST(VertexList, AllSpellingsOfAVertex) {
  const Feature f = parse("# a comment\n1 2\n 3,4\r\n5 , 6 # behind\n\t7\t8");
  EXPECT_EQ(rings_of(f), (Rings{{{1, 2}, {3, 4}, {5, 6}, {7, 8}}}));
  EXPECT_TRUE(f.polygons[0][0].closed);
  EXPECT_EQ(parse("1 2 3\n4,5,6\n").polygons[0][0].heights, (std::vector<double>{3, 6}));
}

TEST(VertexList, BlankLinesBeginPolygonsAndWordsOtherPaths) {
  const Feature f = parse(
      "0 0\n9 0\n0 9\n0 0\n\nhole\n1 1\n1 2\n2 1\n# no blank line\n\n\n20 0\n30 0\n20 9\nline\n1 1\n2 2\npoints\n5 "
      "5\n");
  ASSERT_EQ(f.polygons.size(), 2u);
  EXPECT_EQ(f.polygons[0].size(), 2u);
  EXPECT_EQ(f.polygons[0][0].points.size(), 3u) << "the repeated vertex is dropped";
  EXPECT_EQ(f.polygons[0][1].points.size(), 3u);
  EXPECT_EQ(f.polygons[1].size(), 1u);
  EXPECT_EQ(f.lines.size(), 1u);
  EXPECT_EQ(f.points.points, (Ring{{5, 5}}));
}

TEST(VertexList, NothingIsAFeatureWithoutGeometry) {
  EXPECT_TRUE(parse("").polygons.empty());
  EXPECT_TRUE(parse("\n\n# nothing\nhole\n").polygons.empty());
  EXPECT_EQ(parse("hole\n1 1\n").polygons.size(), 1u);
}

TEST(VertexList, ErrorsNamePlaceAndWord) {
  EXPECT_EQ(error_in("0 0\n1 0\nhole\n1 1\n1 x\n"),
            "f.txt:5:3: polygon 0, ring 1, vertex 1: expected a second number, found 'x'");
  EXPECT_EQ(error_in("0 0\n\n1"),
            "f.txt:3:2: polygon 1, ring 0, vertex 0: expected a second number, found the line's end");
  EXPECT_EQ(error_in("inf 0"),
            "f.txt:1:1: polygon 0, ring 0, vertex 0: expected a number (or 'hole', 'line', 'points'), found 'inf'");
  EXPECT_EQ(error_in("1 2 3 4"), "f.txt:1:7: polygon 0, ring 0, vertex 0: expected the line's end, found '4'");
  EXPECT_EQ(error_in("line\n1 2\n3 1e999"), "f.txt:3:3: line 0, vertex 1: expected a second number, found '1e999'");
  EXPECT_NE(error_in("1;2").find("found '1;2'"), std::string::npos);
}

TEST(VertexList, WhatIsWrittenReadsTheSame) {
  const std::string text =
      "0.1 0\n9 0\n0 9\nhole\n1 1\n1 2\n2 1\n\n20 0 1\n30 0 1\n20 1e-300 1\nline\n1 1\n2 2\npoints\n5 5\n";
  EXPECT_EQ(vertex_list_text(parse_vertex_list(text, "f.txt")), text);
}

TEST(VertexList, ARingMayVisitItsFirstVertexTwice) {
  const Features features = parse_vertex_list("0 0\n1 0\n0 0\n0 0\n", "f.txt");
  EXPECT_EQ(rings_of(features), (Rings{{{0, 0}, {1, 0}, {0, 0}}}));
  EXPECT_EQ(parse_vertex_list(vertex_list_text(features), "f.txt"), features);
}

TEST(VertexList, SurvivesDamage) {
  expect_survives_damage("# c\n0 0\n9 0\n0 9\nhole\n1 1\n1 2\n2 1\n\n20,0,1\n30,0,1\nline\n1 1\n2 2\npoints\n5 5\n",
                         20'000, [](const std::string& damaged) { parse(damaged); });
}

}  // namespace
}  // namespace lambert::polygon
