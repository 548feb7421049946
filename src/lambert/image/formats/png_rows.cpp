#include "lambert/image/formats/png_rows.h"

#include <libdeflate.h>

#include <cstring>
#include <memory>
#include <utility>

namespace lambert {
namespace {

std::size_t big_endian(Bytes bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::size_t>(bytes[at + i]);
  return value;
}

/// The contents of all IDAT chunks from `at` on, which comes to be where another chunk begins. Nothing where a checksum
/// is wrong or the file ends.
std::optional<std::vector<std::byte>> image_data(Bytes file, std::size_t& at) {
  constexpr std::size_t around = 12;  // size, name and checksum
  std::vector<std::byte> data;
  data.reserve(file.size() - at);
  while (file.size() - at >= around) {
    if (std::memcmp(&file[at + 4], "IDAT", 4) != 0) return data;
    const std::size_t size = big_endian(file, at);
    if (size > file.size() - at - around) break;
    const Bytes checked = file.subspan(at + 4, size + 4), content = checked.subspan(4);
    if (libdeflate_crc32(0, checked.data(), checked.size()) != big_endian(file, at + 8 + size)) break;
    data.insert(data.end(), content.begin(), content.end());
    at += size + around;
  }
  return std::nullopt;
}

/// The bytes of one pixel as numbers, and what follows: always eight bytes are read and written.
using Pixel = std::int16_t __attribute__((vector_size(16)));
using Eight = std::uint8_t __attribute__((vector_size(8)));
constexpr std::size_t behind = sizeof(Eight);

Pixel load(const std::uint8_t* from) {
  Eight bytes;
  std::memcpy(&bytes, from, sizeof bytes);
  return __builtin_convertvector(bytes, Pixel);
}
void store(const Pixel& pixel, std::uint8_t* to) {
  const auto bytes = __builtin_convertvector(pixel, Eight);
  std::memcpy(to, &bytes, sizeof bytes);
}
Pixel least(const Pixel& a, const Pixel& b) { return a < b ? a : b; }
Pixel magnitude(const Pixel& a) { return a < 0 ? -a : a; }

/// Of left, above and left above the one nearest to left + above - left above; if in doubt the one named first.
Pixel paeth(const Pixel& left, const Pixel& above, const Pixel& left_above) {
  const Pixel by_left = above - left_above, by_above = left - left_above;
  const Pixel to_left = magnitude(by_left), to_above = magnitude(by_above), to_corner = magnitude(by_left + by_above);
  const Pixel nearer = to_above < to_left ? above : left;
  return to_corner < least(to_left, to_above) ? left_above : nearer;
}

/// Section 9 of the PNG specification. `row` and `above` begin with a pixel of zeros; `n` is the size of a pixel.
template <std::size_t n>
void undo_filter(int filter, const std::uint8_t* from, const std::uint8_t* above, std::uint8_t* row,
                 std::size_t count) {
  const auto undo = [&](const auto& predicted) {
    Pixel left{}, left_above{};
    for (std::size_t i = 0; i < count; i += n) {
      const Pixel up = load(above + n + i);
      left = (load(from + i) + predicted(left, up, left_above)) & 255;
      left_above = up;
      store(left, row + n + i);
    }
  };
  switch (filter) {
    case 0: std::memcpy(row + n, from, count); break;
    case 1: undo([](const Pixel& left, const Pixel&, const Pixel&) { return left; }); break;
    case 2:
      for (std::size_t i = 0; i < count; ++i) row[n + i] = static_cast<std::uint8_t>(from[i] + above[n + i]);
      break;
    case 3: undo([](const Pixel& left, const Pixel& up, const Pixel&) { return (left + up) >> 1; }); break;
    default: undo(paeth); break;
  }
}

/// In place: rows move up by the bytes that name their filters. False for an unknown filter.
template <std::size_t n>
bool undo_filters(std::uint8_t* pixels, std::size_t row_bytes, std::size_t height) {
  std::vector<std::uint8_t> row(n + row_bytes + behind), above(row.size());
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* const from = pixels + y * (row_bytes + 1);
    if (*from > 4) return false;
    undo_filter<n>(*from, from + 1, above.data(), row.data(), row_bytes);
    std::memcpy(pixels + y * row_bytes, row.data() + n, row_bytes);
    std::swap(row, above);
  }
  return true;
}

}  // namespace

std::optional<PngRows> png_rows(Bytes file, std::size_t begin, std::size_t row_bytes, std::size_t height,
                                std::size_t pixel_bytes) {
  PngRows rows{.end = begin};
  const auto data = image_data(file, rows.end);
  if (!data) return std::nullopt;
  const std::size_t filtered = (row_bytes + 1) * height;
  rows.pixels.resize(filtered + behind);
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> inflate(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!inflate || libdeflate_zlib_decompress(inflate.get(), data->data(), data->size(), rows.pixels.data(), filtered,
                                             nullptr) != LIBDEFLATE_SUCCESS)
    return std::nullopt;
  const auto undo = [&] {
    switch (pixel_bytes) {
      case 1: return undo_filters<1>;
      case 2: return undo_filters<2>;
      case 3: return undo_filters<3>;
      case 4: return undo_filters<4>;
      case 6: return undo_filters<6>;
      case 8: return undo_filters<8>;
      default: return static_cast<decltype(&undo_filters<1>)>(nullptr);
    }
  }();
  if (!undo || !undo(rows.pixels.data(), row_bytes, height)) return std::nullopt;
  rows.pixels.resize(row_bytes * height);
  return rows;
}

}  // namespace lambert
