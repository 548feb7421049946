#include "lambert/polygon/formats/file.h"

#include "lambert/polygon/formats/path_builder.h"

#include "damage.h"
#include "temporary_folder.h"

#include <bit>
#include <cmath>

namespace lambert::polygon {
namespace {

/// Some feature of every kind of geometry, with coordinates of all sizes.
Features made_up(std::mt19937_64& random, bool heights) {
  const auto number = [&] {
    for (;;) {
      const double value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  const auto path = [&](std::size_t size) {
    Path made;
    for (std::size_t i = 0; i < size; ++i) {
      made.points.push_back({number(), number()});
      if (heights) made.heights.push_back(number());
    }
    return made;
  };
  Feature feature;
  for (std::size_t i = random() % 3; i > 0; --i) feature.lines.push_back(path(2 + random() % 3));
  for (std::size_t i = 1 + random() % 3; i > 0; --i) {
    PathPolygon& polygon = feature.polygons.emplace_back();
    for (std::size_t k = 1 + random() % 3; k > 0; --k) polygon.push_back(path(3 + random() % 3));
  }
  feature.points = path(random() % 3);
  return {.features = {feature}, .members = {}, .srid = {}};
}

TEST(PolygonFile, EveryFormatKeepsEveryBitOfTheGeometry) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Features features = made_up(random, i % 2 == 0);
    for (const FileFormat format : {FileFormat::geojson, FileFormat::wkt, FileFormat::vertex_list}) {
      const std::string text = features_text(features, format);
      ASSERT_EQ(format_of_content(text), format) << text;
      const Features back = parse_features(text, "f", format);
      ASSERT_EQ(back.features.size(), 1u);
      ASSERT_EQ(back.features[0].polygons, features.features[0].polygons) << text;
      ASSERT_EQ(back.features[0].lines, features.features[0].lines) << text;
      ASSERT_EQ(back.features[0].points, features.features[0].points) << text;
    }
  }
}

TEST(PolygonFile, FormatFollowsExtensionOrContent) {
  const TemporaryFolder folder;
  const std::string wkt = "POLYGON ((0 0, 1 0, 0 1, 0 0))";
  for (const char* name : {"a.wkt", "a.txt", "a", "a.dat"})
    EXPECT_EQ(read_features(folder.write(name, wkt)).features[0].polygons.size(), 1u) << name;
  EXPECT_EQ(read_features(folder.write("b", " \n[[0,0],[1,0],[0,1]]")).features[0].polygons.size(), 1u);
  EXPECT_EQ(read_features(folder.write("c", "0 0\n1 0\n0 1\n")).features[0].polygons.size(), 1u);
  EXPECT_THROW(read_features(folder.write("d.geojson", wkt)), Error);
  EXPECT_NE(error_of([&] { read_features(folder.path() / "missing.wkt"); }).find("missing.wkt"), std::string::npos);
}

TEST(PolygonFile, WritingFollowsTheExtension) {
  const TemporaryFolder folder;
  const Features features = parse_features("POLYGON ((0 0, 1 0, 0 1, 0 0))", "f", FileFormat::wkt);
  for (const char* name : {"a.wkt", "a.txt", "a.geojson", "a.json", "a.csv", "a.xy"}) {
    write_features(folder.path() / name, features);
    EXPECT_EQ(rings_of(read_features(folder.path() / name)), rings_of(features)) << name;
  }
  EXPECT_NE(error_of([&] { write_features(folder.path() / "a.shp", features); }).find(".geojson"), std::string::npos);
  EXPECT_NE(error_of([] { format_named("geojsn"); }).find("did you mean 'geojson'"), std::string::npos);
}

TEST(PolygonFile, FeaturesNameThemselvesInMessages) {
  EXPECT_EQ(describe({.name = "Fiji"}, 3), "feature 3 'Fiji'");
  EXPECT_EQ(describe({}, 3), "feature 3");
}

}  // namespace
}  // namespace lambert::polygon
