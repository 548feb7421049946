#include "filter_options.h"
#include "verb.h"

#include "../command.h"

#include "lambert/base/error.h"
#include "lambert/image/filter/blur.h"
#include "lambert/image/io.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace lambert::cli {
namespace {

struct Options : FilterOptions {
  std::string filter = "gaussian", sigma, radius;
};

Vec2i whole(const std::string& text, float most) {
  const Vec2 v = parse_per_axis("--radius", text, 0, most);
  if (v != glm::floor(v)) throw Error("--radius: expected whole pixels, got '" + text + "'");
  return Vec2i(v);
}

Image blurred(const Options& o, const Image& image) {
  const EdgeMode edge = edge_mode(o.edge);
  if (o.filter == "gaussian") {
    if (o.sigma.empty() || !o.radius.empty()) throw Error("a gaussian blur has a --sigma, and no --radius");
    return gaussian_blurred(image, parse_per_axis("--sigma", o.sigma, 0, 65536), edge);
  }
  if (o.radius.empty() || !o.sigma.empty()) throw Error("a " + o.filter + " blur has a --radius, and no --sigma");
  return o.filter == "box" ? box_blurred(image, whole(o.radius, 65536), edge)
                           : bartlett_blurred(image, whole(o.radius, 4096), edge);
}

int run(const Options& o) {
  const std::vector<std::string> names = {"gaussian", "box", "bartlett"};
  if (std::find(names.begin(), names.end(), o.filter) == names.end())
    throw Error("--filter: unknown blur " + unknown_word(o.filter, names));
  const FractionSink progress = start_work(o.work);
  write_outputs(o, blurred(o, read_input(o, progress)), progress);
  return done;
}

}  // namespace

std::function<int()> add_blur(CLI::App& app) {
  static Options o;
  add_image_paths(app, o);
  app.add_option("--filter", o.filter, "gaussian, box or bartlett")->capture_default_str();
  app.add_option("--sigma", o.sigma, "Standard deviation of the gaussian in pixels: S, or SxS along each axis");
  app.add_option("--radius", o.radius, "Pixels of a box or triangle on each side: R or RxR");
  add_edge_option(app, o);
  return [] { return run(o); };
}

}  // namespace lambert::cli
