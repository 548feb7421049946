#pragma once
#include "lambert/polygon/formats/features.h"

#include <string>
#include <string_view>

namespace lambert::polygon {

/// Reads plain vertices, one a line: "x y", "x, y" or "x y z"; "#" starts a comment. A blank line begins the next
/// polygon, a line "hole" the next ring of the same polygon, "line" an open line and "points" single points. All is one
/// feature. A ring is closed whether or not its first vertex is repeated; a repetition is dropped. Linear time and
/// memory. Throws Error with line, column, polygon, ring and vertex.
Features parse_vertex_list(std::string_view text, const std::string& name);

/// Numbers are the shortest that read back as the same doubles; a feature's name becomes a comment. Members, an SRID
/// and where features end are not written, nor are paths without vertices.
std::string vertex_list_text(const Features& features);

}  // namespace lambert::polygon
