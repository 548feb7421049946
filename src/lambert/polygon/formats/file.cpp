#include "lambert/polygon/formats/file.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/standard_streams.h"
#include "lambert/polygon/formats/geojson.h"
#include "lambert/polygon/formats/vertex_list.h"
#include "lambert/polygon/formats/wkt.h"

#include <algorithm>
#include <array>

namespace lambert::polygon {
namespace {

struct Extension {
  const char* name;
  FileFormat format;
};
constexpr std::array extensions = {
    Extension{".geojson", FileFormat::geojson}, Extension{".json", FileFormat::geojson},
    Extension{".wkt", FileFormat::wkt},         Extension{".txt", FileFormat::vertex_list},
    Extension{".csv", FileFormat::vertex_list}, Extension{".xy", FileFormat::vertex_list}};

}  // namespace

std::vector<std::string> format_names() { return {"geojson", "wkt", "vertices"}; }

FileFormat format_named(const std::string& name) {
  const std::vector<std::string> names = format_names();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw Error("unknown format " + unknown_word(name, names));
  return static_cast<FileFormat>(found - names.begin());
}

std::optional<FileFormat> format_of(const std::filesystem::path& path) {
  const std::string extension = format_extension(path);
  for (const Extension& e : extensions)
    if (extension == e.name) return e.format;
  return std::nullopt;
}

FileFormat format_of_content(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != text.npos && (text[first] == '{' || text[first] == '[')) return FileFormat::geojson;
  return looks_like_wkt(text) ? FileFormat::wkt : FileFormat::vertex_list;
}

Features parse_features(std::string_view text, const std::string& name, FileFormat format) {
  switch (format) {
    case FileFormat::geojson: return parse_geojson(text, name);
    case FileFormat::wkt: return parse_wkt(text, name);
    case FileFormat::vertex_list: break;
  }
  return parse_vertex_list(text, name);
}

Features read_features(const std::filesystem::path& path) {
  const MappedFile file(path);
  const std::optional<FileFormat> named = format_of(path);
  const bool decided = named && *named != FileFormat::vertex_list;
  return parse_features(file.text(), path.string(), decided ? *named : format_of_content(file.text()));
}

std::string features_text(const Features& features, FileFormat format) {
  switch (format) {
    case FileFormat::geojson: return geojson_text(features);
    case FileFormat::wkt: return wkt_text(features);
    case FileFormat::vertex_list: break;
  }
  return vertex_list_text(features);
}

FileFormat output_format(const std::filesystem::path& path, const std::vector<std::string>& others) {
  if (const auto format = format_of(path)) return *format;
  std::vector<std::string> known;
  for (const Extension& e : extensions) known.emplace_back(e.name);
  known.insert(known.end(), others.begin(), others.end());
  throw Error(path.string() + ": unknown extension " + unknown_word(format_extension(path), known));
}

void write_features(const std::filesystem::path& path, const Features& features) {
  write_atomically(path, features_text(features, output_format(path)));
}

}  // namespace lambert::polygon
