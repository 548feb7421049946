#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"
#include "../print_path.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/probe/irradiance.h"
#include "lambert/image/probe/median_cut.h"
#include "lambert/image/probe/resample.h"
#include "lambert/image/probe/suns.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lambert::cli {

using namespace probe;

namespace {

struct Options {
  ProbeInputOptions input;
  int suns = 1, count = 0;
  double threshold = 0.05, contrast = 20;
  std::string sky, pbrt;
  std::vector<std::string> outputs;
};

/// Directions as people say them: degrees above the horizon, and about +y from -z (ahead) towards +x.
nlohmann::ordered_json place(Vec3 d) {
  const float to_degrees = 180 / pi;
  return {{"elevation", std::asin(std::clamp(d.y, -1.0f, 1.0f)) * to_degrees},
          {"azimuth", std::atan2(d.x, -d.z) * to_degrees}};
}

std::string pbrt_line(Vec3 d, Rgb e) {
  return fmt::format(
      "LightSource \"distant\" \"point3 from\" [ {} {} {} ] \"point3 to\" [ 0 0 0 ] \"rgb L\" [ {} {} {} ]\n", d.x, d.y,
      d.z, e.r, e.g, e.b);
}

struct Result {
  nlohmann::ordered_json json;
  std::string pbrt;
};

Result suns(const Options& o, const ProbeInput& input) {
  const SunsAndSky found = separate_suns(
      input.probe,
      {.most = o.suns, .threshold = static_cast<float>(o.threshold), .contrast = static_cast<float>(o.contrast)});
  Result result;
  nlohmann::ordered_json list = nlohmann::json::array();
  Rgb up;
  for (const Sun& s : found.suns) {
    nlohmann::ordered_json j{{"direction", json_of(s.direction)}};
    j.update(place(s.direction));
    j["irradiance"] = json_of(s.irradiance);
    j["radiance"] = json_of(s.radiance);
    j["solid_angle"] = s.solid_angle;
    j["angular_radius_degrees"] = s.angular_radius * 180 / pi;
    j["peak_luminance"] = s.peak;
    list.push_back(j);
    up += std::max(0.0f, s.direction.y) * s.irradiance;
    result.pbrt += pbrt_line(s.direction, s.irradiance);
  }
  const Rgb all = Irradiance(input.probe)({0, 1, 0}), sky = Irradiance(found.sky)({0, 1, 0});
  result.json = {{"lights", list},
                 {"horizontal_irradiance", {{"map", json_of(all)}, {"sky", json_of(sky)}, {"lights", json_of(up)}}}};
  if (!o.sky.empty()) write_probe({o.sky}, found.sky, input.arrangement);
  return result;
}

Result cuts(const Options& o, const ProbeInput& input) {
  const Probe& p = input.probe;
  const bool as_it_is = std::holds_alternative<LatLong>(p.projection) && p.texels == TexelRule::cells;
  const Probe map = as_it_is ? p : resample(p, LatLong{}, TexelRule::cells, similar_size(p, LatLong{}));
  Result result;
  nlohmann::ordered_json list = nlohmann::json::array();
  for (const CutLight& l : median_cut(map, o.count)) {
    nlohmann::ordered_json j{{"direction", json_of(l.direction)}};
    j.update(place(l.direction));
    j["irradiance"] = json_of(l.irradiance);
    j["texels"] = {l.texels.x, l.texels.y, l.texels.width, l.texels.height};
    list.push_back(j);
    result.pbrt += pbrt_line(l.direction, l.irradiance);
  }
  result.json = {{"lights", list}};
  return result;
}

int run(const Options& o) {
  if (o.count > 0 && !o.sky.empty()) throw Error("--sky: median-cut lights leave no sky; leave out --count");
  if (!o.sky.empty()) check_probes({o.sky});
  check_texts({o.pbrt});
  check_texts(o.outputs);
  const FractionSink progress = start_work(o.input.work);
  const ProbeInput input = read_probe(o.input);
  if (progress) progress(0.3);
  const Result result = o.count > 0 ? cuts(o, input) : suns(o, input);
  const std::string text = result.json.dump(2) + "\n";
  if (!o.pbrt.empty()) {
    write_atomically(o.pbrt, std::string_view(result.pbrt));
    print_path(o.pbrt);
  }
  if (o.outputs.empty()) fmt::print("{}", text);
  for (const std::string& path : o.outputs) {
    write_atomically(path, std::string_view(text));
    print_path(path);
  }
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_probe_lights(CLI::App& app) {
  static Options options;
  add_probe_input(app, options.input);
  expect_number(app.add_option("--suns", options.suns, "Suns to look for")->capture_default_str(),
                {.expected = "a number from 1 to 64", .low = 1, .below = 65});
  expect_number(app.add_option("--threshold", options.threshold,
                               "Of the peak's luminance: what is connected to it and above this belongs to the sun")
                    ->capture_default_str(),
                {.expected = "a number above 0 and below 1", .low = 1e-6, .below = 1});
  expect_number(app.add_option("--contrast", options.contrast,
                               "A sun's peak is at least so many times the mean luminance of the rest")
                    ->capture_default_str(),
                {.expected = "a number of at least 1", .low = 1, .below = 1e9});
  add_output(app, "--sky", options.sky, "Write the environment without the suns, in the layout of the input");
  expect_number(app.add_option("--count", options.count, "Median-cut lights instead (Debevec 2005), so many"),
                {.expected = "a number from 1 to 65536", .low = 1, .below = 65537});
  add_output(app, "--pbrt", options.pbrt, "Write the lights as pbrt's LightSource directives");
  add_outputs(app, options.outputs, "Write the JSON there instead of printing it");
  app.footer(
      "Directions point towards the lights; irradiance is on a surface that faces the light, as a directional light "
      "has it.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
