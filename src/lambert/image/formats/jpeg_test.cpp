#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

namespace lambert {
namespace {

using Codes = std::vector<std::uint8_t>;

/// One colour all over, written with libjpeg alone; CMYK with Adobe's marker.
std::string jpeg(J_COLOR_SPACE given, J_COLOR_SPACE stored, const Codes& colour, bool progressive = false) {
  jpeg_error_mgr errors;
  jpeg_compress_struct info;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &buffer, &size);
  info.image_width = 24, info.image_height = 16;
  info.input_components = static_cast<int>(colour.size());
  info.in_color_space = given;
  jpeg_set_defaults(&info);
  jpeg_set_colorspace(&info, stored);
  jpeg_set_quality(&info, 100, TRUE);
  if (progressive) jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  Codes row;
  for (int x = 0; x < 24; ++x) row.insert(row.end(), colour.begin(), colour.end());
  JSAMPROW pointer = row.data();
  while (info.next_scanline < info.image_height) jpeg_write_scanlines(&info, &pointer, 1);
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  std::string text(reinterpret_cast<const char*>(buffer), size);
  std::free(buffer);
  return text;
}

void expect_all(const std::string& text, const Codes& colour) {
  const Texels t = decode_jpeg(bytes_of(text), "a.jpg");
  EXPECT_EQ(t.width, 24);
  EXPECT_EQ(t.height, 16);
  ASSERT_EQ(t.channels, static_cast<int>(colour.size()));
  ASSERT_EQ(t.bytes.size(), 24 * 16 * colour.size());
  for (std::size_t i = 0; i < t.bytes.size(); ++i) ASSERT_NEAR(t.bytes[i], colour[i % colour.size()], 2) << i;
}

TEST(Jpeg, GreyAndColour) {
  expect_all(jpeg(JCS_GRAYSCALE, JCS_GRAYSCALE, {77}), {77});
  for (const bool progressive : {false, true}) {
    expect_all(jpeg(JCS_RGB, JCS_YCbCr, {200, 100, 50}, progressive), {200, 100, 50});
    expect_all(jpeg(JCS_RGB, JCS_RGB, {200, 100, 50}, progressive), {200, 100, 50});
  }
}

// 255 is no ink, and black ink darkens the others.
TEST(Jpeg, InvertedCmykBecomesRgb) {
  for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
    expect_all(jpeg(JCS_CMYK, stored, {200, 100, 50, 255}), {200, 100, 50});
    expect_all(jpeg(JCS_CMYK, stored, {200, 100, 50, 128}), {100, 50, 25});
    expect_all(jpeg(JCS_CMYK, stored, {200, 100, 50, 0}), {0, 0, 0});
  }
}

TEST(Jpeg, WhatIsWrittenComesBackNearly) {
  for (const int channels : {1, 3}) {
    DisplayImage shown{.width = 40, .height = 30, .channels = channels};
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        for (int c = 0; c < channels; ++c) shown.bytes.push_back(static_cast<std::uint8_t>(60 + 3 * x + y));
      }
    }
    const Texels t = decode_jpeg(encode_jpeg(shown), "a.jpg");
    ASSERT_EQ(t.bytes.size(), shown.bytes.size());
    for (std::size_t i = 0; i < t.bytes.size(); ++i) EXPECT_NEAR(t.bytes[i], shown.bytes[i], 6) << i;
  }
}

}  // namespace
}  // namespace lambert
