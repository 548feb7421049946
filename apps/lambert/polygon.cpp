#include "command.h"
#include "polygon/verb.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace lambert::cli {

std::function<int()> add_polygon(CLI::App& app) {
  struct Verb {
    const char *name, *summary;
    std::function<int()> (*add)(CLI::App&);
  };
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
  app.require_subcommand(1);
  struct Entry {
    CLI::App* app;
    std::function<int()> run;
  };
  const auto entries = std::make_shared<std::vector<Entry>>();
  for (const Verb& verb : verbs) {
    CLI::App* sub = app.add_subcommand(verb.name, verb.summary);
    entries->push_back({sub, verb.add(*sub)});
  }
  app.footer(
      "'lambert polygon VERB --help' explains a verb. Files are GeoJSON, WKT or plain vertices. Try:\n"
      "  lambert polygon classify a.wkt\n"
      "  lambert polygon union a.geojson b.geojson -o ab.geojson --svg ab.svg\n"
      "  echo '0 0 4 0 4 3' | xargs -n2 | lambert polygon area");
  return [entries] {
    for (const Entry& entry : *entries)
      if (entry.app->parsed()) return entry.run();
    return usage_error;
  };
}

}  // namespace lambert::cli
