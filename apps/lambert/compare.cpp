#include "compare/comparison.h"

#include "command.h"
#include "number_range.h"
#include "outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <limits>
#include <memory>

namespace lambert::cli {
namespace {

int run(const CompareOptions& o) {
  check_pictures(o);
  Pair pair = read_pair(o);
  if (pair.a.width() != pair.b.width() || pair.a.height() != pair.b.height()) {
    log::error(fmt::format("the sizes differ: {} is {}x{}, {} is {}x{}", o.image, pair.a.width(), pair.a.height(),
                           o.reference, pair.b.width(), pair.b.height()));
    return sizes_differ;
  }
  const Comparison c = compared(o, std::move(pair));
  const int status = verdict(c);
  write_pictures(c);
  print_report(c, status);
  return status;
}

}  // namespace

std::function<int()> add_compare(CLI::App& app) {
  const auto o = std::make_shared<CompareOptions>();
  app.add_option("image", o->image, "The image to judge")->required()->type_name("IMAGE");
  app.add_option("reference", o->reference, "What it should be")->required()->type_name("REFERENCE");
  const auto add_thresholds = [&](const std::string& name, Thresholds& t) {
    expect_number(app.add_option("--" + name, t.each,
                                 "Largest difference of a pixel's channels, or value of --metric, without a " + name)
                      ->capture_default_str(),
                  {"a finite number", std::numeric_limits<double>::lowest()});
    expect_number(app.add_option("--" + name + "-percent", t.percent, "Share of the pixels that may pass it")
                      ->capture_default_str(),
                  {"a number from 0 to 100", 0, 100.000001});
    expect_number(app.add_option("--hard-" + name, t.hard, "What no pixel may pass"), {"a number, 0 or more"});
  };
  add_thresholds("fail", o->fail);
  add_thresholds("warn", o->warn);
  app.add_option("--metric", o->metric, "Decide by this instead of by pixels; 'all' prints all")
      ->check(CLI::IsMember({"mse", "rel-mse", "psnr", "ssim", "flip", "all"}));
  app.add_option("--space", o->space, "What is compared: linear light, sRGB codes, or what the files hold")
      ->check(CLI::IsMember({"auto", "linear", "srgb"}))
      ->capture_default_str();
  app.add_flag("--layers", o->layers, "All channels, not the colours alone");
  app.add_flag("--z-test", o->z, "Decide whether both estimate the same image, by their variance channels");
  expect_number(app.add_option("--alpha", o->alpha, "Significance of the z-test")->capture_default_str(),
                {"between 0 and 1", 1e-300, 1});
  expect_number(app.add_option("--pixels-per-degree", o->flip.pixels_per_degree, "How the viewer of flip sits")
                    ->capture_default_str(),
                {"from 1 to 1000", 1, 1000.0001});
  add_output(app, "--difference", o->difference, "Write image - reference");
  add_output(app, "--heat", o->heat, "Write a false-colour image");
  app.add_option("--heat-of", o->heat_of, "What it shows")
      ->check(CLI::IsMember({"error", "flip", "ssim", "z"}))
      ->capture_default_str();
  expect_number(app.add_option("--heat-top", o->heat_top, "The value of its brightest colour; 0 finds one")
                    ->capture_default_str(),
                {"a number, 0 or more"});
  app.add_flag("--json", o->json, "Print JSON");
  app.add_flag("-q,--quiet", o->quiet, "Print nothing");
  app.footer(
      "Exit status, as of idiff: 0 same, 1 warning, 2 different, 3 the sizes differ, 4 they cannot be compared.\n"
      "  lambert compare a.exr truth.exr --heat difference.png\n"
      "  lambert compare a.png b.png --metric flip --fail 0.05 --warn 0.02");
  return [o] { return run(*o); };
}

}  // namespace lambert::cli
