#include "verb.h"

#include "../command.h"

#include "lambert/base/number.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/stream.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace lambert::cli {
namespace {

struct Options {
  std::string file;
  bool json = false;
};

/// Of one channel; what is not finite is only counted.
struct Statistics {
  float min = std::numeric_limits<float>::infinity(), max = -min;
  double sum = 0;
  std::size_t finite = 0, nan = 0, infinite = 0;

  void add(float v) {
    if (std::isnan(v)) {
      ++nan;
    } else if (std::isinf(v)) {
      ++infinite;
    } else {
      min = std::min(min, v), max = std::max(max, v);
      sum += static_cast<double>(v);
      ++finite;
    }
  }
};

std::vector<Statistics> statistics_of(ImageReader& reader) {
  const ImageHeader& h = reader.header();
  std::vector<Statistics> all(h.channels.size());
  constexpr int rows = 256;
  std::vector<float> band;
  for (int y = 0; y < h.data.height; y += rows) {
    const int end = std::min(y + rows, h.data.height);
    band.resize(static_cast<std::size_t>(end - y) * h.row_size());
    reader.read(y, end, band);
    for (std::size_t i = 0; i < band.size(); i += all.size())
      for (std::size_t c = 0; c < all.size(); ++c) all[c].add(band[i + c]);
  }
  return all;
}

nlohmann::ordered_json as_json(const Window& w) {
  return {{"x", w.x}, {"y", w.y}, {"width", w.width}, {"height", w.height}};
}
std::string as_text(const Window& w) { return fmt::format("{}x{} at ({}, {})", w.width, w.height, w.x, w.y); }

nlohmann::ordered_json as_json(const std::string& name, const Statistics& s) {
  nlohmann::ordered_json j{{"name", name}, {"min", nullptr}, {"max", nullptr}, {"mean", nullptr}};
  if (s.finite) j["min"] = s.min, j["max"] = s.max, j["mean"] = s.sum / static_cast<double>(s.finite);
  j["nan"] = s.nan, j["infinite"] = s.infinite;
  return j;
}

/// Hours to frames, which a time code stores as decimal digits (SMPTE 12M).
std::string readable(const Attribute& a) {
  std::int64_t bits = 0;
  if (a.type != "timecode" || !parse_int(a.value.data(), a.value.data() + a.value.size(), bits)) return a.value;
  const auto digits = [&](int shift, int tens) {
    return 10 * ((bits >> (shift + 4)) & ((1 << tens) - 1)) + ((bits >> shift) & 15);
  };
  return fmt::format("{:02}:{:02}:{:02}:{:02}", digits(24, 2), digits(16, 3), digits(8, 3), digits(0, 2));
}

/// What a terminal can show; metadata may hold anything.
std::string utf8_or_marks(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

int run(const Options& o) {
  print_image_info(o.file, o.json);
  return done;
}

}  // namespace

void print_image_info(const std::filesystem::path& file, bool json) {
  ImageReader reader(file);
  const ImageHeader& h = reader.header();
  const std::vector<Statistics> statistics = statistics_of(reader);
  if (json) {
    nlohmann::ordered_json j{{"file", input_name(file)},
                             {"width", h.data.width},
                             {"height", h.data.height},
                             {"data_window", as_json(h.data)},
                             {"display_window", as_json(h.display)},
                             {"parts", h.parts},
                             {"channels", nlohmann::json::array()}};
    for (std::size_t c = 0; c < statistics.size(); ++c) j["channels"].push_back(as_json(h.channels[c], statistics[c]));
    j["metadata"] = nlohmann::json::object();
    for (const auto& [name, text] : h.metadata) j["metadata"][name] = text;
    j["attributes"] = nlohmann::json::object();
    for (const auto& [name, a] : h.attributes)
      j["attributes"][name] = {{"type", a.type}, {"value", a.type == "timecode" ? readable(a) : a.value}};
    fmt::print("{}\n", j.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  fmt::print("file      {}\nsize      {}x{}\ndata      {}\ndisplay   {}\n", input_name(file), h.data.width,
             h.data.height, as_text(h.data), as_text(h.display));
  if (h.parts > 1) fmt::print("parts     {}, as layers\n", h.parts);
  for (std::size_t c = 0; c < statistics.size(); ++c) {
    const Statistics& s = statistics[c];
    fmt::print("channel   {}", printable(h.channels[c]));
    if (s.finite) fmt::print(", {:.6g} to {:.6g}, mean {:.6g}", s.min, s.max, s.sum / static_cast<double>(s.finite));
    if (s.nan) fmt::print(", {} not a number", s.nan);
    if (s.infinite) fmt::print(", {} infinite", s.infinite);
    fmt::print("\n");
  }
  for (const auto& [name, a] : h.attributes)
    fmt::print("attribute {} ({}): {}\n", printable(name), printable(a.type), readable(a));
  for (const auto& [name, text] : h.metadata) fmt::print("metadata  {}: {}\n", printable(name), utf8_or_marks(text));
}

std::function<int()> add_image_info(CLI::App& app) {
  static Options options;
  app.add_option("file", options.file, "An image")->required();
  app.add_flag("--json", options.json, "Print JSON");
  app.footer(
      "Size, windows, each channel's least, greatest and mean value, how many of its values are not numbers or\n"
      "infinite (which the others leave out), and what travels with the image.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
