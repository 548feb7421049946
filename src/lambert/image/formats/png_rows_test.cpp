#include "lambert/image/formats/png_rows.h"

#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

namespace lambert {
namespace {

using Codes = std::vector<std::uint8_t>;

struct Kind {
  int depth, colour_type, filters;
  std::size_t channels;
  std::size_t pixel_bytes() const { return channels * static_cast<std::size_t>(depth) / 8; }
};
constexpr int width = 23, height = 40;

/// Smooth with noise, so that libpng's choice among filters takes them all.
Codes codes_of(const Kind& k) {
  Codes codes(width * height * k.pixel_bytes());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const std::size_t y = i / (codes.size() / height);
    codes[i] = static_cast<std::uint8_t>(i % (5 + y) * y + hash_values(i) % (1 + y % 4 * 30));
  }
  return codes;
}

/// By libpng, its image data in several chunks, with a text behind them.
std::string png(const Kind& k, const Codes& codes) {
  std::string out;
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer), end = png_create_info_struct(writer);
  const auto write = [](png_structp p, png_bytep from, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(from), count);
  };
  png_set_write_fn(writer, &out, write, nullptr);
  png_set_IHDR(writer, info, width, height, k.depth, k.colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(writer, 0, k.filters);
  png_set_compression_buffer_size(writer, 500);
  png_write_info(writer, info);
  for (std::size_t y = 0; y < height; ++y) png_write_row(writer, codes.data() + y * width * k.pixel_bytes());
  char key[] = "seed", value[] = "42";
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_NONE, text.key = key, text.text = value, text.text_length = 2;
  png_set_text(writer, end, &text, 1);
  png_write_end(writer, end);
  png_destroy_info_struct(writer, &end);
  png_destroy_write_struct(&writer, &info);
  return out;
}

std::size_t image_data(const std::string& file) { return file.find("IDAT") - 4; }
std::optional<PngRows> read(const std::string& file, const Kind& k, std::size_t rows = height) {
  return png_rows(bytes_of(file), image_data(file), width * k.pixel_bytes(), rows, k.pixel_bytes());
}

/// One chunk of image data in place of all of them, with its checksum.
std::string with_image_data(const std::string& file, const std::string& data) {
  const std::string chunk = "IDAT" + data;
  const auto number = [](std::size_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
    return bytes;
  };
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), static_cast<uInt>(chunk.size()));
  return file.substr(0, image_data(file)) + number(data.size()) + chunk + number(sum) +
         file.substr(file.find("tEXt") - 4);
}

std::string deflated(const std::string& rows) {
  std::string data(compressBound(rows.size()), '\0');
  uLongf size = data.size();
  compress(reinterpret_cast<Bytef*>(data.data()), &size, reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  return data.substr(0, size);
}

TEST(PngRows, EveryFilterAndPixelIsWhatWasWritten) {
  for (const int depth : {8, 16})
    for (const auto& [type, channels] : {std::pair(PNG_COLOR_TYPE_GRAY, 1u), std::pair(PNG_COLOR_TYPE_GRAY_ALPHA, 2u),
                                         std::pair(PNG_COLOR_TYPE_RGB, 3u), std::pair(PNG_COLOR_TYPE_RGBA, 4u)})
      for (const int filters :
           {PNG_FILTER_NONE, PNG_FILTER_SUB, PNG_FILTER_UP, PNG_FILTER_AVG, PNG_FILTER_PAETH, PNG_ALL_FILTERS}) {
        SCOPED_TRACE(std::to_string(depth) + " bits, " + std::to_string(channels) + " channels, filters " +
                     std::to_string(filters));
        const Kind kind{depth, type, filters, channels};
        const Codes codes = codes_of(kind);
        const std::string file = png(kind, codes);
        const auto rows = read(file, kind);
        ASSERT_TRUE(rows);
        EXPECT_EQ(rows->pixels, codes);
        EXPECT_EQ(rows->end, file.find("tEXt") - 4);
        DisplayNotes notes;
        decode_png(bytes_of(file), "a.png", &notes);
        EXPECT_EQ(notes.metadata.at("seed"), "42") << "libpng goes on behind the rows";
      }
}

constexpr Kind colour{8, PNG_COLOR_TYPE_RGB, PNG_ALL_FILTERS, 3};

TEST(PngRows, DamageIsLeftToLibpng) {
  const std::string file = png(colour, codes_of(colour));
  std::string wrong = file;
  wrong[image_data(file) + 700] = static_cast<char>(wrong[image_data(file) + 700] ^ 1);
  EXPECT_FALSE(read(wrong, colour)) << "a checksum";
  EXPECT_FALSE(read(file.substr(0, image_data(file) + 700), colour)) << "cut off";
  EXPECT_FALSE(read(file, colour, height + 1)) << "rows are missing";
  EXPECT_FALSE(read(file, colour, height - 1)) << "more than the rows";
  const std::string seven = with_image_data(file, deflated(std::string((width * 3 + 1) * height, 7)));
  EXPECT_FALSE(read(seven, colour)) << "an unknown filter";
  EXPECT_EQ(error_of([&] { decode_png(bytes_of(seven), "a.png"); }), "a.png: bad adaptive filter value");
}

// As libpng does: what it tells apart from damage.
TEST(PngRows, SuperfluousDataAreNoError) {
  const std::string file = png(colour, codes_of(colour));
  const std::string more = deflated(std::string((width * 3 + 1) * (height + 2), 0));
  EXPECT_EQ(decode_png(bytes_of(with_image_data(file, more)), "a.png").bytes, Codes(width * height * 3));
}

// The checksums are right, so that the damage reaches what they guard.
TEST(PngRows, DamagedDataAreReadOrRefused) {
  const std::string file = png(colour, codes_of(colour)), rows((width * 3 + 1) * height, 4);
  const std::string data = deflated(rows);
  expect_survives_damage(
      data, 500, [&](const std::string& damaged) { decode_png(bytes_of(with_image_data(file, damaged)), "a.png"); });
}

}  // namespace
}  // namespace lambert
