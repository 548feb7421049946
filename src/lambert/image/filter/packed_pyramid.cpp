#include "lambert/base/error.h"
#include "lambert/image/filter/pyramid.h"

#include <array>
#include <bit>
#include <string>

namespace lambert {
namespace {

bool is_power_of_two(int n) { return n > 0 && std::has_single_bit(static_cast<unsigned>(n)); }

/// Where the separations of a level of `size` lie in the square of `whole`: what is left for it begins at its corner.
std::array<Vec2i, 3> corners_of(int size, int whole) {
  const int corner = whole - 2 * size;
  return {Vec2i(corner), Vec2i(corner + size, corner), Vec2i(corner, corner + size)};
}

std::string size_text(const Image& image) {
  return std::to_string(image.width()) + "x" + std::to_string(image.height());
}

}  // namespace

Image packed(const Pyramid& pyramid) {
  const Image& base = pyramid.level(0);
  if (base.width() != base.height() || !is_power_of_two(base.width()))
    throw Error("only a square of a power of two can be packed, not " + size_text(base) + "; resize it first");
  if (!base.has_colour()) throw Error("only an image with R, G and B can be packed");
  const int whole = 2 * base.width();
  Image out(whole, whole, {"Y"});
  for (int i = 0; i < pyramid.level_count(); ++i) {
    const Image& level = pyramid.level(i);
    const auto corners = corners_of(level.width(), whole);
    for (int y = 0; y < level.height(); ++y)
      for (int x = 0; x < level.width(); ++x)
        for (std::size_t c = 0; c < 3; ++c) out.at(corners[c].x + x, corners[c].y + y, 0) = level.at(x, y, c);
  }
  return out;
}

Pyramid unpacked(const Image& packed) {
  if (packed.width() != packed.height() || !is_power_of_two(packed.width()) || packed.width() < 2)
    throw Error("a packed mip map is a square of a power of two, not " + size_text(packed));
  std::vector<Image> levels;
  for (int size = packed.width() / 2; size >= 1; size /= 2) {
    Image level(size, size, rgb_channels());
    const auto corners = corners_of(size, packed.width());
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        for (std::size_t c = 0; c < 3; ++c) level.at(x, y, c) = packed.at(corners[c].x + x, corners[c].y + y, 0);
    levels.push_back(std::move(level));
  }
  return Pyramid(std::move(levels));
}

}  // namespace lambert
