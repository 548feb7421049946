#include "lambert/image/formats/exif.h"

#include "damage.h"
#include "lambert/image/formats/codecs.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

/// A TIFF structure with numbers of either order, written entry by entry.
struct Directory {
  bool little = true;
  std::string entries, outside;
  int count = 0;

  std::string number(std::uint64_t value, int size) const {
    std::string text;
    for (int i = 0; i < size; ++i) text += static_cast<char>(value >> (8 * (little ? i : size - 1 - i)));
    return text;
  }
  /// `base`: where `outside` will lie in the file.
  void rational(int tag, std::uint64_t a, std::uint64_t b, std::uint64_t base, int type = 5) {
    entries += number(static_cast<std::uint64_t>(tag), 2) + number(static_cast<std::uint64_t>(type), 2) + number(1, 4) +
               number(base + outside.size(), 4);
    outside += number(a, 4) + number(b, 4);
    ++count;
  }
  void word(int tag, std::uint64_t value) {
    entries += number(static_cast<std::uint64_t>(tag), 2) + number(3, 2) + number(1, 4) + number(value, 2) + "\0\0";
    entries.resize(entries.size() / 12 * 12 + (entries.size() % 12 ? 12 : 0), '\0');
    ++count;
  }
  void offset(int tag, std::uint64_t value) {
    entries += number(static_cast<std::uint64_t>(tag), 2) + number(4, 2) + number(1, 4) + number(value, 4);
    ++count;
  }
  std::string text() const { return number(static_cast<std::uint64_t>(count), 2) + entries + number(0, 4) + outside; }
};

/// Orientation in the first directory, the others in the Exif directory behind it: 1/125 s, f/5.6, ISO 400.
std::string tiff(bool little, int orientation) {
  Directory first{.little = little}, exif{.little = little};
  first.word(274, static_cast<std::uint64_t>(orientation));
  const std::uint64_t second_at = 8 + 2 + 2 * 12 + 4;
  first.offset(34665, second_at);
  const std::uint64_t base = second_at + 2 + 3 * 12 + 4;
  exif.rational(33434, 1, 125, base);
  exif.rational(33437, 56, 10, base);
  exif.word(34855, 400);
  return (little ? std::string("II*\0", 4) : std::string("MM\0*", 4)) + first.number(8, 4) + first.text() + exif.text();
}
std::string big_endian(std::uint64_t value, int size) { return Directory{.little = false}.number(value, size); }
std::string jpeg(const std::string& exif) {
  return "\xff\xd8\xff\xe0" + big_endian(6, 2) + "JFIF\xff\xe1" + big_endian(exif.size() + 8, 2) +
         std::string("Exif\0\0", 6) + exif + "\xff\xda";
}
std::string png(const std::string& exif) {
  return "\x89PNG\r\n\x1a\n" + big_endian(4, 4) + "tEXta" + std::string(7, '\0') + big_endian(exif.size(), 4) + "eXIf" +
         exif + "1234";
}
std::string webp(const std::string& exif) {
  const Directory little;
  return "RIFF" + little.number(exif.size() + 24, 4) + "WEBPVP8 " + little.number(3, 4) + "abc" + std::string(1, '\0') +
         "EXIF" + little.number(exif.size(), 4) + exif;
}

TEST(Exif, IsFoundInEveryKindOfFile) {
  for (const bool little : {true, false}) {
    const std::string exif = tiff(little, 6);
    for (const std::string& file : {exif, jpeg(exif), png(exif), webp(exif)}) {
      const auto found = read_exif(bytes_of(file));
      ASSERT_TRUE(found) << little << file.substr(0, 4);
      EXPECT_EQ(found->exposure_time, 1.0 / 125);
      EXPECT_EQ(found->f_number, 5.6);
      EXPECT_EQ(found->iso, 400.0);
      EXPECT_EQ(found->orientation, 6);
    }
  }
}

TEST(Exif, ApexValuesStandIn) {
  Directory d;
  const std::uint64_t base = 8 + 2 + 3 * 12 + 4;
  d.rational(37377, static_cast<std::uint32_t>(-2), 1, base, 10);  // 4 s
  d.rational(37378, 4, 1, base);                                   // f/4
  d.word(274, 9);                                                  // there is no ninth orientation
  const auto found = read_exif(bytes_of(std::string("II*\0\x08\0\0\0", 8) + d.text()));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->exposure_time, 4.0);
  EXPECT_EQ(found->f_number, 4.0);
  EXPECT_FALSE(found->iso);
  EXPECT_EQ(found->orientation, 1);
}

TEST(Exif, WhatMakesNoSenseIsLeftOut) {
  Directory d;
  const std::uint64_t base = 8 + 2 + 3 * 12 + 4;
  d.rational(33434, 0, 125, base);
  d.rational(33437, 1, 0, base);
  d.word(34855, 0);
  const auto found = read_exif(bytes_of(std::string("II*\0\x08\0\0\0", 8) + d.text()));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->exposure_time || found->f_number || found->iso);
}

TEST(Exif, BlocksAreReadBack) {
  for (const double time : {1.0 / 8000, 1.0 / 125, 1.0 / 64, 0.3, 1.0, 2.5, 30.0, 1e-6, 3e8}) {
    const auto found = read_exif(exif_block({.exposure_time = time, .f_number = 5.6, .iso = 400}));
    ASSERT_TRUE(found && found->exposure_time) << time;
    EXPECT_NEAR(*found->exposure_time / time, 1, 1e-6);
    EXPECT_EQ(found->f_number, 5.6);
    EXPECT_EQ(found->iso, 400.0);
  }
  const auto none = read_exif(exif_block({.exposure_time = 1e-12, .f_number = -1, .iso = 1e9}));
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->exposure_time || none->f_number || none->iso);
}

TEST(Exif, PngAndJpegKeepIt) {
  const DisplayImage image{
      .width = 2, .height = 1, .channels = 1, .bytes = {7, 200}, .exif = Exif{.exposure_time = 1.0 / 60}};
  for (const auto& file : {encode_png(image), encode_jpeg(image)}) {
    const auto found = read_exif(file);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->exposure_time, 1.0 / 60);
    EXPECT_EQ(decode_texels(file, "file").width, 2);
    EXPECT_EQ(decode_image(file, "file").attributes.at("expTime").type, "float");
  }
}

TEST(Exif, NoneWithoutIt) {
  for (const std::string& file : {std::string(), std::string("\xff\xd8"), std::string("\x89PNG\r\n\x1a\n"),
                                  std::string("II*\0\xff\xff\xff\xff", 8), jpeg("hello"), std::string("RIFF")})
    EXPECT_FALSE(read_exif(bytes_of(file)));
}

// A directory that points to itself must end, too.
TEST(Exif, SurvivesDamage) {
  for (const std::string& file : {tiff(true, 3), jpeg(tiff(false, 3)), png(tiff(true, 1)), webp(tiff(true, 1))}) {
    expect_survives_damage(file, 2000, [](const std::string& damaged) {
      if (!read_exif(bytes_of(damaged))) throw Error("none");
    });
    for (std::size_t length = 0; length < file.size(); ++length) read_exif(bytes_of(file).first(length));
  }
  Directory loop;
  loop.offset(34665, 8);
  EXPECT_TRUE(read_exif(bytes_of(std::string("II*\0\x08\0\0\0", 8) + loop.text())));
}

}  // namespace
}  // namespace lambert
