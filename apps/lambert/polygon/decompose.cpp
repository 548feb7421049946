#include "places.h"

#include "../command.h"
#include "../number_range.h"

#include "lambert/base/error.h"
#include "lambert/polygon/boolean/boolean.h"
#include "lambert/polygon/decompose/convex_pieces.h"
#include "lambert/polygon/decompose/trapezoids.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

struct Options : PolygonOptions {
  std::string method, tie_break = "symbolic";
  std::uint64_t seed = 1;
};

/// Cuts the regions of every feature into pieces, which stay in their feature, and writes them.
template <class F>
int run_pieces(const Options& o, const std::string& title, F&& pieces_of) {
  const std::vector<PolygonInput> inputs = read_inputs(o, {.validity = true});
  const FillRule rule = fill_rule(o);
  Picture picture{.title = title};
  std::vector<Rings> shown;
  const Features result = cut_from(joined(inputs), [&](const Feature& source, Feature& feature) {
    const Regions regions = normalised(rings_of(source), rule);
    for (const Region& region : regions) {
      const Rings pieces = pieces_of(region);
      for (const Ring& piece : pieces) shown.push_back({piece});
      for (PathPolygon& polygon : polygons_of(pieces)) feature.polygons.push_back(std::move(polygon));
    }
    for (const Ring& ring : rings_of(regions))
      picture.lines.push_back({.points = ring, .colour = ink, .closed = true, .width = 1.8});
  });
  show_pieces(picture, shown);
  picture.title += ": " + counted(shown.size(), "piece");
  write_geometry(o, inputs.front().format, result, picture);
  return done;
}

TieBreak tie_break(const Options& o) {
  if (o.tie_break == "symbolic") return TieBreak::symbolic;
  if (o.tie_break == "rotation") return TieBreak::random_rotation;
  throw Error("--tie-break: unknown way " + unknown_word(o.tie_break, {"symbolic", "rotation"}));
}

ConvexMethod convex_method(const Options& o) {
  if (o.method == "joined") return ConvexMethod::joined_triangles;
  if (o.method == "trapezoids") return ConvexMethod::trapezoids;
  throw Error("--method: unknown method " + unknown_word(o.method, {"joined", "trapezoids"}));
}

Rings trapezoid_rings(const Region& region, const TrapezoidOptions& options) {
  Rings rings;
  for (const Trapezoid& t : trapezoids(region, options).pieces)
    rings.emplace_back(t.corners.begin(), t.corners.begin() + static_cast<std::ptrdiff_t>(t.size));
  return rings;
}

}  // namespace

std::function<int()> add_trapezoids(CLI::App& app) {
  static Options options;
  add_input_options(app, options);
  app.add_option("--tie-break", options.tie_break,
                 "For vertices of equal height: symbolic, or rotation by a random angle")
      ->capture_default_str();
  add_seed(app, options.seed, "Of the random angle");
  add_geometry_outputs(app, options);
  app.footer("Horizontal cuts at the height of every vertex.");
  return [] {
    const TrapezoidOptions settings{.tie_break = tie_break(options), .seed = options.seed};
    return run_pieces(options, "trapezoids", [&](const Region& region) { return trapezoid_rings(region, settings); });
  };
}

std::function<int()> add_convex(CLI::App& app) {
  static Options options;
  options.method = "joined";
  add_input_options(app, options);
  app.add_option("--method", options.method, "joined: triangles joined while convex; or trapezoids")
      ->capture_default_str();
  add_geometry_outputs(app, options);
  app.footer("Convex pieces that tile each polygon; not the fewest possible.");
  return [] {
    const ConvexMethod method = convex_method(options);
    return run_pieces(options, "convex", [&](const Region& region) { return convex_pieces(region, method); });
  };
}

}  // namespace lambert::cli
