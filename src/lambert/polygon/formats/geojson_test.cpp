#include "lambert/polygon/formats/geojson.h"

#include "lambert/polygon/formats/format_test_tools.h"

#include <limits>

namespace lambert::polygon {
namespace {

Features parse(const std::string& text) { return parse_geojson(text, "f.geojson"); }
std::string error_in(const std::string& text) {
  return error_of([&] { parse(text); });
}
Feature only(const std::string& text) { return test::only_feature(parse(text)); }
std::string polygon(const std::string& coordinates) {
  return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
}

TEST(GeoJson, EveryGeometry) {
  EXPECT_EQ(only(R"({"type":"Point","coordinates":[1,2]})").points.points, (Ring{{1, 2}}));
  EXPECT_EQ(only(R"({"type":"MultiPoint","coordinates":[[1,2],[3,4]]})").points.points, (Ring{{1, 2}, {3, 4}}));
  const Feature line = only(R"({"coordinates":[[1,2],[3,4],[1,2]],"type":"LineString"})");
  ASSERT_EQ(line.lines.size(), 1u);
  EXPECT_EQ(line.lines[0].points, (Ring{{1, 2}, {3, 4}, {1, 2}})) << "a line keeps the repetition";
  EXPECT_EQ(only(R"({"type":"MultiLineString","coordinates":[[[1,2],[3,4]],[[5,6],[7,8]]]})").lines.size(), 2u);
  const Feature area = only(polygon("[[[0,0],[4,0],[0,4],[0,0]],[[1,1],[1,2],[2,1],[1,1]]]"));
  ASSERT_EQ(area.polygons.size(), 1u);
  EXPECT_EQ(rings_of(area), (Rings{{{0, 0}, {4, 0}, {0, 4}}, {{1, 1}, {1, 2}, {2, 1}}}));
  const Feature areas = only(R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1],[0,0]]],[[],[[1,1]]],[]]})");
  ASSERT_EQ(areas.polygons.size(), 2u);
  EXPECT_EQ(areas.polygons[0].size(), 1u);
  EXPECT_EQ(areas.polygons[1].size(), 2u);
  EXPECT_TRUE(areas.polygons[1][0].points.empty());
}

TEST(GeoJson, CollectionsAreFlattenedIntoTheirFeature) {
  const Feature all = only(R"({"type":"GeometryCollection","geometries":[
    {"type":"Point","coordinates":[1,2]},
    {"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[3,4]},
                                               {"type":"LineString","coordinates":[[5,6],[7,8]]}]}]})");
  EXPECT_EQ(all.points.points, (Ring{{1, 2}, {3, 4}}));
  EXPECT_EQ(all.lines.size(), 1u);
}

TEST(GeoJson, MembersAreKeptAsTheyAre) {
  const std::string properties = R"({"name": "A \"b\"", "deep": [1, {"name": "no"}], "n": 1e0})";
  const Features features =
      parse(R"({"type":"FeatureCollection","crs":{"a":[ 1 ]},"features":[
    {"type":"Feature","id":"x1","properties":)" +
            properties + R"(,"geometry":null,"extra":[1, 2]}, {"type":"Feature","geometry":null}]})");
  ASSERT_EQ(features.features.size(), 2u);
  const Feature& f = features.features[0];
  EXPECT_EQ(f.name, "A \"b\"");
  EXPECT_EQ(f.members, (std::vector<JsonMember>{{"id", "\"x1\""}, {"properties", properties}, {"extra", "[1, 2]"}}));
  EXPECT_EQ(features.members, (std::vector<JsonMember>{{"crs", R"({"a":[ 1 ]})"}}));
  EXPECT_EQ(parse(geojson_text(features)).features[0], f);
}

TEST(GeoJson, ThirdCoordinatesAreOptional) {
  EXPECT_EQ(only(polygon("[[[0,0,5],[1,0,6],[0,1,7],[0,0,5]]]")).polygons[0][0].heights,
            (std::vector<double>{5, 6, 7}));
  EXPECT_TRUE(only(polygon("[[[0,0,5],[1,0],[0,1,7],[0,0,5]]]")).polygons[0][0].heights.empty());
  EXPECT_EQ(only(polygon("[[[0,0,5,9],[1,0,6,9],[0,1,7,9],[0,0,5,9]]]")).polygons[0][0].heights.size(), 3u);
}

TEST(GeoJson, RingsThatAreNotClosedAreNoted) {
  EXPECT_FALSE(only(polygon("[[[0,0],[1,0],[0,1]]]")).polygons[0][0].closed);
  EXPECT_TRUE(only(polygon("[[[0,0],[1,0],[0,1],[0,0]]]")).polygons[0][0].closed);
  EXPECT_FALSE(only(polygon("[[[0,0,1],[1,0,1],[0,1,1],[0,0,2]]]")).polygons[0][0].closed);
}

TEST(GeoJson, BareCoordinatesAreARingOrAPolygonOrSeveral) {
  EXPECT_EQ(rings_of(only("[[0,0],[1,0],[0,1]]")).size(), 1u);
  EXPECT_EQ(only("[[[0,0],[4,0],[0,4]],[[1,1],[1,2],[2,1]]]").polygons.size(), 1u);
  EXPECT_EQ(only("[[[[0,0],[4,0],[0,4]]],[[[1,1],[1,2],[2,1]]]]").polygons.size(), 2u);
  EXPECT_EQ(only("[1,2]").points.points.size(), 1u);
  EXPECT_TRUE(only("[]").polygons.empty());
}

TEST(GeoJson, ErrorsNameLineColumnFeatureRingAndVertex) {
  EXPECT_EQ(error_in("{\"type\":\"FeatureCollection\",\"features\":[\n{\"type\":\"Feature\",\"geometry\":null},\n"
                     "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[0,1]],\n"
                     "  [[0,0],[1,null]]]}}]}"),
            "f.geojson:4:13: feature 1: ring 1, vertex 1: expected a number, found 'null'");
  EXPECT_EQ(error_in(R"({"type":"MultiPolygon","coordinates":[[],[[[0,0],[1,0],[2]]]]})"),
            "f.geojson:1:58: polygon 1, ring 0, vertex 2: expected two or three numbers, found 1");
  EXPECT_EQ(error_in(R"({"type":"Point","coordinates":["a",1]})"), "f.geojson:1:32: expected a number, found '\"a\"'");
  EXPECT_EQ(error_in(R"({"type":"Polygon","coordinates":[[0,0],[1,0]]})"),
            "f.geojson:1:35: expected numbers 3 brackets deep, found them 2 deep");
  EXPECT_EQ(error_in(R"({"type":"LineString","coordinates":[[0,0],[]]})"),
            "f.geojson:1:44: vertex 1: expected two or three numbers, found 0");
  EXPECT_EQ(error_in(R"({"type":"LineString","coordinates":[[0,0],3]})"),
            "f.geojson:1:43: vertex 1: expected an array such as [x, y], found a number");
  EXPECT_EQ(error_in(R"({"type":"LineString","coordinates":[[0,[1]]]})"),
            "f.geojson:1:40: vertex 0: expected a number, found an array");
}

TEST(GeoJson, ErrorsNameTheWordAndTheKnownOnes) {
  EXPECT_NE(error_in(R"({"type":"Poligon","coordinates":[]})").find("did you mean 'Polygon'?"), std::string::npos);
  EXPECT_EQ(error_in(R"({"coordinates":[]})"), "f.geojson:1:1: expected a 'type' in this object");
  EXPECT_EQ(error_in(R"({"type":"Polygon"})"), "f.geojson:1:1: expected 'coordinates' in this Polygon");
  EXPECT_EQ(error_in(R"({"type":"FeatureCollection","features":[7]})"),
            "f.geojson:1:41: feature 0: expected an object, found '7'");
  EXPECT_EQ(error_in(R"({"type":"FeatureCollection","features":{}})").find("f.geojson:1:40"), std::string::npos);
  EXPECT_EQ(error_in("7"), "f.geojson:1:1: expected a GeoJSON object, found '7'");
  EXPECT_EQ(error_in(R"({"type":5})"), "f.geojson:1:9: expected a word, found '5'");
  EXPECT_NE(error_in(R"({"type":"Point","coordinates":[1e999,0]})").find("too large"), std::string::npos);
  EXPECT_NE(error_in(R"({"type":"Point","coordinates":[NaN,0]})").find("malformed"), std::string::npos);
}

TEST(GeoJson, NestingIsLimited) {
  EXPECT_NE(error_in(R"({"type":"Polygon","coordinates":)" + std::string(1'000'000, '[')).find("nested too deep"),
            std::string::npos);
  std::string collections;
  for (int i = 0; i < 100'000; ++i) collections += R"({"type":"GeometryCollection","geometries":[)";
  EXPECT_NE(error_in(collections).find("nested deeper"), std::string::npos);
}

TEST(GeoJson, NumbersSurvive) {
  Features features;
  features.features.resize(1);
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  features.features[0].lines = {{.points = {{0.1, -1.0 / 3}, {tiny, huge}}, .heights = {1e-17, 1e300}}};
  EXPECT_EQ(parse(geojson_text(features)).features[0].lines, features.features[0].lines);
}

TEST(GeoJson, SurvivesDamage) {
  const std::string text = R"({"type":"FeatureCollection","name":"x","features":[
 {"type":"Feature","id":7,"properties":{"name":"a","b":[1,{}]},"geometry":{"type":"Polygon","coordinates":
  [[[0,0],[4,0,1],[0,4],[0,0]],[[1,1],[1,2],[2,1],[1,1]]]}},
 {"type":"Feature","properties":null,"geometry":{"type":"GeometryCollection","geometries":[
  {"type":"MultiPoint","coordinates":[[1,2],[3,4e1]]},{"type":"LineString","coordinates":[[1,2],[3,4]]}]}}]})";
  expect_survives_damage(text, 20'000, [](const std::string& damaged) { parse(damaged); });
}

}  // namespace
}  // namespace lambert::polygon
