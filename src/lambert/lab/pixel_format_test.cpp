#include "lambert/lab/pixel_format.h"

#include "lambert/image/colour.h"
#include "lambert/lab/demo_test_tools.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::lab {
namespace {

enum : std::size_t { png8, png16, rgbe, half, full };

/// Of [2^octave, 2^(octave+1)).
double octave_error(std::size_t format, int octave, float beside = 1) {
  return octave_errors(pixel_formats()[format], octave, octave + 1, beside).at(0).error;
}

// rows: LF-18 LF-19 LF-20
TEST(PixelFormat, FilesGrowByTheBytesOfAPixel) {
  // Under eight pixels a row RGBE has no runs.
  for (const std::size_t i : {rgbe, half, full}) {
    const PixelFormat& format = pixel_formats()[i];
    WriteOptions options = format.options;
    options.compression = Compression::none;
    const auto size = [&](int width) {
      return encode_image(format.file, Image(width, 1, rgb_channels()), options).size();
    };
    EXPECT_EQ(size(6) - size(3), 3 * static_cast<std::size_t>(format.bytes_per_pixel)) << format.name;
  }
}

// rows: LF-18 LF-20
TEST(PixelFormat, FloatsErrByHalfAUnitOfTheirSmallestMantissa) {
  for (const int octave : {-34, -1, 33}) {
    EXPECT_LE(octave_error(full, octave), 0x1p-24);
    EXPECT_GE(octave_error(full, octave), 0.9 * 0x1p-24);
  }
  for (const int octave : {-14, 0, 14}) {
    EXPECT_LE(octave_error(half, octave), 0x1p-11 * 1.001);
    EXPECT_GE(octave_error(half, octave), 0.9 * 0x1p-11);
  }
  // Below 2^-14 a half has fewer digits; above 65504 it is 65504.
  EXPECT_NEAR(octave_error(half, -20), 0x1p-5, 0x1p-9);
  EXPECT_NEAR(octave_error(half, 20), 1 - 65504 * 0x1p-21, 1e-3);
}

// rows: LF-19
TEST(PixelFormat, ChannelsOfRgbeShareTheExponentOfTheBrightest) {
  for (const int octave : {-34, 0, 33}) {
    EXPECT_LE(octave_error(rgbe, octave), 1.0 / 255);
    EXPECT_GE(octave_error(rgbe, octave), 0.9 / 256);
    // 1.28 to 2.56 units under 128 to 256: 1.5 becomes 2.
    EXPECT_NEAR(octave_error(rgbe, octave, 100), 1.0 / 3, 0.01);
  }
  EXPECT_DOUBLE_EQ(octave_error(rgbe, 0, 1000), 1) << "under half a unit nothing is left";
}

TEST(PixelFormat, DisplayCodesErrByHalfAStepOfTheirCurve) {
  for (const auto& [format, top] : {std::pair{png8, 255.0}, {png16, 65535.0}}) {
    const auto code = static_cast<double>(srgb_encode(0.5f));
    const double slope = 2.4 / 1.055 * std::pow((code + 0.055) / 1.055, 1.4);
    EXPECT_NEAR(octave_error(format, -1), 0.5 / top * slope / 0.5, 0.06 * octave_error(format, -1));
    EXPECT_NEAR(octave_error(format, 3), 1 - 1.0 / 16, 1e-3) << "clipped to 1";
  }
}

// rows: LF-15 LF-19 LF-20
TEST(PixelFormat, KeepsWhatLiesBetweenItsEnds) {
  const auto range = [](std::size_t format) { return kept_range(pixel_formats()[format]); };
  EXPECT_EQ(range(png8).max, 1);
  EXPECT_FLOAT_EQ(static_cast<float>(range(png8).min_positive), 1 / (255 * 12.92f));
  EXPECT_FLOAT_EQ(static_cast<float>(range(png16).min_positive), 1 / (65535 * 12.92f));
  EXPECT_EQ(range(half).max, 65504);
  EXPECT_EQ(range(half).min_positive, 0x1p-24);
  EXPECT_GT(std::log10(range(rgbe).ratio()), 69);
  EXPECT_LT(std::log10(range(rgbe).ratio()), 77);
  EXPECT_EQ(range(full).min_positive, 0x1p-149);
}

// rows: LF-15 LF-17
TEST(RangeDemo, SaysTheNumbersOfTheWorkedExamples) {
  const Shown shown = show_range({});
  EXPECT_DOUBLE_EQ(fact(shown, "8 bits are short of the real world by"), 8e6);
  EXPECT_DOUBLE_EQ(fact(shown, "12 bits are short of the real world by"), 5e5);
  EXPECT_NEAR(fact(shown, "ratio of the radiance map"), 24348.2, 0.01);
  EXPECT_NEAR(fact(shown, "one of 256 equal steps over it"), 0.4755, 1e-4);
  EXPECT_NEAR(fact(shown, "decades, half (OpenEXR)"), std::log10(65504 * 0x1p24), 1e-12);
}

// rows: LF-18 LF-19 LF-20
TEST(PrecisionDemo, NamesBytesAndErrors) {
  const Shown shown = show_precision({});
  EXPECT_NEAR(fact(shown, "octave 2^-1, RGBE (Radiance)"), 1.0 / 257, 2e-4);
  EXPECT_NEAR(fact(shown, "octave 2^9, half (OpenEXR)"), 0x1p-11, 1e-5);
  EXPECT_GT(fact(shown, "octave 2^9, 16-bit sRGB (PNG)"), 0.99);
  std::string words;
  for (const auto& mark : std::get<draw::Drawing>(shown.picture).marks)
    if (const auto* w = std::get_if<draw::Words>(&mark)) words += w->text + "\n";
  for (const char* label : {"float (PFM), 12 bytes a pixel", "RGBE (Radiance), 4 bytes a pixel",
                            "half (OpenEXR), 6 bytes a pixel", "8-bit sRGB (PNG), 3 bytes a pixel"})
    EXPECT_NE(words.find(label), std::string::npos) << label;
}

}  // namespace
}  // namespace lambert::lab
