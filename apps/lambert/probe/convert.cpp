#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/resample.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace probe;

namespace {

struct Options {
  ProbeInputOptions input;
  LayoutOptions to;
  RotationOptions rotation;
  int size = 0;
  std::vector<std::string> outputs;
};

void add_size_and_outputs(CLI::App& app, Options& o) {
  expect_number(app.add_option("--size", o.size,
                               "Rows of a lat-long map, of a face or of a square map (default: as fine "
                               "as the input)"),
                {.expected = "a number of rows from 1 to 32768", .low = 1, .below = 32769});
  add_outputs(app, o.outputs, "What to write, by extension; {} in the name stands for six faces")->required();
}

int run(const Options& o, bool keep_layout) {
  check_probes(o.outputs);
  const FractionSink progress = start_work(o.input.work);
  const ProbeInput input = read_probe(o.input);
  const Layout to =
      keep_layout ? Layout{input.probe.projection, input.arrangement, input.probe.texels} : layout_of(o.to);
  const bool same_size = keep_layout && o.size == 0;
  const Vec2i size = same_size    ? Vec2i(input.probe.width(), input.probe.height())
                     : o.size > 0 ? chart_size(to.projection, o.size)
                                  : similar_size(input.probe, to.projection);
  write_probe(o.outputs,
              resample(input.probe, to.projection, to.texels, size,
                       {.rotation = rotation_of(o.rotation), .progress = part_of(progress, 0.1, 0.8)}),
              to.arrangement);
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_probe_convert(CLI::App& app) {
  static Options options;
  add_probe_input(app, options.input);
  add_layout_options(app, options.to, "--to", "to-", "Layout of the output");
  app.get_option("--to")->required();
  add_rotation_options(app, options.rotation);
  add_size_and_outputs(app, options);
  app.footer("Each texel is the mean of the input over its solid angle.");
  return [] { return run(options, false); };
}

std::function<int()> add_probe_rotate(CLI::App& app) {
  static Options options;
  add_probe_input(app, options.input);
  add_rotation_options(app, options.rotation);
  add_size_and_outputs(app, options);
  app.footer("The output has the layout of the input.");
  return [] { return run(options, true); };
}

}  // namespace lambert::cli
