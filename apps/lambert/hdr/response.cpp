#include "plot.h"
#include "verb.h"

#include "../command.h"
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
  std::string output, plot, table = "exposure";
};

int run(const Options& o) {
  if (!o.output.empty()) check_writable(o.output);
  const LoadedStack loaded = load_stack(o.stack);
  const hdr::Recovery recovery = response_for(o.recovery, loaded.stack);
  const std::string csv = hdr::response_csv(
      recovery.response, o.table == "code" ? hdr::ResponseTable::by_code : hdr::ResponseTable::by_exposure);
  if (recovery.samples > 0)
    log::info(fmt::format("response: {}, from {} samples, noise {:.2g} codes", recovery.model, recovery.samples,
                          middle_noise(recovery.noise)));
  if (!o.plot.empty()) plot_response(o.plot, recovery.response);
  if (o.output.empty()) {
    fmt::print("{}", csv);
  } else {
    write_atomically(o.output, csv);
    print_path(o.output);
  }
  return done;
}

}  // namespace

std::function<int()> add_hdr_response(CLI::App& app) {
  static Options o;
  add_stack_options(app, o.stack);
  add_recovery_options(app, o.recovery);
  app.add_option("-o,--output", o.output, "CSV file; standard output when not given")->type_name("FILE");
  app.add_option("--plot", o.plot, "Draw it (.svg or an image)")->type_name("FILE");
  app.add_option("--by", o.table, "Rows: by exposure (what code it gives) or by code (what exposure is behind it)")
      ->type_name("KEY")
      ->check(CLI::IsMember({"exposure", "code"}))
      ->capture_default_str();
  return [] { return run(o); };
}

}  // namespace lambert::cli
