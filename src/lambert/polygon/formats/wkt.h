#pragma once
#include "lambert/polygon/formats/features.h"

#include <string>
#include <string_view>

namespace lambert::polygon {

/// Whether the text begins as WKT does: with a geometry's name or an SRID.
bool looks_like_wkt(std::string_view text);

/// Reads well-known text (OGC 06-103r4): any number of geometries one after another, each a feature; POINT, LINESTRING,
/// POLYGON, their MULTI forms and GEOMETRYCOLLECTION in any case, with EMPTY, Z and an SRID=…; prefix. Measures (M) are
/// refused. Collections nest at most 64 deep. Linear time and memory. Throws Error with line, column, feature, ring and
/// vertex.
Features parse_wkt(std::string_view text, const std::string& name);

/// One geometry a line. Numbers are the shortest that read back as the same doubles. Names and members of features are
/// not written; z is written where every path of a geometry has it.
std::string wkt_text(const Features& features);

}  // namespace lambert::polygon
