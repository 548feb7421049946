#include "lambert/draw/drawing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace lambert::draw {
namespace {

Colour from_hsl(double hue, double saturation, double lightness) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue / 30, 12.0);
    const double a = saturation * std::min(lightness, 1 - lightness);
    const double value = lightness - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
    return static_cast<std::uint8_t>(std::lround(255 * value));
  };
  return {channel(0), channel(8), channel(4)};
}

/// Steps of the golden angle never come close to an earlier hue.
double hue(std::size_t index) { return std::fmod(212 + 137.50776405 * static_cast<double>(index % 360), 360.0); }

}  // namespace

Drawing moved(Drawing drawing, Vec2d offset) {
  const auto move = [&](Ring& points) {
    for (Vec2d& p : points) p += offset;
  };
  for (auto& mark : drawing.marks) {
    if (auto* fill = std::get_if<Fill>(&mark)) std::for_each(fill->rings.begin(), fill->rings.end(), move);
    if (auto* stroke = std::get_if<Stroke>(&mark)) move(stroke->points);
    if (auto* disk = std::get_if<Disk>(&mark)) disk->centre += offset;
    if (auto* words = std::get_if<Words>(&mark)) words->at += offset;
  }
  return drawing;
}

Drawing side_by_side(const std::vector<Drawing>& drawings, int columns) {
  Vec2d cell(0);
  for (const Drawing& d : drawings) cell = glm::max(cell, Vec2d(d.width, d.height));
  const int count = static_cast<int>(drawings.size());
  columns = std::clamp(columns, 1, std::max(1, count));
  Drawing sheet{
      .width = cell.x * std::min(columns, count), .height = cell.y * ((count + columns - 1) / columns), .marks = {}};
  for (int i = 0; i < count; ++i) {
    Drawing placed = moved(drawings[static_cast<std::size_t>(i)], cell * Vec2d(i % columns, i / columns));
    std::move(placed.marks.begin(), placed.marks.end(), std::back_inserter(sheet.marks));
  }
  return sheet;
}

std::string hex(const Colour& colour) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t c : {colour.red, colour.green, colour.blue}) {
    text += digits[c / 16];
    text += digits[c % 16];
  }
  return text;
}

Colour pastel(std::size_t index) { return from_hsl(hue(index), 0.72, 0.84); }
Colour strong(std::size_t index) { return from_hsl(hue(index), 0.75, 0.40); }

}  // namespace lambert::draw
