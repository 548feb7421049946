#include "lambert/draw/pixels.h"

#include "lambert/draw/outline.h"
#include "lambert/draw/stroke_font.h"
#include "lambert/image/colour.h"
#include "lambert/polygon/scan_fill.h"

#include <algorithm>
#include <cmath>

namespace lambert::draw {

using namespace polygon;
namespace {

constexpr int samples = 4;  ///< a side of a pixel
constexpr Colour white{255, 255, 255};

bool is_finite(const Rings& rings) {
  for (const Ring& ring : rings)
    for (const Vec2d p : ring)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
  return true;
}

class Canvas {
 public:
  Canvas(double width, double height)
      : width_(std::clamp(static_cast<int>(std::ceil(width)), 1, 8192)),
        height_(std::clamp(static_cast<int>(std::ceil(height)), 1, 8192)),
        rgb_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3, 255),
        covered_(static_cast<std::size_t>(width_)) {}

  Pixels take() { return {width_, height_, std::move(rgb_)}; }

  void operator()(const Fill& fill) { paint(fill.rings, fill.rule, fill.colour); }
  void operator()(const Stroke& stroke) { paint(outline(stroke), FillRule::non_zero, stroke.colour); }
  void operator()(const Disk& disk) { paint({circle(disk.centre, disk.radius)}, FillRule::non_zero, disk.colour); }
  void operator()(const Words& words) {
    Vec2d at = words.at;
    if (words.anchor != Anchor::start)
      at.x -= text_width(words.text, words.size) * (words.anchor == Anchor::middle ? 0.5 : 1.0);
    const std::vector<Ring> strokes = text_strokes(words.text, at, words.size);
    const auto draw = [&](double width, const Colour& colour) {
      Rings all;
      for (const Ring& stroke : strokes)
        for (Ring& ring : outline({.points = stroke, .closed = false, .colour = {}, .width = width}))
          all.push_back(std::move(ring));
      paint(all, FillRule::non_zero, colour);
    };
    if (words.halo) draw(words.size / 10 + 3, white);
    draw(words.size / 10, words.colour);
  }

 private:
  void paint(Rings rings, FillRule rule, const Colour& colour) {
    if (!is_finite(rings)) return;
    for (Ring& ring : rings)
      for (Vec2d& p : ring) p *= samples;
    const PixelWindow all{0, samples * width_, 0, samples * height_}, box = pixel_window(rings);
    const PixelWindow window{std::max(all.x_begin, box.x_begin), std::min(all.x_end, box.x_end),
                             std::max(all.y_begin, box.y_begin), std::min(all.y_end, box.y_end)};
    if (window.x_begin >= window.x_end || window.y_begin >= window.y_end) return;
    int row = window.y_begin / samples;
    for_each_span(rings, rule, window, [&](int y, int begin, int end) {
      if (y / samples != row) {
        blend(row, window, colour);
        row = y / samples;
      }
      for (int x = begin; x < end;) {
        const int next = std::min(end, (x / samples + 1) * samples);
        covered_[static_cast<std::size_t>(x / samples)] += next - x;
        x = next;
      }
    });
    blend(row, window, colour);
  }

  /// Mixes the colour into a row by the samples counted, and forgets them.
  void blend(int row, const PixelWindow& window, const Colour& colour) {
    const std::uint8_t channels[] = {colour.red, colour.green, colour.blue};
    for (int x = window.x_begin / samples; x <= (window.x_end - 1) / samples; ++x) {
      int& count = covered_[static_cast<std::size_t>(x)];
      if (count == 0) continue;
      const double weight = colour.opacity * count / (samples * samples);
      count = 0;
      const auto row_start = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
      std::uint8_t* pixel = &rgb_[(row_start + static_cast<std::size_t>(x)) * 3];
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::lround(pixel[c] + weight * (channels[c] - pixel[c])));
    }
  }

  int width_, height_;
  std::vector<std::uint8_t> rgb_;
  std::vector<int> covered_;  // samples in the row of pixels at hand
};

}  // namespace

Pixels rasterised(const Drawing& drawing) {
  Canvas canvas(drawing.width, drawing.height);
  for (const auto& mark : drawing.marks) std::visit([&](const auto& m) { canvas(m); }, mark);
  return canvas.take();
}

Image to_image(const Pixels& pixels) {
  Image image(pixels.width, pixels.height, rgb_channels());
  std::transform(pixels.rgb.begin(), pixels.rgb.end(), image.pixels().begin(), srgb_decode8);
  return image;
}

}  // namespace lambert::draw
