#include "command.h"
#include "number_range.h"
#include "outputs.h"
#include "print_path.h"
#include "work.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/denoise/denoise.h"
#include "lambert/image/io.h"
#include "lambert/image/tonemap/tonemap.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace lambert::cli {
namespace {

struct DenoiseOptions {
  std::string input;
  std::vector<std::string> outputs;
  std::string method = "auto", library;
  float firefly = denoise::GatherSettings{}.firefly;
  bool no_guides = false;
  std::size_t threads = 0;
  float exposure = 0;
  std::string tonemap = "linear";
  WorkOptions work;
};

int run(const DenoiseOptions& o) {
  DenoiseSettings settings{.method = denoise_method(o.method), .oidn_library = o.library};
  settings.input.use_guides = !o.no_guides;
  settings.input.firefly = o.firefly;
  const ToneSettings tone{.op = tone_operator(o.tonemap), .exposure = o.exposure};
  check_images(o.outputs);
  set_thread_count(o.threads);
  const FractionSink progress = start_work(o.work);
  settings.progress = part_of(progress, 0.05, 0.95);
  const Image noisy = read_image(o.input);
  Image image;
  try {
    image = denoise_image(noisy, settings);
  } catch (const Error& e) {
    throw Error(o.input + ": " + e.what());
  }
  for (const std::string& path : o.outputs) {
    write_image(path, is_radiance_format(path) ? image : tonemap(image, tone));
    print_path(path);
  }
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_denoise(CLI::App& app) {
  static DenoiseOptions o;
  app.add_option("input", o.input, "Rendered image, best with the layers of 'lambert render --aov denoising'")
      ->type_name("FILE")
      ->required();
  add_outputs(app, o.outputs, fmt::format("Image to write: {}", fmt::join(image_extensions(), ", ")))->required();
  app.add_option("--method", o.method, fmt::format("{}", fmt::join(denoise_method_names(), ", ")))
      ->capture_default_str();
  app.add_flag("--no-guides", o.no_guides, "Use colour alone (nfor, nlm, bilateral)");
  expect_number(
      app.add_option("--firefly", o.firefly,
                     "A pixel is at most this times the brightest around it, outliers apart; 0: leave fireflies")
          ->capture_default_str(),
      {.expected = "a number from 0 to 1e30", .below = 1.000001e30});
  app.add_option("--oidn-library", o.library, "Open Image Denoise, if it is not where the system looks")
      ->type_name("FILE");
  expect_number(app.add_option("--threads", o.threads, "0: all cores")->capture_default_str(), whole_number(0, 4096));
  expect_number(app.add_option("--exposure", o.exposure, "Stops, for display formats")->capture_default_str(),
                {.expected = "a number of stops between -100 and 100", .low = -100, .below = 100});
  app.add_option("--tonemap", o.tonemap, fmt::format("For display formats: {}", fmt::join(tone_operator_names(), ", ")))
      ->capture_default_str();
  add_work_options(app, o.work);
  app.footer(
      "Examples:\n"
      "  lambert render box.pbrt --spp 16 --aov denoising -o noisy.exr\n"
      "  lambert denoise noisy.exr -o clean.exr -o clean.png\n"
      "  lambert denoise photo.png -o clean.png          colour alone, noise as measured");
  return [] { return run(o); };
}

}  // namespace lambert::cli
