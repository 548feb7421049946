#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>
#include <png.h>

namespace lambert {
namespace {

using Codes = std::vector<std::uint8_t>;

struct Layout {
  int width, height, depth, colour_type;
  bool interlaced = false;
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

}  // namespace
}  // namespace lambert
