#include "verb.h"

#include "../command.h"
#include "../outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/probe/range_check.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lambert::cli {

using namespace probe;

namespace {

struct Options {
  ProbeInputOptions input;
  std::vector<float> irradiance, diffuse, albedo{1}, normal{0, 1, 0};
  std::string restored;
  bool json = false;
};

std::optional<KnownIrradiance> known(const Options& o) {
  const Vec3 n = direction_of("--normal", o.normal);
  const auto light = [](const char* flag, const std::vector<float>& numbers) {
    const Rgb c = rgb_of(flag, numbers);
    if (!(min_component(c) > 0)) throw Error(std::string(flag) + ": expected numbers above 0");
    return c;
  };
  if (!o.irradiance.empty()) return KnownIrradiance{n, light("--irradiance", o.irradiance)};
  if (o.diffuse.empty()) return std::nullopt;
  return KnownIrradiance{n, light("--diffuse-radiance", o.diffuse) * pi / light("--albedo", o.albedo)};
}

int run(const Options& o) {
  const auto surface = known(o);
  if (!o.restored.empty() && !surface)
    throw Error("--restored: needs --irradiance or --diffuse-radiance to know what is missing");
  if (!o.restored.empty()) check_probes({o.restored});
  const FractionSink progress = start_work(o.input.work);
  const ProbeInput input = read_probe(o.input);
  if (progress) progress(0.3);
  const RangeReport r = check_range(input.probe);
  const float wide = r.plateau_solid_angle / sun_solid_angle;
  nlohmann::ordered_json j{{"brightest", r.brightest},
                           {"darkest", r.darkest},
                           {"ratio", r.ratio},
                           {"stops", r.stops},
                           {"mean_radiance", json_of(r.mean_radiance)},
                           {"irradiance_up", json_of(r.irradiance_up)},
                           {"irradiance_down", json_of(r.irradiance_down)},
                           {"plateau",
                            {{"value", r.plateau_value},
                             {"texels", r.plateau_texels},
                             {"solid_angle", r.plateau_solid_angle},
                             {"direction", json_of(r.plateau_direction)},
                             {"suns", wide}}},
                           {"clipped", r.clipped}};
  if (r.clipped)
    log::warn(fmt::format("{}: clipped: {} texels share the largest value, {}{}", input_name(o.input.file),
                          r.plateau_texels, r.plateau_value, r.at_format_limit ? ", the end of a format's range" : ""));
  std::optional<Rgb> factor;
  if (surface) {
    factor = missing_factor(input.probe, *surface);
    if (factor) {
      j["missing_factor"] = json_of(*factor);
      j["missing_stops"] = std::log2(luminance(*factor));
    } else {
      log::warn("the surface does not see the brightest place, or all other light is already more than it gets");
    }
  }
  if (o.json) {
    fmt::print("{}\n", j.dump(2));
  } else {
    fmt::print("luminance       {:.6g} to {:.6g}, {:.6g} to 1, {:.1f} stops\n", r.darkest, r.brightest, r.ratio,
               r.stops);
    fmt::print("mean radiance   {:.6g} {:.6g} {:.6g}\n", r.mean_radiance.r, r.mean_radiance.g, r.mean_radiance.b);
    fmt::print("irradiance up   {:.6g} {:.6g} {:.6g}\n", r.irradiance_up.r, r.irradiance_up.g, r.irradiance_up.b);
    fmt::print(
        "brightest place {} texels of {:.6g}, {:.3g} sr ({:.3g} times the sun's disk) towards {:.3f} {:.3f} {:.3f}\n",
        r.plateau_texels, r.plateau_value, r.plateau_solid_angle, wide, r.plateau_direction.x, r.plateau_direction.y,
        r.plateau_direction.z);
    fmt::print("clipped         {}\n", r.clipped ? "yes" : "no");
    if (factor)
      fmt::print("missing factor  {:.6g} {:.6g} {:.6g} ({:.1f} stops)\n", factor->r, factor->g, factor->b,
                 std::log2(luminance(*factor)));
  }
  if (!o.restored.empty()) {
    if (!factor) throw Error("--restored: no factor would give the surface its irradiance");
    write_probe({o.restored}, restored(input.probe, *factor), input.arrangement);
  }
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_probe_check(CLI::App& app) {
  static Options options;
  add_probe_input(app, options.input);
  app.add_option("--irradiance", options.irradiance, "Known irradiance of a surface, one number or R,G,B")
      ->delimiter(',')
      ->expected(1, 3);
  app.add_option("--diffuse-radiance", options.diffuse, "Or the radiance of a diffuse ball or card there")
      ->delimiter(',')
      ->expected(1, 3);
  app.add_option("--albedo", options.albedo, "Its albedo")->delimiter(',')->expected(1, 3)->capture_default_str();
  app.add_option("--normal", options.normal, "What the surface faces")
      ->delimiter(',')
      ->expected(3)
      ->capture_default_str();
  add_output(app, "--restored", options.restored,
             "Write the map with its brightest place multiplied by what is missing");
  app.add_flag("--json", options.json, "Print JSON");
  app.footer(
      "Warns when the brightest place is a plateau: the sun clipped by the camera. With a surface whose irradiance is\n"
      "known it says by what factor the place is too dark.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
