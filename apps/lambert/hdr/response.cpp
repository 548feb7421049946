#include "plot.h"
#include "verb.h"

#include "../command.h"
#include "../outputs.h"
#include "../print_path.h"

#include "lambert/base/file.h"
#include "lambert/base/log.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace lambert::cli {
namespace {

struct Options {
  StackOptions stack;
  RecoveryOptions recovery;
  std::vector<std::string> outputs;
  std::string plot, table = "exposure";
};

int run(const Options& o) {
  check_texts(o.outputs);
  if (!o.plot.empty()) check_drawings({o.plot});
  const FractionSink progress = start_work(o.stack.work);
  const LoadedStack loaded = load_stack(o.stack, part_of(progress, 0, 0.7));
  const hdr::Recovery recovery = response_for(o.recovery, loaded.stack);
  if (progress) progress(1);
  const std::string csv = hdr::response_csv(
      recovery.response, o.table == "code" ? hdr::ResponseTable::by_code : hdr::ResponseTable::by_exposure);
  if (recovery.samples > 0)
    log::info(fmt::format("response: {}, from {} samples, noise {:.2g} codes", recovery.model, recovery.samples,
                          middle_noise(recovery.noise)));
  if (!o.plot.empty()) plot_response(o.plot, recovery.response);
  if (o.outputs.empty()) fmt::print("{}", csv);
  for (const std::string& path : o.outputs) {
    write_atomically(path, csv);
    print_path(path);
  }
  return done;
}

}  // namespace

std::function<int()> add_hdr_response(CLI::App& app) {
  static Options o;
  add_stack_options(app, o.stack);
  add_recovery_options(app, o.recovery);
  add_outputs(app, o.outputs, "CSV file; printed when not given");
  add_output(app, "--plot", o.plot, "Draw it (.svg or an image)");
  app.add_option("--by", o.table, "Rows: by exposure (what code it gives) or by code (what exposure is behind it)")
      ->type_name("KEY")
      ->check(CLI::IsMember({"exposure", "code"}))
      ->capture_default_str();
  return [] { return run(o); };
}

}  // namespace lambert::cli
