#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"
#include "../print_path.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/hash.h"
#include "lambert/base/number.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/formats/exif.h"
#include "lambert/image/hdr/expose.h"
#include "lambert/image/hdr/exposure.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>

namespace lambert::cli {
namespace {

struct Options {
  std::vector<std::string> outputs;
  std::string map, time, bracket, response = "srgb", list;
  double stops = 0, shake = 0, turn = 0;
  int bits = 8;
  std::uint64_t seed = 0;
  hdr::SensorNoise noise;
  WorkOptions work;
};

/// "-6..6:2", "-2..2" in steps of 1, or "-3,0,4".
std::vector<double> bracket_stops(const std::string& text) {
  const auto fail = [&]() -> std::vector<double> {
    throw Error("--bracket: expected stops such as -6..6:2 or -2,0,2, at most 100 of them, got '" + printable(text) +
                "'");
  };
  std::vector<double> stops;
  const auto number = [&](std::string_view word, double& value) {
    const char* const end = word.data() + word.size();
    return !word.empty() && parse_double(word.data(), end, value) == end && std::abs(value) <= 60;
  };
  const std::string_view all = text;
  if (const std::size_t dots = all.find(".."); dots != std::string_view::npos) {
    const std::size_t colon = std::min(all.find(':', dots), all.size());
    double first = 0, last = 0, step = 1;
    if (!number(all.substr(0, dots), first) || !number(all.substr(dots + 2, colon - dots - 2), last)) return fail();
    if (colon < all.size() && !number(all.substr(colon + 1), step)) return fail();
    if (!(step > 0) || last < first || (last - first) / step > 99) return fail();
    for (int i = 0; first + i * step <= last + 1e-9; ++i) stops.push_back(first + i * step);
    return stops;
  }
  for (std::size_t at = 0; at <= all.size();) {
    const std::size_t end = std::min(all.find(',', at), all.size());
    double value = 0;
    if (!number(all.substr(at, end - at), value) || stops.size() == 100) return fail();
    stops.push_back(value);
    at = end + 1;
  }
  return stops;
}

/// The name of photograph `i`.
std::string numbered(const std::string& pattern, std::size_t i) {
  const std::size_t at = pattern.find("{}");
  return pattern.substr(0, at) + fmt::format("{:02}", i) + pattern.substr(at + 2);
}

using Encoder = std::vector<std::byte> (*)(const DisplayImage&, const WriteOptions&);
Encoder encoder_for(const std::string& path, int bits) {
  const std::string extension = format_extension(path);
  if (extension == ".png") return encode_png;
  if (extension == ".tif" || extension == ".tiff") return encode_tiff;
  if (bits == 8 && (extension == ".jpg" || extension == ".jpeg")) return encode_jpeg;
  throw Error(output_name(path) + ": expected .png, .tif or, for 8 bits, .jpg");
}

int run(const Options& o) {
  const std::vector<double> stops = o.bracket.empty() ? std::vector<double>{o.stops} : bracket_stops(o.bracket);
  for (const std::string& output : o.outputs)
    if (!o.bracket.empty() && output.find("{}") == std::string::npos)
      throw Error("--output: expected a name with {} for the number of the photograph, such as shot_{}.png");
  const double time = o.time.empty() ? 1 : hdr::parse_exposure_time(o.time, "--time");
  check_texts({o.list});
  for (const std::string& output : o.outputs) {
    encoder_for(output, o.bits);
    check_images({output});
  }
  const FractionSink progress = start_work(o.work);
  const Image map = read_image(o.map);
  const hdr::Response response = hdr::response_named(o.response, map.has_colour() ? 3 : 1, 65536);
  std::string list = "# filename exposure_time_s   (pixel = floor(top f(min(1, L t)) + 0.5), f = " + o.response + ")\n";
  for (std::size_t i = 0; i < stops.size(); ++i) {
    hdr::ExposeSettings settings{.exposure = time * std::exp2(stops[i]), .noise = o.noise, .bits = o.bits};
    settings.seed = hash_values(o.seed, i);
    if (i > 0) {
      const auto random = [&](std::uint64_t axis) {
        return 2 * static_cast<double>(hash_to_float(hash_values(o.seed, i, axis))) - 1;
      };
      settings.move = o.shake * Vec2d(random(0), random(1));
      settings.turn = o.turn * random(2) * 0.017453292519943295;
    }
    DisplayImage photograph = hdr::expose(map, response, settings);
    if (progress) progress((static_cast<double>(i) + 0.5) / static_cast<double>(stops.size()));
    photograph.exif = Exif{.exposure_time = settings.exposure};
    for (const std::string& output : o.outputs) {
      const std::string path = o.bracket.empty() ? output : numbered(output, i);
      write_atomically(path, encoder_for(path, o.bits)(photograph, {}));
      print_path(path);
      if (&output != &o.outputs.front()) continue;
      list += std::filesystem::path(path).filename().string() + " ";
      append_number(list, static_cast<float>(settings.exposure));
      list += "\n";
    }
  }
  if (progress) progress(1);
  if (!o.list.empty()) {
    write_atomically(o.list, list);
    print_path(o.list);
  }
  return done;
}

}  // namespace

std::function<int()> add_hdr_expose(CLI::App& app) {
  static Options o;
  app.add_option("map", o.map, "Radiance map")->type_name("FILE")->required();
  add_outputs(app, o.outputs, "Photograph: .png, .tif or .jpg (8 bits); {} is its number in a series")->required();
  app.add_option("--time", o.time, "Exposure; radiance 1 / time just saturates (default 1)")->type_name("T");
  CLI::Option* stops = app.add_option("--stops", o.stops, "Stops above that")->capture_default_str();
  expect_number(stops, {.expected = "a number of stops from -60 to 60", .low = -60, .below = 60.0001});
  app.add_option("--bracket", o.bracket, "A series of stops: -6..6:2 or -2,0,2")->type_name("STOPS")->excludes(stops);
  add_output(app, "--list", o.list, "Write the photographs and their times, for 'lambert hdr merge --list'");
  app.add_option("--response", o.response, "srgb, linear, 'gamma 2.2', film, log, a CSV file")
      ->type_name("WORD")
      ->capture_default_str();
  app.add_option("--bits", o.bits, "8 or 16")->check(CLI::IsMember({8, 16}))->capture_default_str();
  expect_number(app.add_option("--full-well", o.noise.full_well, "Noise: electrons at saturation"),
                {.expected = "a number of electrons from 1", .low = 1});
  expect_number(
      app.add_option("--read-noise", o.noise.read_noise, "Noise: standard deviation of reading, in electrons"),
      {.expected = "a number of electrons from 0"});
  add_seed(app, o.seed, "Of noise and shake");
  expect_number(
      app.add_option("--shake", o.shake, "Camera from the hand: shifts of up to so many pixels after the first"),
      {.expected = "a number of pixels from 0 to 10000", .below = 10001});
  expect_number(app.add_option("--turn", o.turn, "And turns of up to so many degrees"),
                {.expected = "a number of degrees from 0 to 180", .below = 180.001});
  add_work_options(app, o.work);
  return [] { return run(o); };
}

}  // namespace lambert::cli
