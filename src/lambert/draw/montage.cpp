#include "lambert/draw/montage.h"

#include "lambert/base/error.h"
#include "lambert/draw/pixels.h"
#include "lambert/draw/stroke_font.h"

#include <algorithm>
#include <cmath>

namespace lambert::draw {
namespace {

constexpr Colour black{36, 41, 47};

void paste(Image& sheet, const Image& panel, int left, int top) {
  const auto alpha = panel.channel("A");
  for (int y = 0; y < panel.height(); ++y)
    for (int x = 0; x < panel.width(); ++x) {
      const float a = alpha ? panel.at(x, y, *alpha) : 1.0f;
      sheet.set_rgb(left + x, top + y, panel.rgb(x, y) + Rgb(1 - a));
    }
}

}  // namespace

Image montage(std::span<const Panel> panels, const MontageSettings& settings) {
  if (panels.empty()) throw Error("a montage needs a panel");
  const int count = static_cast<int>(panels.size());
  int width = 0, height = 0;
  for (const Panel& panel : panels) {
    width = std::max(width, panel.image.width());
    height = std::max(height, panel.image.height());
  }
  const int columns =
      settings.columns > 0
          ? std::min(settings.columns, count)
          : std::clamp(static_cast<int>(std::lround(std::sqrt(static_cast<double>(count) * height / width * 1.4))), 1,
                       count);
  const int rows = (count + columns - 1) / columns;
  const int caption = static_cast<int>(std::ceil(1.6 * settings.caption_size));
  const int title = settings.title.empty() ? 0 : static_cast<int>(std::ceil(2.2 * settings.caption_size));
  const int cell_width = width + settings.gap, cell_height = height + caption + settings.gap;

  Drawing sheet{.width = static_cast<double>(columns * cell_width + settings.gap),
                .height = static_cast<double>(title + rows * cell_height + settings.gap),
                .marks = {}};
  const auto left = [&](int i) { return settings.gap + i % columns * cell_width; };
  const auto top = [&](int i) { return title + settings.gap + i / columns * cell_height; };
  if (title > 0)
    sheet.marks.emplace_back(Words{.at = {settings.gap, 1.7 * settings.caption_size},
                                   .text = settings.title,
                                   .colour = black,
                                   .size = 1.25 * settings.caption_size});
  for (int i = 0; i < count; ++i) {
    const std::string& name = panels[static_cast<std::size_t>(i)].name;
    const double written = text_width(name, settings.caption_size);
    sheet.marks.emplace_back(Words{.at = {left(i) + 0.5 * width, top(i) + height + 1.15 * settings.caption_size},
                                   .text = name,
                                   .colour = black,
                                   .size = settings.caption_size * std::min(1.0, width / std::max(1.0, written)),
                                   .anchor = Anchor::middle});
  }
  Image image = to_image(rasterised(sheet));
  if (image.width() < columns * cell_width || image.height() < rows * cell_height)
    throw Error("a montage of " + std::to_string(count) + " panels of " + std::to_string(width) + "x" +
                std::to_string(height) + " pixels is too large");
  for (int i = 0; i < count; ++i) {
    const Image& panel = panels[static_cast<std::size_t>(i)].image;
    paste(image, panel, left(i) + (width - panel.width()) / 2, top(i) + (height - panel.height()) / 2);
  }
  return image;
}

Image magnified(const Image& image, int factor) {
  Image large(image.width() * factor, image.height() * factor, image.channels());
  for (int y = 0; y < large.height(); ++y)
    for (int x = 0; x < large.width(); ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c) large.at(x, y, c) = image.at(x / factor, y / factor, c);
  return large;
}

}  // namespace lambert::draw
