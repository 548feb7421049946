#include "filter_options.h"
#include "verb.h"

#include "../command.h"
#include "../number_range.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/image/filter/resize.h"
#include "lambert/image/io.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lambert::cli {
namespace {

struct Options : FilterOptions {
  std::string size, filter = "mitchell", radius;
  std::optional<float> scale, sigma;
  bool truncated = false;
};

/// "640x480"; "640x" and "x480" keep the image's proportions.
Vec2i parse_target(const std::string& text, const Window& from) {
  const auto wrong = [&] {
    return Error("--size: expected WxH, Wx or xH with sizes from 1 to 65536 such as 640x480, got '" + printable(text) +
                 "'");
  };
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos || text.size() == 1) throw wrong();
  const auto number = [&](std::size_t begin, std::size_t end) -> std::int64_t {
    if (begin == end) return 0;
    std::int64_t value = 0;
    const char* last = text.data() + end;
    if (parse_int(text.data() + begin, last, value) != last || value < 1 || value > 65536) throw wrong();
    return value;
  };
  const std::int64_t w = number(0, cross), h = number(cross + 1, text.size());
  const auto proportional = [](std::int64_t size, int along, int across) {
    return std::clamp<std::int64_t>(std::llround(static_cast<double>(size) * across / along), 1, 65536);
  };
  return {w ? w : proportional(h, from.height, from.width), h ? h : proportional(w, from.width, from.height)};
}

int run(const Options& o) {
  if (o.size.empty() == !o.scale) throw Error("expected --size WxH or --scale S, one of them");
  ResizeSettings settings{.filter = {.kind = filter_kind(o.filter), .truncated = o.truncated},
                          .edge = edge_mode(o.edge)};
  if (!o.radius.empty()) settings.filter.radius = parse_per_axis("--radius", o.radius, 0.1f, 64);
  if (o.sigma) settings.filter.sigma = *o.sigma;
  const FractionSink progress = start_work(o.work);
  settings.progress = part_of(progress, 0.3, 0.7);
  const Image image = read_input(o, progress);
  const Window from = image.display_window();
  const auto by_scale = [&](int size) {
    return static_cast<int>(std::clamp<std::int64_t>(std::llround(static_cast<double>(*o.scale) * size), 1, 65536));
  };
  const Vec2i size = o.scale ? Vec2i(by_scale(from.width), by_scale(from.height)) : parse_target(o.size, from);
  write_outputs(o, resized(image, size.x, size.y, settings), progress);
  return done;
}

}  // namespace

std::function<int()> add_resize(CLI::App& app) {
  static Options o;
  add_image_paths(app, o);
  app.add_option("--size", o.size, "WxH in pixels; Wx and xH keep the proportions");
  expect_number(app.add_option("--scale", o.scale, "Ratio of the new size to the old one"),
                {.expected = "a ratio above 0 and at most 65536", .low = 1e-9, .below = 65536.1});
  app.add_option("--filter", o.filter, "Kernel: " + listed(filter_names()))->capture_default_str();
  app.add_option("--radius", o.radius, "Half the kernel's width, R or RxR, in pixels of the coarser grid");
  expect_number(app.add_option("--sigma", o.sigma, "Deviation of the gaussian (0.5)"),
                {.expected = "a deviation from 0.01 to 64", .low = 0.01, .below = 64.001});
  app.add_flag("--truncated", o.truncated, "Cut the gaussian off at its radius instead of lowering it to 0 there");
  add_edge_option(app, o);
  app.footer("In linear light on premultiplied pixels. mitchell, catmull-rom and lanczos can overshoot beside edges.");
  return [] { return run(o); };
}

}  // namespace lambert::cli
