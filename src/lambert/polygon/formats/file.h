#pragma once
/// Files of polygons: GeoJSON (.geojson, .json), WKT (.wkt) and vertex lists (.txt, .csv, .xy).

#include "lambert/polygon/formats/features.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace lambert::polygon {

enum class FileFormat : std::uint8_t { geojson, wkt, vertex_list };

/// "geojson", "wkt", "vertices".
std::vector<std::string> format_names();
/// Throws Error with the known names.
FileFormat format_named(const std::string& name);

/// By the extension, which is none of the known ones otherwise.
std::optional<FileFormat> format_of(const std::filesystem::path& path);
/// "{" or "[" begins GeoJSON, a letter that begins a geometry's name WKT, all else is a vertex list.
FileFormat format_of_content(std::string_view text);

/// Reads by extension, or else, and where that is .txt, .csv or .xy, by content. All coordinates are finite. Throws
/// Error with file, line, column, feature, ring and vertex, with the word at fault and what was expected.
Features read_features(const std::filesystem::path& path);
Features parse_features(std::string_view text, const std::string& name, FileFormat format);

std::string features_text(const Features& features, FileFormat format);
/// Writes by extension, whole or not at all. Throws Error naming the path.
void write_features(const std::filesystem::path& path, const Features& features);
/// The format of a file to be written. Throws Error with the known extensions, and `others` that the caller knows.
FileFormat output_format(const std::filesystem::path& path, const std::vector<std::string>& others = {});

}  // namespace lambert::polygon
