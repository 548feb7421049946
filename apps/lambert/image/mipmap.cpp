#include "filter_options.h"
#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/filter/pyramid.h"
#include "lambert/image/io.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>

namespace lambert::cli {
namespace {

struct Options : FilterOptions {
  std::optional<int> level;
  bool packed = false, unpack = false, all = false;
};

/// Level 0, and to its right the others from the top down.
Image side_by_side(const Pyramid& pyramid) {
  const Image& base = pyramid.level(0);
  const int beside = pyramid.level_count() > 1 ? pyramid.level(1).width() : 0;
  int height = 0;
  for (int i = 1; i < pyramid.level_count(); ++i) height += pyramid.level(i).height();
  Image out(base.width() + beside, std::max(base.height(), height), base.channels());
  const auto put = [&](const Image& level, int x, int y) {
    for (int row = 0; row < level.height(); ++row)
      std::ranges::copy(
          level.row(row),
          out.row(y + row).begin() + static_cast<std::ptrdiff_t>(x) * static_cast<std::ptrdiff_t>(out.channel_count()));
  };
  put(base, 0, 0);
  for (int i = 1, y = 0; i < pyramid.level_count(); y += pyramid.level(i++).height())
    put(pyramid.level(i), base.width(), y);
  return out;
}

/// The run of # in a name becomes the number, with at least as many digits.
std::string numbered(const std::string& name, int number) {
  const std::size_t begin = name.find('#');
  if (begin == std::string::npos) throw Error("--all: expected '#' for the level's number in '" + name + "'");
  const std::size_t end = std::min(name.find_first_not_of('#', begin), name.size());
  std::string digits = std::to_string(number);
  if (digits.size() < end - begin) digits.insert(0, end - begin - digits.size(), '0');
  return name.substr(0, begin) + digits + name.substr(end);
}

int run(const Options& o) {
  if (o.packed + o.all + o.level.has_value() > 1) throw Error("expected one of --packed, --level and --all");
  if (o.all)
    for (const std::string& path : o.outputs) numbered(path, 0);
  const FractionSink progress = start_work(o.work);
  Image image = read_input(o, progress);
  const Pyramid pyramid = o.unpack ? unpacked(image) : Pyramid(std::move(image));
  if (o.level && *o.level >= pyramid.level_count())
    throw Error("--level: " + input_name(o.input) + " has the levels 0 to " +
                std::to_string(pyramid.level_count() - 1) + ", not " + std::to_string(*o.level));
  if (o.all) {
    const auto files = static_cast<double>(o.outputs.size()) * pyramid.level_count();
    const FractionSink writing = part_of(progress, 0.3, 1);
    double written = 0;
    for (const std::string& path : o.outputs)
      for (int i = 0; i < pyramid.level_count(); ++i, ++written)
        write_images({numbered(path, i)}, pyramid.level(i), {},
                     part_of(writing, written / files, (written + 1) / files));
    return done;
  }
  write_outputs(o, o.packed ? packed(pyramid) : o.level ? pyramid.level(*o.level) : side_by_side(pyramid), progress);
  return done;
}

}  // namespace

std::function<int()> add_mipmap(CLI::App& app) {
  static Options o;
  add_image_paths(app, o);
  app.add_flag("--packed", o.packed, "R, G and B separations of all levels in one grey square of twice the size");
  app.add_flag("--unpack", o.unpack, "The input is such a square");
  expect_number(app.add_option("--level", o.level, "Only this level; 0 is the image"),
                {.expected = "a level from 0 on", .low = 0, .below = 1000});
  app.add_flag("--all", o.all, "Every level in its own file, whose number stands for # in OUT");
  app.footer(
      "Without a choice, all levels side by side. Each level has half the size of the one before, downwards, every "
      "pixel\n"
      "counting by its area, in linear light on premultiplied pixels.");
  return [] { return run(o); };
}

}  // namespace lambert::cli
