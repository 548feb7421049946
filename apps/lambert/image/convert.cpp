#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"
#include "../print_path.h"
#include "../work.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/channels.h"
#include "lambert/image/stream.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lambert::cli {
namespace {

struct Options {
  std::string input, layer, crop_to;
  std::vector<std::string> outputs, channels;
  std::string depth = "auto", compression = "zip";
  std::optional<int> quality;
  double exposure = 0;
  WorkOptions work;
};

/// The rows [y0, y1) of `window`, which need not lie in the data window.
Image rows_of(ImageReader& reader, const Window& window, int y0, int y1) {
  const Window band{window.x, window.y + y0, window.width, y1 - y0};
  const Window& data = reader.header().data;
  const int first = std::clamp(band.y - data.y, 0, data.height),
            last = std::clamp(band.y + band.height - data.y, first, data.height);
  if (first < last) return cut(reader.band(first, last), band);
  ImageHeader empty = reader.header();
  empty.data = band;
  return image_of(empty);
}

int run(const Options& o) {
  const WriteOptions options{
      .depth = parse_depth(o.depth), .compression = parse_compression(o.compression), .quality = o.quality};
  check_images(o.outputs, options);
  const FractionSink progress = start_work(o.work);
  ImageReader reader(o.input);
  ImageHeader header = reader.header();
  if (header.parts > 1)
    log::info(fmt::format("{}: its {} parts become layers of one, on one window; of their metadata one's is kept",
                          input_name(o.input), header.parts));
  if (o.crop_to == "display") header.data = header.display;
  if (o.crop_to == "data") header.display = header.data;

  const std::vector<ChannelChoice> choices = chosen_channels(header.channels, o.layer, o.channels, input_name(o.input));
  const float factor = static_cast<float>(std::exp2(o.exposure));
  const std::vector<bool> light = light_channels(header.channels);
  const Window window = header.data;
  header.channels.clear();
  for (const ChannelChoice& c : choices) header.channels.push_back(c.name);
  std::vector<ImageWriter> writers;
  for (const std::string& path : o.outputs) writers.emplace_back(path, header, options);
  constexpr int rows = 256;
  for (int y = 0; y < window.height; y += rows) {
    const Image band = rows_of(reader, window, y, std::min(y + rows, window.height));
    std::vector<float> chosen(static_cast<std::size_t>(band.height()) * header.row_size());
    const std::size_t count = choices.size(), stored = band.channel_count();
    for (std::size_t c = 0; c < count; ++c) {
      const float scale = light[choices[c].stored] ? factor : 1;
      const float* from = band.pixels().data() + choices[c].stored;
      for (std::size_t i = 0; i < chosen.size() / count; ++i) chosen[i * count + c] = scale * from[i * stored];
    }
    for (ImageWriter& writer : writers) writer.write(chosen);
    if (progress) progress(0.9 * (y + band.height()) / window.height);
  }
  for (std::size_t i = 0; i < writers.size(); ++i) {
    writers[i].close();
    print_path(o.outputs[i]);
  }
  if (progress) progress(1);
  return done;
}

}  // namespace

std::function<int()> add_image_convert(CLI::App& app) {
  static Options options;
  app.add_option("input", options.input, "An image")->required();
  add_outputs(app, options.outputs, "Where to; its extension says the format")->required();
  app.add_option("--depth", options.depth, "auto, 8, 16, half or float, of those that the format has")
      ->check(CLI::IsMember(depth_words()))
      ->capture_default_str();
  app.add_option("--compression", options.compression, "Of OpenEXR files")
      ->check(CLI::IsMember(compression_words()))
      ->capture_default_str();
  app.add_option("--channels", options.channels, "Only these, in this order: R,G,B or new=old")->delimiter(',');
  app.add_option("--layer", options.layer, "Only the channels of this layer, without its name");
  expect_number(
      app.add_option("--exposure", options.exposure, "Doubles light this many times; not alpha, depth and such")
          ->capture_default_str(),
      {.expected = "a number of stops from -1000 to 1000", .low = -1000, .below = 1000.0001});
  app.add_option("--crop-to", options.crop_to,
                 "display: all of what is shown and nothing else; data: show what there is, whatever was shown")
      ->check(CLI::IsMember({"display", "data"}));
  expect_number(app.add_option("--quality", options.quality, "Of JPEG (92 without it) and WebP (lossless without it)"),
                whole_number(1, 100));
  add_work_options(app, options.work);
  app.footer(
      "OpenEXR keeps all channels, windows and attributes; other formats hold the display window, and its colours.\n"
      "Display formats are clipped to [0, 1] and get sRGB's curve, but TIFF with --depth float, which stays linear.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
