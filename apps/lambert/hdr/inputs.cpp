#include "verb.h"

#include "../number_range.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/number.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/formats/exif.h"
#include "lambert/image/hdr/exposure.h"
#include "lambert/image/hdr/ghosts.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace lambert::cli {
namespace {

std::vector<std::string> parted(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::vector<double> flag_times(const StackOptions& o) {
  std::vector<double> times;
  if (!o.times.empty()) {
    for (const std::string& word : parted(o.times)) times.push_back(hdr::parse_exposure_time(word, "--times"));
    return times;
  }
  for (const std::string& word : parted(o.stops)) {
    double stops = 0;
    const char* end = parse_double(word.data(), word.data() + word.size(), stops);
    if (word.empty() || end != word.data() + word.size() || std::abs(stops) > 60)
      throw Error("--stops: expected numbers parted by commas, such as -2,0,2, got '" + printable(word) + "'");
    times.push_back(std::exp2(stops));
  }
  return times;
}

bool is_list(const std::string& file) { return file.ends_with(".txt") || file.ends_with(".hdrgen"); }

/// The settings that a list has for `files`; all that it names when there are none.
std::vector<hdr::ExposureSetting> from_list(const std::string& list_name, std::vector<std::string>& files) {
  const std::vector<hdr::ListedExposure> list = hdr::read_exposure_list(list_name);
  std::vector<hdr::ExposureSetting> settings;
  if (files.empty()) {
    for (const hdr::ListedExposure& e : list) files.push_back(e.file.string()), settings.push_back(e.setting);
    return settings;
  }
  for (const std::string& file : files) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const hdr::ListedExposure& e) {
      return e.file.filename() == std::filesystem::path(file).filename();
    });
    if (found == list.end()) throw Error(input_name(file) + ": is not in the list " + list_name);
    settings.push_back(found->setting);
  }
  return settings;
}

hdr::ExposureSetting from_exif(const std::string& file) {
  const MappedFile mapped = open_input(file);
  hdr::ExposureSetting setting;
  if (const auto exif = read_exif(mapped.bytes())) {
    setting.time = exif->exposure_time.value_or(0);
    setting.f_number = exif->f_number.value_or(0);
    setting.iso = exif->iso.value_or(0);
  }
  return setting;
}

std::size_t best_exposed(const hdr::ExposureStack& stack, int asked) {
  if (asked < 0) return hdr::best_exposed(stack);
  if (static_cast<std::size_t>(asked) >= stack.frames.size())
    throw Error(
        fmt::format("--reference: there is no photograph {}: there are {}, counted from 0 and the shortest exposure",
                    asked, stack.frames.size()));
  return static_cast<std::size_t>(asked);
}

}  // namespace

void add_stack_options(CLI::App& app, StackOptions& o) {
  app.add_option("files", o.files, "Photographs (PNG, JPEG, TIFF, WebP), or one list of them (.txt, .hdrgen)")
      ->type_name("FILE");
  CLI::Option* list =
      app.add_option("--list", o.list, "Exposures: a photograph a line, its time, f-number, ISO")->type_name("FILE");
  CLI::Option* times =
      app.add_option("--times", o.times, "Exposure times in seconds in the order of the files: 1/60,1/15,1/4")
          ->type_name("T,T,…")
          ->excludes(list);
  app.add_option("--stops", o.stops, "Exposures in stops: -2,0,2")->type_name("S,S,…")->excludes(list)->excludes(times);
  app.add_option("--align", o.align, "Undo motion of the camera: none, shift, rigid")
      ->type_name("KIND")
      ->capture_default_str();
  expect_number(
      app.add_option("--max-shift", o.largest_shift, "Largest shift between neighbouring exposures, in pixels")
          ->capture_default_str(),
      {.expected = "a number of pixels from 1 to 4096", .low = 1, .below = 4097});
  expect_number(app.add_option("--reference", o.reference,
                               "Which photograph stays in place and is believed, from 0, the shortest exposure"),
                {.expected = "a number from 0", .low = 0, .below = 65536});
  add_work_options(app, o.work);
}

LoadedStack load_stack(const StackOptions& o, const FractionSink& progress) {
  const hdr::Alignment kind = hdr::alignment(o.align);
  std::vector<std::string> files = o.files;
  std::string list = o.list;
  if (list.empty() && files.size() == 1 && is_list(files[0])) list = files[0], files.clear();
  std::vector<hdr::ExposureSetting> settings;
  if (!o.times.empty() || !o.stops.empty()) {
    const std::vector<double> times = flag_times(o);
    if (times.size() != files.size())
      throw Error(fmt::format("{}: {} exposures for {} photographs", o.times.empty() ? "--stops" : "--times",
                              times.size(), files.size()));
    for (const double t : times) settings.push_back({.time = t});
  } else if (!list.empty()) {
    settings = from_list(list, files);
  } else {
    for (const std::string& file : files) settings.push_back(from_exif(file));
  }
  if (files.empty()) throw Error("no photographs given");
  LoadedStack loaded{.stack =
                         hdr::read_stack(files, hdr::relative_exposures(files, settings), part_of(progress, 0, 0.5))};
  hdr::check_exposures(loaded.stack);
  loaded.reference = best_exposed(loaded.stack, o.reference);
  loaded.motions = hdr::find_motions(loaded.stack, loaded.reference, {.kind = kind, .largest_shift = o.largest_shift},
                                     part_of(progress, 0.5, 1));
  hdr::move_back(loaded.stack, loaded.motions);
  return loaded;
}

void add_recovery_options(CLI::App& app, RecoveryOptions& o) {
  app.add_option("--response", o.response,
                 "Recover it: auto, debevec, robertson, mitsunaga; or it is known: srgb, linear, 'gamma 2.2', film, "
                 "log, a CSV file")
      ->type_name("WORD")
      ->capture_default_str();
  expect_number(app.add_option("--smoothness", o.settings.smoothness, "λ of debevec")->capture_default_str(),
                {.expected = "a number from 0", .low = 0, .below = 1e9});
}

hdr::Recovery response_for(const RecoveryOptions& o, const hdr::ExposureStack& stack) {
  const std::vector<std::string> methods = hdr::recovery_method_names();
  if (std::find(methods.begin(), methods.end(), o.response) == methods.end()) {
    hdr::Recovery known{.model = o.response};
    known.response = hdr::response_named(o.response, stack.channels, static_cast<std::size_t>(stack.levels));
    known.noise = hdr::measure_noise(stack, known.response);
    return known;
  }
  hdr::RecoverySettings settings = o.settings;
  settings.method = hdr::recovery_method(o.response);
  return hdr::recover_response(stack, settings);
}

double middle_noise(const hdr::CodeNoise& noise) {
  float most = noise.deviation.empty() ? noise.at(0, 0) : 0;
  for (const auto& channel : noise.deviation) most = std::max(most, channel[channel.size() / 2]);
  return static_cast<double>(most);
}

}  // namespace lambert::cli
