#include "comparison.h"

#include "../outputs.h"

#include "lambert/image/compare/false_colour.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lambert::cli {

using namespace compare;

namespace {

const char* word(int status) { return status == same ? "same" : status == warned ? "warning" : "different"; }

nlohmann::ordered_json as_json(const Comparison& c, int status) {
  const Errors& e = c.errors;
  // JSON has no infinities: they are null.
  nlohmann::ordered_json j{{"verdict", word(status)},
                           {"space", c.pair.radiance ? "linear" : "srgb"},
                           {"width", c.pair.a.width()},
                           {"height", c.pair.a.height()},
                           {"channels", c.pair.a.channels()},
                           {"mean_error", e.mean},
                           {"bias", e.bias},
                           {"rms", std::sqrt(e.mse)},
                           {"mse", e.mse},
                           {"rel_mse", e.relative_mse},
                           {"rel_mse_trimmed", e.trimmed_mse},
                           {"psnr", e.psnr(c.peak())},
                           {"max_error", e.largest},
                           {"max_at", {{"x", e.x}, {"y", e.y}, {"channel", e.channel}}},
                           {"incomparable", e.incomparable},
                           {"pixels_over_warn", e.pixels_over(c.o.warn.each)},
                           {"pixels_over_fail", e.pixels_over(c.o.fail.each)}};
  if (c.similarity) j["ssim"] = c.similarity->mean;
  if (c.flip) j["flip"] = c.flip->mean;
  if (c.z)
    j["z_test"] = {{"pixels", c.z->pixels},        {"certain_differences", c.z->certain},
                   {"max_z", c.z->largest},        {"p_max", c.z->p_largest},
                   {"mean_z", c.z->mean_z},        {"p_mean", c.z->p_mean},
                   {"p_chi_square", c.z->p_spread}};
  return j;
}

std::string as_text(const Comparison& c, int status) {
  const Errors& e = c.errors;
  std::string text = fmt::format("{}x{} pixels, {} ({})\n", c.pair.a.width(), c.pair.a.height(),
                                 fmt::join(c.pair.a.channels(), " "), c.pair.radiance ? "linear light" : "sRGB codes");
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<16} {}\n", name, value);
  };
  if (!c.o.layers && c.linear_a.channel("A").has_value() != c.linear_b.channel("A").has_value())
    line("not compared", "A, which one image alone has");
  line("mean error", fmt::format("{:.6g}  (bias {:+.3g})", e.mean, e.bias));
  line("rms error", fmt::format("{:.6g}  (mse {:.6g})", std::sqrt(e.mse), e.mse));
  line("relative mse", fmt::format("{:.6g}  ({:.6g} without the largest 0.1 %)", e.relative_mse, e.trimmed_mse));
  line("psnr", fmt::format("{:.2f} dB", e.psnr(c.peak())));
  line("max error", e.channel.empty() ? "0" : fmt::format("{:.6g} at ({}, {}, {})", e.largest, e.x, e.y, e.channel));
  if (e.incomparable > 0) line("not finite", fmt::format("{} values in one image only", e.incomparable));
  if (c.similarity) line("ssim", fmt::format("{:.5f}", c.similarity->mean));
  if (c.flip) line(c.pair.radiance ? "hdr-flip" : "flip", fmt::format("{:.5f}", c.flip->mean));
  if (c.z) {
    line("z-test",
         fmt::format("p {:.3g} for the largest |z|, {:.2f} at ({}, {})", c.z->p_largest, c.z->largest, c.z->x, c.z->y));
    line("", fmt::format("p {:.3g} for the mean, p {:.3g} for the sum of squares", c.z->p_mean, c.z->p_spread));
    if (c.z->certain > 0) line("", fmt::format("{} pixels without variance differ", c.z->certain));
  }
  const auto over = [&](const char* name, double threshold) {
    const std::size_t count = e.pixels_over(threshold);
    line(name, fmt::format("{} pixels ({:.3g} %) over {:g}", count,
                           100.0 * static_cast<double>(count) / static_cast<double>(e.pixels.size()), threshold));
  };
  if (c.o.metric.empty() || c.o.metric == "all") over("warn", c.o.warn.each), over("fail", c.o.fail.each);
  return text + word(status) + "\n";
}

WriteOptions difference_options(const CompareOptions& o) {
  return {.depth = writes_exr(o.difference) ? Depth::full : Depth::automatic};
}

}  // namespace

void check_pictures(const CompareOptions& o) {
  if (!o.difference.empty()) check_images({o.difference}, difference_options(o));
  if (!o.heat.empty()) check_images({o.heat});
}

void write_pictures(const Comparison& c) {
  const CompareOptions& o = c.o;
  if (!o.difference.empty()) write_image(o.difference, difference(c.pair.a, c.pair.b), difference_options(o));
  if (o.heat.empty()) return;
  Plane plane(c.pair.a.width(), c.pair.a.height());
  double top = 1;
  if (o.heat_of == "flip") {
    plane = c.flip->map;
  } else if (o.heat_of == "ssim") {
    std::transform(c.similarity->map.values.begin(), c.similarity->map.values.end(), plane.values.begin(),
                   [](float s) { return 1 - s; });
  } else if (o.heat_of == "z") {
    std::transform(c.z->map.values.begin(), c.z->map.values.end(), plane.values.begin(),
                   [](float z) { return std::abs(z); });
    top = 5;
  } else {
    plane.values = c.errors.pixels;
    top = std::isfinite(c.errors.largest) ? c.errors.largest : 1;
  }
  write_image(o.heat, false_colour(plane, static_cast<float>(o.heat_top > 0 ? o.heat_top : top)));
}

void print_report(const Comparison& c, int status) {
  if (c.o.json) {
    fmt::print("{}\n", as_json(c, status).dump(2));
  } else if (!c.o.quiet) {
    fmt::print("{}", as_text(c, status));
  }
}

}  // namespace lambert::cli
