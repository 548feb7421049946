#include "damage.h"
#include "lambert/image/colour.h"
#include "lambert/image/image_test_tools.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

namespace lambert {
namespace {

using Codes = std::vector<std::uint8_t>;

struct Layout {
  int width, height, depth, colour_type;
  bool interlaced = false;
  double gamma = 0;   // none
  bool wide = false;  // the primaries of DCI-P3
};

/// Written with libpng alone. Two palette colours; the second one is transparent by half.
std::string png(const Layout& l, const Codes& rows) {
  std::string out;
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  const auto write = [](png_structp p, png_bytep from, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(from), count);
  };
  png_set_write_fn(writer, &out, write, nullptr);
  png_set_IHDR(writer, info, static_cast<png_uint_32>(l.width), static_cast<png_uint_32>(l.height), l.depth,
               l.colour_type, l.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (l.colour_type == PNG_COLOR_TYPE_PALETTE) {
    const png_color palette[] = {{10, 20, 30}, {200, 100, 50}};
    const png_byte alpha[] = {255, 128};
    png_set_PLTE(writer, info, palette, 2);
    png_set_tRNS(writer, info, alpha, 2, nullptr);
  }
  if (l.gamma > 0) png_set_gAMA(writer, info, l.gamma);
  if (l.wide) png_set_cHRM(writer, info, 0.3127, 0.329, 0.68, 0.32, 0.265, 0.69, 0.15, 0.06);
  png_write_info(writer, info);
  const std::size_t stride = rows.size() / static_cast<std::size_t>(l.height);
  std::vector<png_bytep> pointers;
  for (int y = 0; y < l.height; ++y)
    pointers.push_back(const_cast<png_bytep>(rows.data()) + static_cast<std::size_t>(y) * stride);
  png_write_image(writer, pointers.data());
  png_write_end(writer, nullptr);
  png_destroy_write_struct(&writer, &info);
  return out;
}

Texels read(const std::string& text) { return decode_png(bytes_of(text), "a.png"); }

TEST(Png, EightBitsOfEveryKind) {
  const std::pair<int, int> kinds[] = {
      {PNG_COLOR_TYPE_GRAY, 1}, {PNG_COLOR_TYPE_GRAY_ALPHA, 2}, {PNG_COLOR_TYPE_RGB, 3}, {PNG_COLOR_TYPE_RGBA, 4}};
  for (const auto& [kind, channels] : kinds) {
    Codes codes(static_cast<std::size_t>(5 * 3 * channels));
    for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<std::uint8_t>(i * 37);
    for (const bool interlaced : {false, true}) {
      const Texels t = read(png({5, 3, 8, kind, interlaced}, codes));
      EXPECT_EQ(t.width, 5);
      EXPECT_EQ(t.height, 3);
      EXPECT_EQ(t.channels, channels);
      EXPECT_EQ(t.bytes, codes) << "neither decoded nor multiplied";
      EXPECT_FALSE(t.linear);
    }
    DisplayImage shown{.width = 5, .height = 3, .channels = channels, .bytes = codes};
    EXPECT_EQ(decode_png(encode_png(shown), "a.png").bytes, codes);
  }
}

TEST(Png, SixteenBitsAreCodesOver65535) {
  const Texels t = read(png({2, 1, 16, PNG_COLOR_TYPE_GRAY}, {0x12, 0x34, 0xff, 0xff}));
  EXPECT_TRUE(t.bytes.empty());
  EXPECT_EQ(t.floats, (std::vector<float>{0x1234 / 65535.0f, 1}));
  EXPECT_FALSE(t.linear);
}

TEST(Png, PalettesAndSmallDepthsAreExpanded) {
  const Texels palette = read(png({3, 1, 8, PNG_COLOR_TYPE_PALETTE}, {0, 1, 0}));
  EXPECT_EQ(palette.channels, 4);
  EXPECT_EQ(palette.bytes, (Codes{10, 20, 30, 255, 200, 100, 50, 128, 10, 20, 30, 255}));
  EXPECT_EQ(read(png({3, 1, 1, PNG_COLOR_TYPE_GRAY}, {0b01000000})).bytes, (Codes{0, 255, 0}));
  EXPECT_EQ(read(png({2, 1, 4, PNG_COLOR_TYPE_GRAY}, {0x3f})).bytes, (Codes{0x33, 0xff}));
}

TEST(Png, MetadataIsText) {
  const DisplayImage shown{.width = 1, .height = 1, .channels = 1, .bytes = {7}, .metadata = {{"seed", "42"}}};
  EXPECT_NE(text_of(encode_png(shown)).find(std::string("tEXtseed\0", 9) + "42"), std::string::npos);
}

TEST(Png, AWrongChecksumIsAnError) {
  std::string text = png({5, 3, 8, PNG_COLOR_TYPE_GRAY}, Codes(15, 9));
  text[text.size() - 20] = static_cast<char>(text[text.size() - 20] ^ 1);
  EXPECT_EQ(error_of([&] { read(text); }).rfind("a.png: ", 0), 0u);
}

/// With one more chunk, name and content, behind the header.
std::string with_chunk(std::string file, const std::string& chunk) {
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), static_cast<uInt>(chunk.size()));
  std::string whole;
  for (const auto number : {static_cast<std::uint32_t>(chunk.size() - 4), static_cast<std::uint32_t>(sum)}) {
    for (int shift = 24; shift >= 0; shift -= 8) whole += static_cast<char>(number >> shift);
    if (whole.size() == 4) whole += chunk;
  }
  return file.insert(33, whole);
}

TEST(Png, GammaAndPrimariesAreHonouredByImagesAndNotByTextures) {
  const auto image = [](Layout l) {
    l.width = l.height = 1, l.depth = 8, l.colour_type = PNG_COLOR_TYPE_RGB;
    return decode_image(bytes_of(png(l, {128, 0, 0})), "a.png").rgb(0, 0);
  };
  const float code = 128 / 255.0f;
  EXPECT_NEAR(image({}).r, 0.2158605f, 1e-6f);
  EXPECT_NEAR(image({.gamma = 1}).r, code, 1e-6f);
  EXPECT_NEAR(image({.gamma = 0.5}).r, code * code, 1e-5f);
  EXPECT_NEAR(image({.gamma = 0.45455}).r, 0.2158605f, 1e-6f) << "sRGB is meant";
  const std::string both =
      with_chunk(png({1, 1, 8, PNG_COLOR_TYPE_RGB, false, 1}, {128, 0, 0}), std::string("sRGB\0", 5));
  EXPECT_NEAR(decode_image(bytes_of(both), "a.png").rgb(0, 0).r, 0.2158605f, 1e-6f) << "sRGB outdoes gamma";
  // The red of P3 in Rec. 709.
  const Rgb wide = image({.gamma = 1, .wide = true});
  EXPECT_NEAR(wide.r / code, 1.2249f, 2e-3f);
  EXPECT_NEAR(wide.g / code, -0.0420f, 2e-3f);
  EXPECT_EQ(read(png({1, 1, 8, PNG_COLOR_TYPE_RGB, false, 1, true}, {128, 0, 0})).bytes, (Codes{128, 0, 0}));
}

TEST(Png, SixteenBitsAndTextComeBack) {
  Image image = noise(5, 4, rgba_channels());
  for (int i = 0; i < 20; ++i) image.at(i % 5, i / 5, 3) = 1;
  image.metadata["Comment"] = "hello";
  const TemporaryFolder folder;
  write_image(folder.path() / "a.png", image, {.depth = Depth::bits16});
  const Image back = read_image(folder.path() / "a.png");
  EXPECT_EQ(back.metadata, image.metadata);
  for (std::size_t i = 0; i < image.pixels().size(); ++i)
    EXPECT_NEAR(srgb_encode(back.pixels()[i]), srgb_encode(image.pixels()[i]), 0.51f / 65535 + 1e-6f);
}

TEST(Png, ExifTurnsImages) {
  // 2x1, seen turned a quarter clockwise: the left pixel on top.
  const std::string exif("II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0", 26);
  const std::string file = with_chunk(png({2, 1, 8, PNG_COLOR_TYPE_GRAY}, {10, 250}), "eXIf" + exif);
  const Image image = decode_image(bytes_of(file), "a.png");
  ASSERT_EQ(image.width(), 1);
  ASSERT_EQ(image.height(), 2);
  EXPECT_LT(image.at(0, 0, 0), image.at(0, 1, 0));
  EXPECT_EQ(read(file).width, 2) << "textures stay as they are";
}

// A smooth picture with noise, and a tile of noise over and over, which only a search for all that repeats makes small.
TEST(Png, FilesAreAboutAsSmallAsLibpngsOwn) {
  const int width = 400, height = 300;
  DisplayImage smooth{.width = width, .height = height, .channels = 3}, tiles = smooth;
  std::uint64_t seed = 0;
  const auto random = [&] { return static_cast<int>(hash_values(++seed) % 8); };
  for (int y = 0; y < height; ++y)
    for (int i = 0; i < 3 * width; ++i) {
      smooth.bytes.push_back(static_cast<std::uint8_t>((i / 9 + y / 4 + random() / 4) % 256));
      tiles.bytes.push_back(static_cast<std::uint8_t>(hash_values(y % 10, i % 96) % 256));
    }
  const auto libpngs = [&](const DisplayImage& image) {
    return static_cast<double>(png({width, height, 8, PNG_COLOR_TYPE_RGB}, image.bytes).size());
  };
  EXPECT_LT(static_cast<double>(encode_png(smooth).size()), 1.04 * libpngs(smooth));
  EXPECT_LT(static_cast<double>(encode_png(tiles).size()), 1.04 * libpngs(tiles));
  EXPECT_LT(encode_png(tiles).size(), tiles.bytes.size() / 20);
}

}  // namespace
}  // namespace lambert
