#pragma once
#include "lambert/polygon/formats/features.h"

#include <string>
#include <string_view>

namespace lambert::polygon {

/// Reads GeoJSON (RFC 7946): a geometry, a Feature or a FeatureCollection, or, beyond the RFC, a bare array of
/// coordinates, which is a ring, a polygon or several by its nesting. Further members are kept as text; those of
/// geometries are dropped, and so are coordinates beyond the third. Linear time and memory. Throws Error with line,
/// column, feature, ring and vertex.
Features parse_geojson(std::string_view text, const std::string& name);

/// A FeatureCollection, one feature a line. Numbers are the shortest that read back as the same doubles. An SRID is not
/// written.
std::string geojson_text(const Features& features);

}  // namespace lambert::polygon
