#include "lambert/image/filter/resolve.h"

#include "filter_options.h"
#include "verb.h"

#include "../command.h"
#include "../number_range.h"

#include "lambert/base/error.h"
#include "lambert/image/io.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {
namespace {

struct Options : FilterOptions {
  int factor = 3;
  std::string filter = "box";
};

int run(const Options& o) {
  if (o.filter != "box" && o.filter != "bartlett")
    throw Error("--filter: unknown kernel " + unknown_word(o.filter, {"box", "bartlett"}));
  const FractionSink progress = start_work(o.work);
  const Image samples = read_input(o, progress);
  write_outputs(o, resolved(samples, o.factor, o.filter == "box" ? ResolveKernel::box : ResolveKernel::bartlett),
                progress);
  return done;
}

}  // namespace

std::function<int()> add_resolve(CLI::App& app) {
  static Options o;
  add_image_paths(app, o);
  expect_number(app.add_option("--factor", o.factor, "Samples per pixel along each axis")->capture_default_str(),
                whole_number(1, 64));
  app.add_option("--filter", o.filter, "box (all alike) or bartlett (1 2 1 along each axis)")->capture_default_str();
  return [] { return run(o); };
}

}  // namespace lambert::cli
