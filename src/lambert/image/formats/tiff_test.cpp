#include "damage.h"
#include "lambert/image/image_test_tools.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <tiffio.h>

#include <algorithm>

#include <array>
#include <iterator>
#include <optional>

namespace lambert {
namespace {

struct Layout {
  int width = 3, height = 2, channels = 3, bits = 8;
  std::uint16_t photometric = PHOTOMETRIC_RGB, orientation = ORIENTATION_TOPLEFT, plane = PLANARCONFIG_CONTIG;
  std::uint16_t compression = COMPRESSION_NONE, format = SAMPLEFORMAT_UINT;
  std::optional<std::uint16_t> alpha;
  bool tiled = false, big_endian = false;
};

/// Written with libtiff alone; tiles are one of 16x16.
std::string tiff(const Layout& l, const std::string& samples) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.tif").string();
  TIFF* file = TIFFOpen(path.c_str(), l.big_endian ? "wb" : "wl");
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, l.width);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, l.height);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, l.channels);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, l.bits);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, l.photometric);
  TIFFSetField(file, TIFFTAG_ORIENTATION, l.orientation);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, l.plane);
  TIFFSetField(file, TIFFTAG_COMPRESSION, l.compression);
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, l.format);
  if (l.alpha) TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, &*l.alpha);
  const auto width = static_cast<std::size_t>(l.width), height = static_cast<std::size_t>(l.height);
  const auto pixel = static_cast<std::size_t>(l.channels * l.bits / 8);
  if (l.tiled) {
    TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
    std::string tile(16 * 16 * pixel, '\0');
    for (std::size_t y = 0; y < height; ++y)
      tile.replace(16 * pixel * y, width * pixel, samples, y * width * pixel, width * pixel);
    TIFFWriteTile(file, tile.data(), 0, 0, 0, 0);
  } else {
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 1);
    const bool planes = l.plane == PLANARCONFIG_SEPARATE;
    const std::size_t row = planes ? width * static_cast<std::size_t>(l.bits) / 8 : width * pixel;
    for (std::size_t i = 0; i * row < samples.size(); ++i) {
      std::string line = samples.substr(i * row, row);
      TIFFWriteScanline(file, line.data(), static_cast<std::uint32_t>(i % height),
                        static_cast<std::uint16_t>(i / height));
    }
  }
  TIFFClose(file);
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Texels read(const std::string& text) { return decode_tiff(bytes_of(text), "a.tif"); }
std::string codes(const Texels& t) { return {t.bytes.begin(), t.bytes.end()}; }

const std::string rgb = "abcdefghijklmnopqr";  // 3x2 pixels

TEST(Tiff, StripsTilesPlanesAndCompressions) {
  for (const Layout& l : {Layout{}, Layout{.big_endian = true}, Layout{.compression = COMPRESSION_LZW},
                          Layout{.compression = COMPRESSION_ADOBE_DEFLATE}, Layout{.compression = COMPRESSION_PACKBITS},
                          Layout{.tiled = true}, Layout{.tiled = true, .big_endian = true}}) {
    const Texels t = read(tiff(l, rgb));
    EXPECT_EQ(t.channels, 3);
    EXPECT_EQ(codes(t), rgb);
  }
  EXPECT_EQ(codes(read(tiff({.plane = PLANARCONFIG_SEPARATE}, "adgjmpbehknqcfilor"))), rgb);
}

TEST(Tiff, GreyAndItsInverse) {
  EXPECT_EQ(codes(read(tiff({.channels = 1, .photometric = PHOTOMETRIC_MINISBLACK}, "abcdef"))), "abcdef");
  const Texels white = read(tiff({.channels = 1, .photometric = PHOTOMETRIC_MINISWHITE}, std::string(6, '\x10')));
  EXPECT_EQ(codes(white), std::string(6, '\xef'));
}

TEST(Tiff, TilesAndPlanesOfFloatsStayFloats) {
  std::string interleaved, planes;
  for (int i = 0; i < 18; ++i) append(interleaved, 100.5f * static_cast<float>(i));
  for (int i = 0; i < 18; ++i) append(planes, 100.5f * static_cast<float>(i % 6 * 3 + i / 6));
  for (const Texels& t :
       {read(tiff({.bits = 32, .format = SAMPLEFORMAT_IEEEFP, .tiled = true}, interleaved)),
        read(tiff({.bits = 32, .plane = PLANARCONFIG_SEPARATE, .format = SAMPLEFORMAT_IEEEFP}, planes))}) {
    ASSERT_EQ(t.floats.size(), 18u);
    EXPECT_TRUE(t.linear);
    for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(t.floats[i], 100.5f * static_cast<float>(i));
  }
}

// What shines without covering (alpha 0) is kept, too.
TEST(Tiff, FloatsAreWrittenLinearAndPremultiplied) {
  Image image = noise(5, 4, rgba_channels(), 50);
  image.at(0, 0, 3) = 0;
  image.metadata["Artist"] = "someone";
  const TemporaryFolder folder;
  write_image(folder.path() / "a.tif", image, {.depth = Depth::full});
  const Image back = read_image(folder.path() / "a.tif");
  ASSERT_EQ(back.channels(), rgba_channels());
  EXPECT_TRUE(std::ranges::equal(back.pixels(), image.pixels()));
  EXPECT_EQ(back.metadata, image.metadata);
}

TEST(Tiff, SixteenBitsAndFloats) {
  for (const bool big : {false, true}) {
    std::string words, floats;
    for (const int w : {0, 0x1234, 65535, 1, 2, 3}) append(words, static_cast<std::uint16_t>(w));
    for (const float f : {0.0f, -1.5f, 1e9f, 1.0f, 2.0f, 3.0f}) append(floats, f);
    const Layout grey{.channels = 1, .bits = 16, .photometric = PHOTOMETRIC_MINISBLACK, .big_endian = big};
    const Texels t = read(tiff(grey, words));
    ASSERT_EQ(t.floats.size(), 6u);
    EXPECT_EQ(t.floats[1], 0x1234 / 65535.0f);
    EXPECT_EQ(t.floats[2], 1);
    EXPECT_FALSE(t.linear);

    Layout real = grey;
    real.bits = 32, real.format = SAMPLEFORMAT_IEEEFP;
    const Texels f = read(tiff(real, floats));
    EXPECT_EQ(f.floats, (std::vector<float>{0, -1.5f, 1e9f, 1, 2, 3}));
    EXPECT_TRUE(f.linear);
  }
}

TEST(Tiff, Halves) {
  for (const bool big : {false, true}) {
    std::string halves;  // 0, -1.5, 65504, 2^-24, 1, 1/3
    for (const int h : {0x0000, 0xbe00, 0x7bff, 0x0001, 0x3c00, 0x3555}) append(halves, static_cast<std::uint16_t>(h));
    const Texels t = read(tiff({.channels = 1,
                                .bits = 16,
                                .photometric = PHOTOMETRIC_MINISBLACK,
                                .format = SAMPLEFORMAT_IEEEFP,
                                .big_endian = big},
                               halves));
    EXPECT_TRUE(t.linear);
    EXPECT_EQ(t.floats, (std::vector<float>{0, -1.5f, 65504, 0x1p-24f, 1, 0x1.554p-2f}));
  }
}

// Ward, "LogLuv Encoding for Full-Gamut, High-Dynamic Range Images", 1998: steps of 0.3 % in luminance and 1/410 in u',
// v' (32 bits), 1.1 % and coarser ones (24 bits, which end at a luminance of 16). White is (0.9505, 1, 1.0891) in XYZ.
TEST(Tiff, LogLuv) {
  std::string xyz, luminances;
  for (const float y : {0.01f, 1.0f, 15.0f, 0.5f, 2.0f, 12.0f}) {
    append(xyz, 0.9505f * y), append(xyz, y), append(xyz, 1.0891f * y);
    append(luminances, 100 * y);
  }
  for (const auto& [compression, tolerance] : {std::pair{COMPRESSION_SGILOG, 0.03f}, {COMPRESSION_SGILOG24, 0.06f}}) {
    const Texels t = read(tiff({.bits = 32,
                                .photometric = PHOTOMETRIC_LOGLUV,
                                .compression = static_cast<std::uint16_t>(compression),
                                .format = SAMPLEFORMAT_IEEEFP},
                               xyz));
    ASSERT_EQ(t.floats.size(), 18u);
    EXPECT_TRUE(t.linear);
    const std::array<float, 6> expected{0.01f, 1, 15, 0.5f, 2, 12};
    for (std::size_t i = 0; i < 18; ++i) EXPECT_NEAR(t.floats[i] / expected[i / 3], 1, tolerance) << compression << i;
  }
  const Texels grey = read(tiff({.channels = 1,
                                 .bits = 32,
                                 .photometric = PHOTOMETRIC_LOGL,
                                 .compression = COMPRESSION_SGILOG,
                                 .format = SAMPLEFORMAT_IEEEFP},
                                luminances));
  ASSERT_EQ(grey.floats.size(), 6u);
  EXPECT_NEAR(grey.floats[2], 1500, 5);
  EXPECT_NEAR(grey.floats[0], 1, 3e-3f);
}

TEST(Tiff, AlphaIsStraightHoweverItIsStored) {
  const std::string straight = "\xc8\x64\x32\x80", multiplied = "\x64\x32\x19\x80";
  for (const bool tiled : {false, true}) {
    for (const auto& [alpha, stored] : {std::pair<std::uint16_t, std::string>{EXTRASAMPLE_UNASSALPHA, straight},
                                        {EXTRASAMPLE_ASSOCALPHA, multiplied}}) {
      const Texels t = read(tiff({.width = 1, .height = 1, .channels = 4, .alpha = alpha, .tiled = tiled}, stored));
      ASSERT_EQ(t.channels, 4);
      for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(t.bytes[c], static_cast<std::uint8_t>(straight[c]), 1) << tiled << alpha;
      }
    }
  }
}

// TIFF 6.0, tag 274: where row 0 and column 0 are seen.
TEST(Tiff, AllOrientations) {
  const std::array<const char*, 8> seen = {"abc/def",  "cba/fed",  "fed/cba",  "def/abc",
                                           "ad/be/cf", "da/eb/fc", "fc/eb/da", "cf/be/ad"};
  for (std::uint16_t o = ORIENTATION_TOPLEFT; o <= ORIENTATION_LEFTBOT; ++o) {
    for (const bool tiled : {false, true}) {
      const Texels t = read(
          tiff({.channels = 1, .photometric = PHOTOMETRIC_MINISBLACK, .orientation = o, .tiled = tiled}, "abcdef"));
      std::string rows;
      for (int y = 0; y < t.height; ++y) {
        if (y) rows += '/';
        for (int x = 0; x < t.width; ++x)
          rows += static_cast<char>(t.bytes[static_cast<std::size_t>((y * t.width + x) * t.channels)]);
      }
      EXPECT_EQ(rows, seen[o - 1u]) << o << (tiled ? " tiled" : "");
    }
  }
}

TEST(Tiff, SixteenBitsAreWritten) {
  DisplayImage shown{.width = 2, .height = 2, .channels = 4};
  for (int i = 0; i < 16; ++i) shown.words.push_back(static_cast<std::uint16_t>(4000 * i + 7));
  const Texels t = decode_tiff(encode_tiff(shown), "a.tif");
  ASSERT_EQ(t.channels, 4);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(t.floats[i], static_cast<float>(shown.words[i]) / 65535);
}

}  // namespace
}  // namespace lambert
