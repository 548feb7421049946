#include "verb.h"

#include "../command.h"

#include "lambert/base/standard_streams.h"
#include "lambert/image/hdr/range.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {
namespace {

struct Options {
  std::string file;
  bool luminance = false, json = false;
};

int run(const Options& o) {
  const Image map = read_image(o.file);
  const hdr::RadianceRange r = hdr::radiance_range(map, o.luminance ? hdr::RangeOf::luminance : hdr::RangeOf::channels);
  nlohmann::ordered_json j{{"file", input_name(o.file)},
                           {"max", r.max},
                           {"min_positive", r.min_positive},
                           {"ratio", r.ratio()},
                           {"stops", r.stops()},
                           {"values", r.values},
                           {"zero", r.zero},
                           {"negative", r.negative},
                           {"not_finite", r.not_finite}};
  for (const int bits : {8, 12, 16})
    j["sensors"].push_back({{"bits", bits},
                            {"short_by_factor", hdr::shortfall(r.ratio(), bits)},
                            {"short_by_stops", r.stops() - bits},
                            {"step", hdr::step_size(r, bits)}});
  if (o.json) {
    fmt::print("{}\n", j.dump(2));
    return done;
  }
  fmt::print("{}: {:.6g} to {:.6g}, a ratio of {:.6g} to 1, {:.4g} stops\n", input_name(o.file), r.max, r.min_positive,
             r.ratio(), r.stops());
  fmt::print("{} values: {} are 0, {} negative, {} not finite\n", r.values, r.zero, r.negative, r.not_finite);
  for (const int bits : {8, 12, 16}) {
    const double factor = hdr::shortfall(r.ratio(), bits);
    if (factor > 1)
      fmt::print("{} bits fall short by a factor of {:.4g}, {:.3g} stops; one of their equal steps spans {:.4g}\n",
                 bits, factor, r.stops() - bits, hdr::step_size(r, bits));
    else
      fmt::print("{} bits hold it; one of their equal steps spans {:.4g}\n", bits, hdr::step_size(r, bits));
  }
  return done;
}

}  // namespace

std::function<int()> add_hdr_range(CLI::App& app) {
  static Options o;
  app.add_option("file", o.file, "Radiance map")->type_name("FILE")->required();
  app.add_flag("--luminance", o.luminance, "Of the luminance, not of each channel");
  app.add_flag("--json", o.json, "Print JSON");
  return [] { return run(o); };
}

}  // namespace lambert::cli
