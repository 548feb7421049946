#include "lambert/image/probe/find_ball.h"

#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {

using namespace probe;

namespace {

struct Options {
  std::string file;
  std::vector<std::string> outputs;
  int size = 0;
  std::vector<double> circle;
  std::vector<int> reflected, direct;
};

Window window_of(const std::vector<int>& w) { return {w[0], w[1], w[2], w[3]}; }

int run(const Options& o) {
  const std::string name = input_name(o.file);
  if (o.reflected.empty() != o.direct.empty()) throw Error("--reflected and --direct belong together");
  check_images(o.outputs);
  const Image image = displayed(read_image(o.file));
  nlohmann::ordered_json j;
  if (!o.direct.empty())
    j["reflectivity"] =
        named(name, [&] { return json_of(ball_reflectivity(image, window_of(o.reflected), window_of(o.direct))); });
  std::optional<BallCircle> ball;
  if (!o.circle.empty())
    ball = BallCircle{{o.circle[0], o.circle[1]}, o.circle[2], 0, 0};
  else
    ball = find_ball(image);
  if (!ball) throw Error(name + ": no ball found; give --circle X,Y,RADIUS in pixels");
  if (!(ball->radius >= 0.5 && ball->radius < 1e5)) throw Error("--circle: expected a radius from 0.5 pixels on");
  warn_if_cut(name, image, *ball);
  j["centre"] = {ball->centre.x, ball->centre.y};
  j["radius"] = ball->radius;
  if (o.circle.empty()) j["coverage"] = ball->coverage, j["residual"] = ball->residual;
  if (o.outputs.empty())
    fmt::print("{}\n", j.dump(2));
  else
    write_images(o.outputs, crop_ball(image, *ball, o.size));
  return done;
}

}  // namespace

std::function<int()> add_probe_find_ball(CLI::App& app) {
  static Options options;
  app.add_option("file", options.file, "A photograph")->required()->type_name("FILE");
  app.add_option("--circle", options.circle, "X,Y,RADIUS in pixels: use this circle, do not look for one")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--reflected", options.reflected, "X,Y,WIDTH,HEIGHT of a patch as the ball shows it, and")
      ->delimiter(',')
      ->expected(4);
  app.add_option("--direct", options.direct, "X,Y,WIDTH,HEIGHT of it in the open: prints the ball's reflectivity")
      ->delimiter(',')
      ->expected(4);
  expect_number(app.add_option("--size", options.size, "Rows of the crop (default: as in the photograph)"),
                {.expected = "a number of rows from 1 to 16384", .low = 1, .below = 16385});
  add_outputs(app, options.outputs, "Write the square that the ball fills, a mirror-ball layout");
  app.footer("Without -o prints the circle as JSON.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
