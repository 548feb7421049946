#include "lambert/image/filter/fill_gaps.h"

#include "filter_options.h"
#include "verb.h"

#include "../command.h"

#include "lambert/image/io.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {
namespace {

struct Options : FilterOptions {
  std::string mask, method = "push-pull";
};

int run(const Options& o) {
  const GapFilling method = gap_filling(o.method);
  const FractionSink progress = start_work(o.work);
  const Image atlas = read_input(o, progress);
  write_outputs(o, gaps_filled(atlas, o.mask.empty() ? coverage_of(atlas) : read_image(o.mask), method), progress);
  return done;
}

}  // namespace

std::function<int()> add_fill_gaps(CLI::App& app) {
  static Options o;
  add_image_paths(app, o);
  app.add_option("--mask", o.mask, "Image that is 1 where charts are; by default the atlas's alpha")->type_name("FILE");
  app.add_option("--method", o.method, listed(gap_filling_names()))->capture_default_str();
  app.footer("push-pull fills smoothly from coarser levels, nearest lets charts grow until they meet.");
  return [] { return run(o); };
}

}  // namespace lambert::cli
