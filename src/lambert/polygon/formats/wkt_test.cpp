#include "lambert/polygon/formats/wkt.h"

#include "lambert/polygon/formats/format_test_tools.h"

namespace lambert::polygon {
namespace {

Features parse(const std::string& text) { return parse_wkt(text, "f.wkt"); }
std::string error_in(const std::string& text) {
  return error_of([&] { parse(text); });
}
Feature only(const std::string& text) { return test::only_feature(parse(text)); }

TEST(Wkt, EveryGeometry) {
  EXPECT_EQ(only("POINT (1 2)").points.points, (Ring{{1, 2}}));
  EXPECT_EQ(only("multipoint(1 2, 3 4)").points.points, (Ring{{1, 2}, {3, 4}}));
  EXPECT_EQ(only("MultiPoint ((1 2), EMPTY, (3 4))").points.points.size(), 2u);
  EXPECT_EQ(only("LINESTRING (1 2, 3 4)").lines.size(), 1u);
  EXPECT_EQ(only("MULTILINESTRING ((1 2, 3 4), (5 6, 7 8), EMPTY)").lines.size(), 3u);
  EXPECT_EQ(rings_of(only("POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))")),
            (Rings{{{0, 0}, {4, 0}, {0, 4}}, {{1, 1}, {1, 2}, {2, 1}}}));
  EXPECT_EQ(only("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), EMPTY, ((5 5, 6 5, 5 6, 5 5)))").polygons.size(), 2u);
  const Feature all =
      only("GEOMETRYCOLLECTION (POINT (1 2), GEOMETRYCOLLECTION (LINESTRING (1 2, 3 4)), POLYGON EMPTY)");
  EXPECT_EQ(all.points.points.size(), 1u);
  EXPECT_EQ(all.lines.size(), 1u);
  EXPECT_TRUE(all.polygons.empty());
}

TEST(Wkt, HeightsWithAndWithoutTheLetter) {
  for (const char* text : {"LINESTRING Z (1 2 3, 4 5 6)", "LINESTRINGZ(1 2 3,4 5 6)", "LINESTRING (1 2 3, 4 5 6)"})
    EXPECT_EQ(only(text).lines.at(0).heights, (std::vector<double>{3, 6})) << text;
  EXPECT_EQ(error_in("POINT Z (1 2)"), "f.wkt:1:13: feature 0, vertex 0: expected a third number after Z, found ')'");
  for (const char* text : {"POINT M (1 2 3)", "POINTZM (1 2 3 4)", "POINT ZM EMPTY"})
    EXPECT_NE(error_in(text).find("measures"), std::string::npos) << text;
}

TEST(Wkt, SeveralGeometriesAndTheirSrid) {
  const Features features = parse("SRID=4326;POINT (1 2)\nSRID=4326;POINT(3 4);\n\nPOLYGON EMPTY\n");
  EXPECT_EQ(features.srid, 4326);
  EXPECT_EQ(features.features.size(), 3u);
  EXPECT_EQ(wkt_text(features), "SRID=4326;POINT (1 2)\nSRID=4326;POINT (3 4)\nSRID=4326;GEOMETRYCOLLECTION EMPTY\n");
  EXPECT_NE(error_in("SRID=1;POINT (1 2) SRID=2;POINT (1 2)").find("same SRID"), std::string::npos);
}

TEST(Wkt, ErrorsNamePlaceAndWord) {
  EXPECT_EQ(error_in("POINT (1 2)\nPOLYGON ((0 0, 1 0, 0 1), (0 0, 1 x))"),
            "f.wkt:2:35: feature 1, ring 1, vertex 1: expected a second number, found 'x'");
  EXPECT_EQ(error_in("MULTIPOLYGON (EMPTY, ((0 0, 1 0, nan 1)))"),
            "f.wkt:1:34: feature 0, polygon 1, ring 0, vertex 2: expected a number, found 'nan'");
  EXPECT_EQ(error_in("POLYGON ((0 0, 1 0"),
            "f.wkt:1:19: feature 0, ring 0, vertex 1: expected ',' or ')', found the end");
  EXPECT_EQ(error_in("POLYGON 0 0"), "f.wkt:1:9: feature 0: expected '(' or EMPTY, found '0'");
  EXPECT_NE(error_in("POLIGON ((0 0))").find("did you mean 'POLYGON'?"), std::string::npos);
  EXPECT_EQ(error_in("POINT (1e999 0)"), "f.wkt:1:8: feature 0, vertex 0: expected a number, found '1e999'");
  EXPECT_EQ(error_in("POINT (1 2 3 4)"), "f.wkt:1:14: feature 0, vertex 0: expected ',' or ')', found '4'");
  EXPECT_NE(error_in("POINT (1 2) )").find("expected the name of a geometry"), std::string::npos);
}

TEST(Wkt, NestingIsLimited) {
  std::string collections;
  for (int i = 0; i < 100'000; ++i) collections += "GEOMETRYCOLLECTION (";
  EXPECT_NE(error_in(collections).find("nested deeper than 64"), std::string::npos);
}

TEST(Wkt, WhatIsWrittenReadsTheSame) {
  for (const std::string text :
       {"POINT (0.1 -2e-300)\n", "MULTIPOINT Z (1 2 3, 4 5 6)\n", "LINESTRING (1 2, 3 4)\n",
        "MULTILINESTRING ((1 2, 3 4), (5 6, 7 8))\n", "POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))\n",
        "MULTIPOLYGON Z (((0 0 1, 4 0 1, 0 4 1, 0 0 1)), ((5 5 1, 6 5 1, 5 6 1, 5 5 1), EMPTY))\n",
        "GEOMETRYCOLLECTION (POINT (1 2), LINESTRING (1 2, 3 4))\n", "GEOMETRYCOLLECTION EMPTY\n", "POLYGON (EMPTY)\n",
        "MULTILINESTRING (EMPTY, (1 2, 3 4))\n"})
    EXPECT_EQ(wkt_text(parse(text)), text);
}

TEST(Wkt, SurvivesDamage) {
  const std::string text =
      "SRID=4326;POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))\nMULTIPOINT ((1 2), (3 4))\n"
      "GEOMETRYCOLLECTION Z (POINT Z (1 2 3), MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), EMPTY), LINESTRING (1 2, 3 4))\n";
  expect_survives_damage(text, 20'000, [](const std::string& damaged) { parse(damaged); });
}

}  // namespace
}  // namespace lambert::polygon
