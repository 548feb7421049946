#include "lambert/image/probe/assemble.h"

#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"
#include "../read_finite.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/probe/find_ball.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lambert::cli {

using namespace probe;

namespace {

struct Options {
  std::vector<std::string> files, outputs;
  std::vector<double> angles;
  std::vector<float> reflectivity;
  double ball_distance = 0, camera_radius = 25, rim = 150, search = 8;
  int size = 512;
  WorkOptions work;
  bool find = false, as_given = false, keep_exposure = false, json = false;
};

Probe read_ball(const Options& o, const std::string& file) {
  ProbeInputOptions input;
  input.file = file;
  input.reflectivity = o.reflectivity;
  input.layout.layout = "mirror-ball";
  input.layout.ball_distance = o.ball_distance;
  if (!o.find) return read_probe(input).probe;
  const Image photograph = read_finite(file);
  const std::string name = input_name(file);
  const auto ball = find_ball(photograph);
  if (!ball) throw Error(name + ": no ball found; crop it by 'lambert probe find-ball --circle'");
  warn_if_cut(name, photograph, *ball);
  log::info(
      fmt::format("{}: ball at {:.1f}, {:.1f}, radius {:.1f}", name, ball->centre.x, ball->centre.y, ball->radius));
  return divided(cut(layout_of(input.layout), {crop_ball(photograph, *ball)}), o.reflectivity);
}

/// Degrees between a rotation and the turn that was given.
float turned_by(const Mat3& found, Angle given) {
  const Mat3 change = found * glm::transpose(rotation(given, degrees(0), degrees(0)));
  const float cosine = 0.5f * (change[0][0] + change[1][1] + change[2][2] - 1);
  return std::acos(std::clamp(cosine, -1.0f, 1.0f)) * 180 / pi;
}

int run(const Options& o) {
  if (o.angles.size() != o.files.size())
    throw Error(
        fmt::format("--angles: expected {} numbers, one for each photograph, got {}", o.files.size(), o.angles.size()));
  for (const double angle : o.angles)
    if (!(std::abs(angle) <= 1e5)) throw Error("--angles: expected angles in degrees");
  check_probes(o.outputs);
  const FractionSink progress = start_work(o.work);
  std::vector<BallView> views;
  for (std::size_t i = 0; i < o.files.size(); ++i)
    views.push_back({read_ball(o, o.files[i]), degrees(static_cast<float>(o.angles[i]))});
  if (progress) progress(0.3);
  const AssembleSettings settings{.camera_radius = degrees(static_cast<float>(o.camera_radius)),
                                  .rim = degrees(static_cast<float>(o.rim)),
                                  .align = !o.as_given,
                                  .search = degrees(static_cast<float>(o.search)),
                                  .match_exposure = !o.keep_exposure};
  const Assembly a = assemble(views, o.size, settings);
  nlohmann::ordered_json list = nlohmann::json::array();
  for (std::size_t i = 0; i < views.size(); ++i) {
    nlohmann::ordered_json rows = nlohmann::json::array();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) rows.push_back(a.rotations[i][c][r]);
    list.push_back({{"file", input_name(o.files[i])},
                    {"rotation", rows},
                    {"exposure", json_of(a.exposures[i])},
                    {"correlation", a.correlations[i]}});
    if (i == 0 || o.as_given) continue;
    const float turned = turned_by(a.rotations[i], views[i].azimuth - views[0].azimuth);
    if (a.correlations[i] < 0.5f)
      log::warn(fmt::format("{}: fits the first photograph badly (correlation {:.2f}): are the angles right?",
                            input_name(o.files[i]), a.correlations[i]));
    else if (static_cast<double>(turned) > 0.9 * o.search)
      log::warn(
          fmt::format("{}: fits best {:.1f} degrees from where --angles has it, at the end of the search of {:g}: "
                      "are the angles right?",
                      input_name(o.files[i]), turned, o.search));
  }
  if (o.json) fmt::print("{}\n", nlohmann::ordered_json{{"views", list}}.dump(2));
  write_probe(o.outputs, a.probe, Arrangement::single);
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_probe_assemble(CLI::App& app) {
  static Options o;
  app.add_option("files", o.files, "Photographs of a mirror ball, cropped to it, from two or more sides")
      ->required()
      ->type_name("FILE...");
  app.add_option("--angles", o.angles,
                 "Where each camera stood: degrees about the ball, seen from above counter-clockwise")
      ->delimiter(',')
      ->required();
  app.add_flag("--find", o.find, "The files are whole photographs: find and crop the ball");
  app.add_option("--reflectivity", o.reflectivity, "Of the ball, one number or R,G,B")->delimiter(',')->expected(1, 3);
  expect_number(app.add_option("--ball-distance", o.ball_distance,
                               "Of the camera from the ball's centre, in radii (default: far away)"),
                {.expected = "a number of radii above 1", .low = 1.001, .below = 1e6});
  const NumberRange angle{.expected = "an angle from 0 to 180 degrees", .low = 0, .below = 180.001};
  expect_number(app.add_option("--camera-radius", o.camera_radius,
                               "Degrees about the ball's centre that show camera and photographer: not used")
                    ->capture_default_str(),
                angle);
  expect_number(
      app.add_option("--rim", o.rim, "Degrees from the camera beyond which a ball is not used if another can be")
          ->capture_default_str(),
      angle);
  app.add_flag("--as-given", o.as_given, "Trust the angles: no alignment");
  expect_number(
      app.add_option("--search", o.search, "Degrees about each axis that the angles may be off")->capture_default_str(),
      {.expected = "an angle from 0.1 to 45 degrees", .low = 0.1, .below = 45.001});
  app.add_flag("--keep-exposure", o.keep_exposure, "Do not match the photographs' exposures");
  expect_number(app.add_option("--size", o.size, "Rows of the lat-long map")->capture_default_str(),
                {.expected = "a number of rows from 1 to 16384", .low = 1, .below = 16385});
  app.add_flag("--json", o.json, "Print what was found as JSON");
  add_outputs(app, o.outputs, "The lat-long map; the first camera stands at +z and looks along -z")->required();
  add_work_options(app, o.work);
  return [] { return run(o); };
}

}  // namespace lambert::cli
