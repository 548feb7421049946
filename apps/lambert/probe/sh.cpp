#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"

#include "lambert/image/probe/spherical_harmonics.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {

using namespace probe;

namespace {

struct Options {
  ProbeInputOptions input;
  std::vector<std::string> outputs;
  int order = 2, size = 128;
  bool irradiance = false, json = false;
};

int run(const Options& o) {
  check_probes(o.outputs);
  const FractionSink progress = start_work(o.input.work);
  const ProbeInput input = read_probe(o.input);
  if (progress) progress(0.3);
  std::vector<ShColour> coefficients = sh_project(input.probe, o.order);
  if (o.irradiance) coefficients = sh_irradiance(coefficients);
  if (o.json) {
    nlohmann::ordered_json list = nlohmann::json::array();
    for (const ShColour& c : coefficients) list.push_back({c.r, c.g, c.b});
    fmt::print("{}\n", nlohmann::ordered_json{{"order", o.order},
                                              {"quantity", o.irradiance ? "irradiance" : "radiance"},
                                              {"basis", "real, orthonormal, polar axis +z, no Condon-Shortley sign"},
                                              {"coefficients", list}}
                           .dump(2));
  } else if (o.outputs.empty()) {
    for (int l = 0; l <= o.order; ++l)
      for (int m = -l; m <= l; ++m) {
        const ShColour& c = coefficients[static_cast<std::size_t>(l * l + l + m)];
        fmt::print("{:2} {:3}  {: .6e} {: .6e} {: .6e}\n", l, m, c.r, c.g, c.b);
      }
  }
  if (!o.outputs.empty())
    write_probe(o.outputs, sh_map(coefficients, input.probe.projection, input.probe.texels, o.size), input.arrangement);
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_probe_sh(CLI::App& app) {
  static Options options;
  add_probe_input(app, options.input);
  expect_number(
      app.add_option("--order", options.order, "Highest degree l; (l + 1)^2 coefficients")->capture_default_str(),
      {.expected = "an order from 0 to 32", .low = 0, .below = highest_sh_order + 1});
  app.add_flag("--irradiance", options.irradiance, "Convolve with the cosine: coefficients of irradiance");
  expect_number(app.add_option("--size", options.size, "Rows of the map written by -o")->capture_default_str(),
                {.expected = "a number of rows from 1 to 4096", .low = 1, .below = 4097});
  add_outputs(app, options.outputs, "The map that the coefficients stand for, in the layout of the input");
  app.add_flag("--json", options.json, "Print JSON");
  app.footer("Without -o prints l, m and the coefficients of R, G and B.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
