#pragma once
/// What a file of polygons holds, whatever its format.

#include "lambert/polygon/ring.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lambert::polygon {

/// A chain of vertices. As a ring it follows the rule of Ring: the first vertex is not repeated at the end.
struct Path {
  Ring points;
  std::vector<double> heights;  ///< third coordinates: one a vertex, or none
  bool closed = true;           ///< of rings: false when the file should have repeated the first vertex and did not
  bool operator==(const Path&) const = default;
};

/// The rings of one polygon: as files mean it the outer one first, then its holes. Nothing of this is checked.
using PathPolygon = std::vector<Path>;

/// A member of a JSON object that no reader looks into: its name, and its value as JSON text.
struct JsonMember {
  std::string key, json;
  bool operator==(const JsonMember&) const = default;
};

/// All geometry that belongs to one thing. Nested collections are flattened into it.
struct Feature {
  std::string name;                 ///< the word under "name" in the properties, if any
  std::vector<JsonMember> members;  ///< "id", "properties" and others, unchanged
  Path points;
  std::vector<Path> lines;
  std::vector<PathPolygon> polygons;
  bool operator==(const Feature&) const = default;
};

/// The content of a file.
struct Features {
  std::vector<Feature> features;
  std::vector<JsonMember> members;   ///< of the collection
  std::optional<std::int64_t> srid;  ///< the reference system that WKT names
  bool operator==(const Features&) const = default;
};

/// The rings of all polygons.
Rings rings_of(const Feature& feature);
Rings rings_of(const Features& features);

/// Every vertex of points, lines and rings, in this order a feature.
std::vector<Vec2d> vertices_of(const Features& features);

/// One polygon a region or ring.
std::vector<PathPolygon> polygons_of(const Regions& regions);
std::vector<PathPolygon> polygons_of(const Rings& rings);

/// "feature 3 'Fiji'", for messages.
std::string describe(const Feature& feature, std::size_t index);

}  // namespace lambert::polygon
