#include "plot.h"
#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"
#include "../print_path.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/log.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/hdr/merge.h"
#include "lambert/image/hdr/range.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lambert::cli {
namespace {

struct Options {
  StackOptions stack;
  RecoveryOptions recovery;
  std::vector<std::string> outputs;
  std::string response_out, plot, weights = "variance", ghosts = "auto", compression = "piz";
  hdr::SensorNoise noise;
  hdr::GhostSettings ghost;
  double scale = 1;
  bool json = false;
};

nlohmann::ordered_json facts_of(const LoadedStack& loaded, const hdr::Recovery& recovery, const hdr::Merged& merged,
                                std::size_t ghosts) {
  nlohmann::ordered_json j;
  j["size"] = {loaded.stack.width, loaded.stack.height};
  j["bits"] = loaded.stack.levels == 256 ? 8 : 16;
  for (std::size_t i = 0; i < loaded.stack.frames.size(); ++i) {
    const hdr::Motion& m = loaded.motions[i];
    j["photographs"].push_back({{"file", loaded.stack.frames[i].name},
                                {"exposure", loaded.stack.frames[i].exposure},
                                {"shift", {m.shift.x, m.shift.y}},
                                {"turn_degrees", m.turn * 57.29577951308232}});
  }
  j["reference"] = loaded.reference;
  j["response"] = recovery.model;
  j["noise"] = middle_noise(recovery.noise);
  j["samples"] = recovery.samples;
  j["saturated_pixels"] = merged.saturated;
  j["black_pixels"] = merged.black;
  j["ghost_pixels"] = ghosts;
  return j;
}

void say(const nlohmann::ordered_json& j) {
  for (const auto& p : j["photographs"]) {
    const double x = p["shift"][0].get<double>(), y = p["shift"][1].get<double>(),
                 turn = p["turn_degrees"].get<double>();
    log::info(fmt::format("{}: exposure {:.6g}{}", p["file"].get<std::string>(), p["exposure"].get<double>(),
                          x == 0 && y == 0 && turn == 0
                              ? ""
                              : fmt::format(", moved by ({:.4g}, {:.4g}) pixels{}", x, y,
                                            turn == 0 ? "" : fmt::format(" and {:.3g} degrees", turn))));
  }
  const std::string model = j["response"].get<std::string>();
  if (j["samples"].get<std::size_t>() > 0)
    log::info(fmt::format("response: {} (from {} samples, noise {:.2g} codes)",
                          model == "recovered" ? model : "recovered, and agrees with " + model,
                          j["samples"].get<std::size_t>(), j["noise"].get<double>()));
  if (const auto ghosts = j["ghost_pixels"].get<std::size_t>())
    log::info(fmt::format("{} pixels left out where something moved", ghosts));
  if (const auto saturated = j["saturated_pixels"].get<std::size_t>())
    log::warn(fmt::format("{} pixels are saturated in every photograph: lower bounds stand there", saturated));
  if (const auto black = j["black_pixels"].get<std::size_t>())
    log::warn(fmt::format("{} pixels are black in every photograph", black));
}

int run(const Options& o) {
  for (const std::string& path : o.outputs)
    if (!is_radiance_format(path))
      throw Error(output_name(path) + ": radiance does not fit a display format; expected .exr, .hdr or .pfm");
  check_images(o.outputs);
  check_texts({o.response_out});
  if (!o.plot.empty()) check_drawings({o.plot});
  const hdr::Weighting weights = hdr::weighting(o.weights);
  if (o.ghosts != "auto" && o.ghosts != "off")
    throw Error("unknown --ghosts " + unknown_word(o.ghosts, {"auto", "off"}));
  const FractionSink progress = start_work(o.stack.work);
  const LoadedStack loaded = load_stack(o.stack, part_of(progress, 0, 0.5));
  const hdr::Recovery recovery = response_for(o.recovery, loaded.stack);
  hdr::GhostMasks masks;
  if (o.ghosts == "auto" && loaded.stack.frames.size() > 1) {
    hdr::GhostSettings settings = o.ghost;
    settings.reference = loaded.reference;
    settings.noise = recovery.noise;
    masks = hdr::find_ghosts(loaded.stack, recovery.response, settings);
  }
  hdr::Merged merged = hdr::merge(
      loaded.stack, recovery.response,
      {.weights = weights, .code_noise = recovery.noise, .noise = o.noise, .progress = part_of(progress, 0.7, 0.85)},
      masks);
  if (o.scale != 1)
    for (float& v : merged.image.pixels()) v *= static_cast<float>(o.scale);
  for (const std::string& path : o.outputs)
    write_image(path, merged.image, {.compression = parse_compression(o.compression)});
  std::vector<std::string> written = o.outputs;
  if (!o.response_out.empty()) {
    write_atomically(o.response_out, hdr::response_csv(recovery.response, hdr::ResponseTable::by_exposure));
    written.push_back(o.response_out);
  }
  if (!o.plot.empty()) {
    plot_response(o.plot, recovery.response);
    written.push_back(o.plot);
  }
  if (progress) progress(1);
  nlohmann::ordered_json facts = facts_of(loaded, recovery, merged, masks.count());
  facts["written"] = written;
  say(facts);
  if (o.json) {
    const hdr::RadianceRange range = hdr::radiance_range(merged.image);
    facts["max"] = range.max, facts["min_positive"] = range.min_positive, facts["stops"] = range.stops();
    fmt::print("{}\n", facts.dump(2));
    return done;
  }
  for (const std::string& path : written) print_path(path);
  return done;
}

}  // namespace

std::function<int()> add_hdr_merge(CLI::App& app) {
  static Options o;
  add_stack_options(app, o.stack);
  add_outputs(app, o.outputs, "Radiance map: .exr, .hdr or .pfm")->required();
  add_recovery_options(app, o.recovery);
  add_output(app, "--response-out", o.response_out, "Write the response as CSV");
  add_output(app, "--plot", o.plot, "Draw the response (.svg or an image)");
  app.add_option("--weights", o.weights, "variance, hat, gaussian, robertson")
      ->type_name("NAME")
      ->capture_default_str();
  expect_number(
      app.add_option("--full-well", o.noise.full_well, "Electrons at saturation, for weights by the sensor's noise"),
      {.expected = "a number of electrons from 1", .low = 1});
  expect_number(app.add_option("--read-noise", o.noise.read_noise, "Standard deviation of reading, in electrons"),
                {.expected = "a number of electrons from 0"});
  app.add_option("--ghosts", o.ghosts, "Leave out what moved: auto, off")->type_name("KIND")->capture_default_str();
  expect_number(
      app.add_option("--ghost-threshold", o.ghost.threshold, "Mean square difference, in variances, that is motion")
          ->capture_default_str(),
      {.expected = "a number above 0", .low = 1e-6});
  expect_number(app.add_option("--scale", o.scale, "Multiply the radiance by this")->capture_default_str(),
                {.expected = "a number from 1e-30 to 1e30", .low = 1e-30, .below = 1.000001e30});
  app.add_option("--compression", o.compression, "Of OpenEXR files; piz suits the grain of photographs")
      ->check(CLI::IsMember(compression_words()))
      ->capture_default_str();
  app.add_flag("--json", o.json, "Print what was found as JSON");
  app.footer(
      "Exposures come from --times, --stops, --list or the EXIF data of the photographs, f-number and ISO included.\n"
      "Radiance 1 saturates a photograph of exposure 1: time (ISO / 100) / N^2, or the time alone where only that is "
      "known.");
  return [] { return run(o); };
}

}  // namespace lambert::cli
