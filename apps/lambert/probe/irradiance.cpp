#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/spherical_harmonics.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {

using namespace probe;

namespace {

struct Options {
  ProbeInputOptions input;
  std::vector<float> normal;
  std::string method = "quadrature";
  std::vector<std::string> outputs;
  int size = 64;
  bool json = false;
};

/// E / π by nine coefficients.
Probe by_harmonics(const Probe& probe, int rows) {
  std::vector<ShColour> e = sh_irradiance(sh_project(probe, 2));
  for (ShColour& c : e) c.r /= std::numbers::pi, c.g /= std::numbers::pi, c.b /= std::numbers::pi;
  return sh_map(e, probe.projection, probe.texels, rows);
}

int run(const Options& o) {
  if (o.outputs.empty() && o.normal.empty()) throw Error("nothing to do: give -o FILE or --normal X,Y,Z");
  if (o.method != "quadrature" && o.method != "sh")
    throw Error("--method: unknown method " + unknown_word(o.method, {"quadrature", "sh"}));
  const Vec3 n = o.normal.empty() ? Vec3(0) : direction_of("--normal", o.normal);
  check_probes(o.outputs);
  const FractionSink progress = start_work(o.input.work);
  const ProbeInput input = read_probe(o.input);
  if (!o.normal.empty()) {
    const Rgb e =
        o.method == "sh" ? sh_radiance(sh_irradiance(sh_project(input.probe, 2)), n) : Irradiance(input.probe)(n);
    if (o.json)
      fmt::print("{}\n", nlohmann::ordered_json{{"normal", json_of(n)}, {"irradiance", json_of(e)}}.dump(2));
    else
      fmt::print("irradiance {} {} {}\n", e.r, e.g, e.b);
  }
  if (o.outputs.empty()) return done;
  const Probe map = o.method == "sh" ? by_harmonics(input.probe, o.size)
                                     : diffuse_map(input.probe, o.size, part_of(progress, 0.1, 0.9));
  write_probe(o.outputs, map, input.arrangement);
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_probe_irradiance(CLI::App& app) {
  static Options options;
  add_probe_input(app, options.input);
  app.add_option("--method", options.method,
                 "quadrature: all of the map; sh: nine spherical harmonics (Ramamoorthi and Hanrahan 2001)")
      ->capture_default_str();
  app.add_option("--normal", options.normal, "Print the irradiance of a surface that faces X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  expect_number(app.add_option("--size", options.size, "Rows of the map or of a face")->capture_default_str(),
                {.expected = "a number of rows from 1 to 2048", .low = 1, .below = 2049});
  add_outputs(app, options.outputs, "Diffuse map in the layout of the input: irradiance over pi, all directions");
  app.add_flag("--json", options.json, "Print JSON");
  app.footer("Irradiance is in W/m2 for radiance in W/(m2 sr); a constant environment of 1 gives pi, its map is 1.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
