#include "../outputs.h"
#include "../print_path.h"
#include "verb.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/standard_streams.h"
#include "lambert/draw/pixels.h"
#include "lambert/draw/svg.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

bool is_picture(const std::string& path) {
  return format_extension(path) == ".svg" || format_extension(path) == ".png";
}

/// Pictures by all flags that name one; returns what else -o names.
std::vector<std::string> other_outputs(const PolygonOptions& o, std::vector<std::string>& pictures) {
  std::vector<std::string> others;
  for (const std::string& path : o.outputs) (is_picture(path) ? pictures : others).push_back(path);
  for (const std::string* path : {&o.svg, &o.png})
    if (!path->empty()) pictures.push_back(*path);
  return others;
}

void write_pictures(const std::vector<std::string>& paths, const Picture& picture, const std::string& svg) {
  if (paths.empty()) return;
  const Drawing drawing = drawn(picture);
  for (const std::string& path : paths) {
    if (format_extension(path) == ".svg" || path == svg) {
      write_atomically(path, svg_text(drawing));
    } else {
      Image image = to_image(rasterised(drawing));
      image.metadata["software"] = "lambert " LAMBERT_VERSION;
      write_image(path == "-" ? "png:-" : path, image);
    }
  }
}

/// Before the first of them is written.
void check_all_writable(const PolygonOptions& o) {
  check_texts(o.outputs);
  check_texts({o.svg, o.png});
}

void add_pictures(CLI::App& app, PolygonOptions& o) {
  add_output(app, "--svg", o.svg, "Draw what happened");
  add_output(app, "--png", o.png, "The same as pixels");
}

}  // namespace

void add_geometry_outputs(CLI::App& app, PolygonOptions& o) {
  add_outputs(app, o.outputs,
              "Write the result: .geojson .json .wkt .txt .csv .xy, or a picture: .svg .png; else it is printed");
  app.add_option("--to", o.format, "Format to print: geojson, wkt or vertices; that of the input by default");
  add_pictures(app, o);
}

void add_fact_outputs(CLI::App& app, PolygonOptions& o) {
  add_outputs(app, o.outputs, "Write the facts as .json, or a picture: .svg .png");
  app.add_flag("--json", o.json, "Print JSON");
  add_pictures(app, o);
}

void check_geometry_outputs(const PolygonOptions& o) {
  std::vector<std::string> pictures, others = o.meshes;
  others.insert(others.end(), {".svg", ".png"});
  for (const std::string& path : other_outputs(o, pictures))
    if (path != "-" && std::ranges::find(o.meshes, format_extension(path)) == o.meshes.end())
      output_format(path, others);
  check_all_writable(o);
}

void write_geometry(const PolygonOptions& o, FileFormat like, const Features& result, const Picture& picture) {
  std::vector<std::string> pictures;
  const std::vector<std::string> files = other_outputs(o, pictures);
  check_geometry_outputs(o);
  const auto text = [&] { return features_text(result, o.format.empty() ? like : format_named(o.format)); };
  for (const std::string& path : files)
    if (path == "-")
      write_atomically(path, text());
    else
      write_features(path, result);
  write_pictures(pictures, picture, o.svg);
  if (files.empty() && !o.mesh_written) {
    fmt::print("{}", text());
    return;
  }
  for (const std::string& path : files) print_path(path);
  for (const std::string& path : pictures) print_path(path);
}

void write_facts(const PolygonOptions& o, const nlohmann::ordered_json& facts, const std::string& text,
                 const Picture& picture) {
  std::vector<std::string> pictures;
  const std::vector<std::string> files = other_outputs(o, pictures);
  const auto dumped = [&] { return facts.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"; };
  for (const std::string& path : files)
    if (path != "-" && format_extension(path) != ".json")
      throw Error(path + ": unknown extension " + unknown_word(format_extension(path), {".json", ".svg", ".png"}));
  check_all_writable(o);
  for (const std::string& path : files) write_atomically(path, dumped());
  write_pictures(pictures, picture, o.svg);
  fmt::print("{}", o.json ? dumped() : text);
}

}  // namespace lambert::cli
