#include "command.h"
#include "polygon/verb.h"
#include "verb_table.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

std::function<int()> add_polygon(CLI::App& app) {
  static constexpr Verb verbs[] = {
      {"check", "Are rings closed, without repeated vertices?", add_check},
      {"classify", "Are rings simple, convex, which way round? With a witness", add_classify},
      {"normal", "The normals of polygons in space", add_normal},
      {"area", "Area, perimeter and box", add_area},
      {"contains", "Which polygons contain a point", add_contains},
      {"pick", "Which edge a pointer picks", add_pick},
      {"clip", "Clip to windows and half-planes, or a line to polygons", add_clip},
      {"union", "What lies in any of several files", add_union},
      {"intersect", "What lies in all of them", add_intersect},
      {"difference", "What lies in the first and in no other", add_difference},
      {"xor", "What lies in an odd number of them", add_xor},
      {"trapezoids", "Cut into trapezoids", add_trapezoids},
      {"convex", "Cut into convex pieces", add_convex},
      {"triangulate", "Cut into triangles", add_triangulate},
      {"strips", "Cut into triangles and cover these with strips", add_strips},
      {"fill", "The pixels of polygons", add_fill},
      {"extrude", "Make a prism", add_extrude},
      {"revolve", "Turn a profile about an axis", add_revolve},
      {"convert", "Write in another format, or draw", add_convert},
  };
  const auto run = add_verbs(app, verbs);
  app.footer(
      "'lambert polygon VERB --help' explains a verb. Files are GeoJSON, WKT or plain vertices. Try:\n"
      "  lambert polygon classify a.wkt\n"
      "  lambert polygon union a.geojson b.geojson -o ab.geojson --svg ab.svg\n"
      "  echo '0 0 4 0 4 3' | xargs -n2 | lambert polygon area");
  return run;
}

}  // namespace lambert::cli
