#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace lambert {
namespace {

const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
std::string rgbe(std::initializer_list<int> bytes) {
  std::string text;
  for (const int b : bytes) text += static_cast<char>(b);
  return text;
}
Image read(const std::string& text) { return decode_rgbe(bytes_of(text), "a.hdr"); }

// rows: LF-19
// Mantissas are parts of 256 (E-LF-01); four bytes per pixel.
TEST(Rgbe, DecodesSharedExponents) {
  struct Known {
    std::array<int, 4> code;
    std::array<double, 3> rgb;
  };
  for (const auto& [code, rgb] : {Known{{145, 215, 87, 149}, {1187840, 1761280, 712704}},
                                  Known{{145, 215, 87, 103}, {1.68802216649e-08, 2.50292941928e-08, 1.01281329989e-08}},
                                  Known{{128, 64, 0, 129}, {1, 0.5, 0}}, Known{{0, 0, 0, 0}, {0, 0, 0}}}) {
    const Rgb c = read(header + "-Y 1 +X 1\n" + rgbe({code[0], code[1], code[2], code[3]})).rgb(0, 0);
    for (int i = 0; i < 3; ++i) {
      const double expected = rgb[static_cast<std::size_t>(i)];
      EXPECT_NEAR(c[i], expected, 1e-7 * expected);
    }
  }
}

// Half a step of the largest component's mantissa, at least 128 of 256.
TEST(Rgbe, RoundTripsWithinItsMantissa) {
  for (const int width : {1, 7, 8, 9, 127, 128, 129, 300}) {
    for (const float top : {1e-6f, 1.0f, 1e6f}) {
      Image image = noise(width, 3, rgb_channels(), top);
      for (int x = width / 3; x < width; ++x) image.set_rgb(x, 1, Rgb(top, top / 2, 0));  // runs
      const Image back = decode_rgbe(encode_rgbe(image), "a.hdr");
      ASSERT_EQ(back.width(), width);
      ASSERT_EQ(back.height(), 3);
      for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < width; ++x) {
          const Rgb a = image.rgb(x, y), b = back.rgb(x, y);
          for (int c = 0; c < 3; ++c) EXPECT_NEAR(b[c], a[c], max_component(a) / 255) << width << " " << x;
        }
      }
    }
  }
}

TEST(Rgbe, RoundsUpToTheNextExponent) {
  Image image(1, 1, rgb_channels());
  image.set_rgb(0, 0, {0.9995f, 0.5f, 0});
  EXPECT_EQ(decode_rgbe(encode_rgbe(image), "a.hdr").rgb(0, 0), Rgb(1, 0.5f, 0));
}

TEST(Rgbe, WhatHasNoCodeIsBlackOrTheLargest) {
  Image image(3, 1, rgb_channels());
  image.set_rgb(0, 0, {std::numeric_limits<float>::quiet_NaN(), -1, 0.5f});
  image.set_rgb(1, 0, Rgb(1e-38f));
  image.set_rgb(2, 0, Rgb(std::numeric_limits<float>::infinity()));
  const Image back = decode_rgbe(encode_rgbe(image), "a.hdr");
  EXPECT_EQ(back.rgb(0, 0), Rgb(0, 0, 0.5f));
  EXPECT_EQ(back.rgb(1, 0), Rgb(0.0f));
  EXPECT_GT(back.rgb(2, 0).r, 1e38f);
}

// (1, 1, 1, n) repeats the last pixel; a second such pixel counts 256s.
TEST(Rgbe, ReadsOldRuns) {
  const std::string pixel = rgbe({128, 0, 0, 129}), other = rgbe({0, 128, 0, 129});
  const Image image = read(header + "-Y 1 +X 300\n" + pixel + rgbe({1, 1, 1, 42, 1, 1, 1, 1}) + other);
  for (int x = 0; x < 299; ++x) ASSERT_EQ(image.rgb(x, 0), Rgb(1, 0, 0)) << x;
  EXPECT_EQ(image.rgb(299, 0), Rgb(0, 1, 0));
  EXPECT_NE(error_of([&] {
              read(header + "-Y 1 +X 4\n" + pixel + rgbe({1, 1, 1, 4}));
            }).find("leaves the scan line"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              read(header + "-Y 1 +X 4\n" + rgbe({1, 1, 1, 2}));
            }).find("leaves the scan line"),
            std::string::npos);
}

TEST(Rgbe, ReadsNewRuns) {
  std::string line = rgbe({2, 2, 0, 8});
  for (const int value : {128, 64, 0}) line += rgbe({128 + 8, value});
  line += rgbe({8, 129, 129, 129, 129, 130, 130, 130, 130});
  const Image image = read(header + "-Y 1 +X 8\n" + line);
  EXPECT_EQ(image.rgb(3, 0), Rgb(1, 0.5f, 0));
  EXPECT_EQ(image.rgb(4, 0), Rgb(2, 1, 0));
  EXPECT_NE(error_of([&] {
              read(header + "-Y 1 +X 8\n" + rgbe({2, 2, 0, 9}));
            }).find("another width"),
            std::string::npos);
}

// The first axis is the one of scan lines; "-Y" starts at the top, "+X" at the left.
TEST(Rgbe, AllOrientations) {
  // Pixels in the order of the file: 1 2 3 4 5 6 as exponents.
  std::string pixels;
  for (int i = 1; i <= 6; ++i) pixels += rgbe({128, 0, 0, 128 + i});
  struct Case {
    const char* size;
    std::array<int, 6> seen;  // rows from the top, 3 wide and 2 high
  };
  for (const auto& [size, seen] : {Case{"-Y 2 +X 3", {1, 2, 3, 4, 5, 6}}, Case{"+Y 2 +X 3", {4, 5, 6, 1, 2, 3}},
                                   Case{"-Y 2 -X 3", {3, 2, 1, 6, 5, 4}}, Case{"+Y 2 -X 3", {6, 5, 4, 3, 2, 1}},
                                   Case{"+X 3 -Y 2", {1, 3, 5, 2, 4, 6}}, Case{"+X 3 +Y 2", {2, 4, 6, 1, 3, 5}},
                                   Case{"-X 3 -Y 2", {5, 3, 1, 6, 4, 2}}, Case{"-X 3 +Y 2", {6, 4, 2, 5, 3, 1}}}) {
    const Image image = read(header + size + "\n" + pixels);
    ASSERT_EQ(image.width(), 3) << size;
    ASSERT_EQ(image.height(), 2) << size;
    for (int i = 0; i < 6; ++i) {
      EXPECT_EQ(image.rgb(i % 3, i / 3).r, std::ldexp(0.5f, seen[static_cast<std::size_t>(i)])) << size << " " << i;
    }
  }
}

TEST(Rgbe, ExposureIsDividedOut) {
  const std::string text =
      "#?RGBE\n# comment\nEXPOSURE= 2.0\r\nEXPOSURE=4\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + rgbe({128, 64, 0, 132});
  EXPECT_EQ(read(text).rgb(0, 0), Rgb(1, 0.5f, 0));
}

// rows: LF-19
TEST(Rgbe, CorrectionsAreDividedOutAndGammaIsUndone) {
  const std::string one = "\n-Y 1 +X 1\n" + rgbe({128, 64, 0, 129});  // 1, 0.5, 0
  EXPECT_EQ(read("#?RADIANCE\nCOLORCORR=2 1 1\nCOLORCORR= 2 0.5 1\nEXPOSURE=0.5\n" + one).rgb(0, 0), Rgb(0.5f, 2, 0));
  const Rgb bent = read("#?RGBE\nGAMMA=2\n" + one).rgb(0, 0);
  EXPECT_NEAR(bent.r, 1, 1e-6f);
  EXPECT_NEAR(bent.g, 0.25f, 1e-6f);
}

TEST(Rgbe, PrimariesBecomeRec709) {
  const std::string one = "\n-Y 1 +X 1\n" + rgbe({128, 128, 128, 129});
  const auto expect = [](Rgb got, Rgb wanted) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], 2e-3f);
  };
  // White stays white whatever it is; XYZ is as measured, so that equal numbers are pinkish.
  expect(read("#?RADIANCE\nPRIMARIES=.64 .33 .29 .6 .15 .06 .3333 .3333\n" + one).rgb(0, 0), Rgb(1));
  expect(read("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n" + one).rgb(0, 0), {1.2048f, 0.9483f, 0.9088f});
  expect(read("#?RADIANCE\nPRIMARIES=.64 .33 .29 .6 .15 .06 .3333 .3333\nFORMAT=32-bit_rle_xyze\n" + one).rgb(0, 0),
         Rgb(1));
  const Rgb green =
      read("#?RADIANCE\nPRIMARIES=.7347 .2653 0 1 .0001 -.077 .32168 .33767\n\n-Y 1 +X 1\n" + rgbe({0, 128, 0, 129}))
          .rgb(0, 0);
  expect(green, {-1.1341f, 1.3727f, -0.1530f});
}

TEST(Rgbe, WhatTheHeaderSaysComesBack) {
  Image image(1, 1, rgb_channels());
  image.metadata["SOFTWARE"] = "Lambert\nFORMAT=evil";
  image.attributes["pixelAspectRatio"] = {"float", "2"};
  const std::string text = text_of(encode_rgbe(image));
  EXPECT_NE(text.find("PIXASPECT=0.5\n"), std::string::npos) << text;
  const Image back = read(text);
  EXPECT_EQ(back.metadata.at("SOFTWARE"), "Lambert FORMAT=evil");
  EXPECT_EQ(back.attributes, image.attributes);
}

TEST(Rgbe, SaysWhatItCannotRead) {
  for (const auto& [text, part] : {std::pair{std::string("#?RADIANCE\nFORMAT=32-bit_rle_luv\n\n"), "32-bit_rle_luv"},
                                   {"#?RADIANCE\nCOLORCORR=1 1\n\n", "three positive numbers"},
                                   {"#?RADIANCE\nPRIMARIES=1 1\n\n", "eight chromaticities"},
                                   {"#?RADIANCE\nPRIMARIES=0 0 0 0 0 0 0 0\n\n-Y 1 +X 1\n....", "chromaticities"},
                                   {"#?RADIANCE\nEXPOSURE=1e-300\nEXPOSURE=1e-300\n\n-Y 1 +X 1\n....", "range"},
                                   {"#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n....", "EXPOSURE"},
                                   {header + "-Y 1 +Y 1\n....", "-Y 480 +X 640"},
                                   {header + "-Y -1 +X 1\n....", "-Y 480 +X 640"},
                                   {header, "the header ends"},
                                   {header + "-Y 1 +X 2\n.....", "the pixels end"}}) {
    const std::string message = error_of([&] { read(text); });
    EXPECT_EQ(message.rfind("a.hdr: ", 0), 0u) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace lambert
