#include "vectors.h"

#include "lambert/image/io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

namespace lambert {
namespace {

Image decoded(const std::string& file) { return decode_image(std::as_bytes(std::span(file)), "vector"); }

/// The bytes that the writer makes of an image.
std::string encoded(const Image& image, const std::string& extension, const WriteOptions& options = {}) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("lambert-vector-" + std::to_string(reinterpret_cast<std::uintptr_t>(&image)) + extension);
  write_image(path, image, options);
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(path);
  return bytes;
}

// rows: LF-18
const CheckOf pfm("V-LF-05", [](const Vector& v) {
  const int width = v.input.at("width"), height = v.input.at("height");
  const std::string file = encoded(Image(width, height, rgb_channels()), ".pfm");
  const std::string magic = v.expected.at("header_magic");
  EXPECT_EQ(file.substr(0, magic.size() + 1), magic + "\n");
  std::size_t header = 0;
  for (int lines = 0; lines < 3; ++header) lines += file.at(header) == '\n';
  EXPECT_EQ(file.size() - header, v.expected.at("data_bytes").get<std::size_t>());
  EXPECT_EQ((file.size() - header) / static_cast<std::size_t>(width * height),
            v.expected.at("bytes_per_pixel").get<std::size_t>());
});

/// Radiance's formula, not the printed one, which lacks a division by 256 (E-LF-01).
void check_rgbe(const Vector& v) {
  std::string pixel;
  for (const int byte : v.input.at("rgbe")) pixel += static_cast<char>(byte);
  const Rgb c = decoded("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + pixel).rgb(0, 0);
  for (int i = 0; i < 3; ++i) {
    const double expected = v.expected.at("rgb")[static_cast<std::size_t>(i)];
    EXPECT_NEAR(static_cast<double>(c[i]), expected, v.relative * expected) << v.id;
  }
}
// rows: LF-19
const CheckOf rgbe_large("V-LF-06", check_rgbe);
const CheckOf rgbe_small("V-LF-07", check_rgbe);
const CheckOf rgbe_one("V-LF-08", check_rgbe);
const CheckOf rgbe_black("V-LF-09", check_rgbe);

// rows: LF-20
// Uncompressed, the last bytes of a file are its last row: all of B, all of G, all of R.
const CheckOf halves("V-LF-11", [](const Vector& v) {
  const auto& values = v.input.at("values");
  const int count = static_cast<int>(values.size());
  Image image(count, 1, rgb_channels());
  for (int x = 0; x < count; ++x) image.set_rgb(x, 0, Rgb(values[static_cast<std::size_t>(x)].get<float>()));
  const std::string file = encoded(image, ".exr", {.compression = Compression::none});
  const std::size_t size = static_cast<std::size_t>(count) * v.expected.at("bytes_per_pixel").get<std::size_t>();
  const std::string pixels = file.substr(file.size() - size);
  for (std::size_t i = 0; i < size / 2; ++i) {
    std::uint16_t code = 0;
    std::memcpy(&code, pixels.data() + 2 * i, 2);
    EXPECT_EQ(code, std::stoul(v.expected.at("hex")[i % values.size()].get<std::string>(), nullptr, 16));
  }
  const Image back = decoded(file);
  EXPECT_TRUE(std::ranges::all_of(back.row(0).subspan(0, 3), [](float f) { return f == 1; }));
});

}  // namespace
}  // namespace lambert
