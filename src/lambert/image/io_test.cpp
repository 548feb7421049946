#include "lambert/image/io.h"

#include "damage.h"
#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/colour.h"
#include "lambert/image/image_test_tools.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lambert {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t file_count(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}
Image round_trip(const std::string& extension, const Image& image) {
  const TemporaryFolder folder;
  write_image(folder.path() / ("a" + extension), image);
  EXPECT_EQ(file_count(folder.path()), 1) << "nothing temporary stays";
  return read_image(folder.path() / ("a" + extension));
}

TEST(ImageIo, EncodedBytesAreThoseOfTheFile) {
  const Image image = noise(17, 9, rgb_channels());
  for (const std::string& extension : image_extensions()) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / ("a" + extension);
    write_image(path, image);
    const std::vector<std::byte> bytes = encode_image(path, image);
    const MappedFile file(path);
    EXPECT_TRUE(std::ranges::equal(bytes, file.bytes())) << extension;
  }
  EXPECT_THROW(encode_image("a.exr", Image()), Error);
  EXPECT_THROW(encode_image("a.exr", image, {.depth = Depth::bits8}), Error);
}

// Steps of the format: halves, eight bits of the largest component, floats, codes of sRGB.
TEST(ImageIo, EveryFormatRoundTrips) {
  for (const std::string& extension : image_extensions()) {
    Image image = noise(17, 9, rgb_channels());
    if (extension == ".jpg" || extension == ".jpeg") {  // noise is what it does not keep
      for (int i = 0; i < 17 * 9; ++i) image.set_rgb(i % 17, i / 17, Rgb(static_cast<float>(i) / 153));
    }
    const Image back = round_trip(extension, image);
    ASSERT_EQ(back.width(), 17) << extension;
    ASSERT_EQ(back.height(), 9) << extension;
    ASSERT_EQ(back.channels(), rgb_channels()) << extension;
    for (int i = 0; i < 17 * 9; ++i) {
      const Rgb a = image.rgb(i % 17, i / 17), b = back.rgb(i % 17, i / 17);
      for (int c = 0; c < 3; ++c) {
        if (extension == ".exr")
          EXPECT_NEAR(b[c], a[c], a[c] / 2048 + 1e-7f);
        else if (extension == ".hdr" || extension == ".pic")
          EXPECT_NEAR(b[c], a[c], max_component(a) / 255);
        else if (extension == ".pfm")
          EXPECT_EQ(b[c], a[c]);
        else if (extension == ".tif" || extension == ".tiff")
          EXPECT_NEAR(srgb_encode(b[c]), srgb_encode(a[c]), 0.51f / 65535 + 1e-6f);
        else
          EXPECT_NEAR(srgb_encode(b[c]), srgb_encode(a[c]), extension[1] == 'j' ? 8.0f / 255 : 0.51f / 255)
              << extension;
      }
    }
  }
}

TEST(ImageIo, GreyAndAlphaOfDisplayFormats) {
  for (const char* extension : {".png", ".tif", ".webp"}) {
    for (const std::vector<std::string>& channels : {rgba_channels(), std::vector<std::string>{"Y", "A"}, {"Y"}}) {
      Image image = noise(6, 4, channels);
      if (const auto a = image.channel("A")) {  // premultiplied colours do not exceed alpha
        for (int i = 0; i < 24; ++i) {
          image.at(i % 6, i / 6, *a) = 0.5f + 0.5f * image.at(i % 6, i / 6, *a);
          for (std::size_t c = 0; c < *a; ++c) image.at(i % 6, i / 6, c) *= image.at(i % 6, i / 6, *a);
        }
      }
      const Image back = round_trip(extension, image);
      for (int i = 0; i < 24; ++i) {
        const Rgb a = image.rgb(i % 6, i / 6), b = back.rgb(i % 6, i / 6);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 8e-3f) << extension << channels.size();
        if (const auto alpha = image.channel("A")) {
          EXPECT_NEAR(image.at(i % 6, i / 6, *alpha), back.at(i % 6, i / 6, *back.channel("A")), 2.1e-3f);
        }
      }
    }
  }
}

// rows: AA-27
// Colours are stored times their coverage: half red is (.5, 0, 0, .5), clear all 0, black (0, 0, 0, 1).
TEST(ImageIo, AlphaIsPremultipliedInMemoryAndStraightInDisplayFiles) {
  Image image(3, 1, rgba_channels());
  image.at(0, 0, 0) = image.at(0, 0, 3) = 0.5f;
  image.at(2, 0, 3) = 1;
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a.png", "a.tif", "a.webp"}) {
    write_image(folder.path() / name, image);
    const Image back = read_image(folder.path() / name);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(back.pixels()[i], image.pixels()[i], 2e-3f) << name << i;
  }
  std::ifstream in(folder.path() / "a.png", std::ios::binary);
  const std::string png{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(decode_texels(bytes_of(png), "a.png").bytes,
            (std::vector<std::uint8_t>{255, 0, 0, 128, 0, 0, 0, 0, 0, 0, 0, 255}));
}

TEST(ImageIo, DisplayFormatsClip) {
  Image image(4, 1, rgb_channels());
  image.set_rgb(0, 0, Rgb(7));
  image.set_rgb(1, 0, Rgb(-7));
  image.set_rgb(2, 0, Rgb(std::numeric_limits<float>::quiet_NaN()));
  image.set_rgb(3, 0, Rgb(std::numeric_limits<float>::infinity()));
  for (const char* extension : {".png", ".tif", ".webp"}) {
    const Image back = round_trip(extension, image);
    for (int x = 0; x < 4; ++x) EXPECT_EQ(back.rgb(x, 0), Rgb(x % 3 == 0 ? 1.0f : 0.0f)) << extension << x;
  }
}

TEST(ImageIo, TheKindIsFoundByContent) {
  const TemporaryFolder folder;
  write_image(folder.path() / "a.png", noise(3, 2, rgb_channels()));
  fs::rename(folder.path() / "a.png", folder.path() / "a.exr");
  EXPECT_EQ(read_image(folder.path() / "a.exr").width(), 3);
  EXPECT_FALSE(is_radiance_file(folder.path() / "a.exr"));
  write_image(folder.path() / "b.pfm", noise(3, 2, rgb_channels()));
  EXPECT_TRUE(is_radiance_file(folder.path() / "b.pfm"));
  EXPECT_THROW(is_radiance_file(folder.path() / "none.pfm"), Error);
}

TEST(ImageIo, TexelsAreTheColourOfTheLayers) {
  const auto exr = encode_exr(noise(3, 2, {"R", "G", "B", "A", "Z", "albedo.R"}));
  const Texels t = decode_texels(exr, "a.exr");
  EXPECT_EQ(t.channels, 4);
  EXPECT_EQ(t.floats.size(), 24u);
  EXPECT_TRUE(t.linear);
  EXPECT_EQ(decode_texels(encode_exr(noise(3, 2, {"Z"})), "a.exr").channels, 1);
}

TEST(ImageIo, ErrorsNameTheFileAndWhatIsKnown) {
  const TemporaryFolder folder;
  const fs::path base = folder.path();
  const Image image = noise(3, 2, rgb_channels());
  const auto expect_error = [](const fs::path& path, const std::string& part, const auto& act) {
    const std::string message = error_of(act);
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0u) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  for (const std::string& known : image_extensions())
    expect_error(base / "a.bmp", known, [&] { write_image(base / "a.bmp", image); });
  expect_error(base / "a", "unknown image format", [&] { is_radiance_format(base / "a"); });
  expect_error(base / "none.png", "No such file", [&] { read_image(base / "none.png"); });
  folder.write("empty.png", "");
  expect_error(base / "empty.png", "known image formats", [&] { read_image(base / "empty.png"); });
  folder.write("text.exr", "hello");
  expect_error(base / "text.exr", "known image formats", [&] { read_image(base / "text.exr"); });
}

TEST(ImageIo, WhatCannotBeWrittenLeavesNoFileAndTheOldOne) {
  const TemporaryFolder folder;
  folder.write("file", "x");
  fs::create_directory(folder.path() / "folder.png");
  fs::create_directory(folder.path() / "old");
  const fs::path old = folder.path() / "old/a.webp";
  write_image(old, noise(3, 2, rgb_channels()));
  const Image small = noise(3, 2, rgb_channels()), wide = noise(70000, 1, rgb_channels());
  Image odd = small;
  odd.metadata["channels"] = "a name that EXR keeps for itself";
  for (const auto& [path, image] : {std::pair{folder.path() / "none/a.png", small},
                                    {folder.path() / "file/a.exr", small},
                                    {folder.path() / "folder.png", small},
                                    {old, wide},
                                    {folder.path() / "a.jpg", wide},
                                    {folder.path() / "a.hdr", Image()},
                                    {folder.path() / "a.exr", odd}}) {
    const std::string message = error_of([&, &p = path, &i = image] { write_image(p, i); });
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0u) << message;
  }
  EXPECT_EQ(file_count(folder.path()), 3);
  EXPECT_EQ(file_count(folder.path() / "old"), 1);
  EXPECT_EQ(read_image(old).width(), 3);
}

TEST(ImageIo, RadianceFormats) {
  for (const char* name : {"a.exr", "a.HDR", "a.pfm", "a.pic"}) EXPECT_TRUE(is_radiance_format(name));
  for (const char* name : {"a.png", "a.JPG", "a.tiff", "a.webp"}) EXPECT_FALSE(is_radiance_format(name));
}

// Files of other programs; nothing among them is damaged.
TEST(ImageIo, StandardOutputHasTheFormatInFront) {
  EXPECT_TRUE(is_radiance_format("-"));
  EXPECT_TRUE(writes_exr("-"));
  EXPECT_TRUE(is_radiance_format("PFM:-"));
  EXPECT_FALSE(writes_exr("pfm:-"));
  EXPECT_FALSE(is_radiance_format("png:-"));
  EXPECT_THROW(is_radiance_format("bmp:-"), Error);
  EXPECT_THROW(is_radiance_format("./-"), Error);
}

TEST(ImageIo, ReadsFilesOfOtherPrograms) {
  const fs::path data = LAMBERT_SHARED_DATA;
  int files = 0;
  for (const char* folder : {"hdr", "compositing"}) {
    if (!fs::exists(data / folder)) GTEST_SKIP() << "needs " << data / folder;
    for (const auto& entry : fs::recursive_directory_iterator(data / folder)) {
      if (entry.path().extension() != ".exr" && entry.path().extension() != ".hdr") continue;
      ++files;
      EXPECT_GE(read_image(entry.path()).width(), 100) << entry.path();
    }
  }
  EXPECT_GE(files, 30);
}

TEST(ImageIo, NotFiniteValuesOfOtherProgramsAreKept) {
  const fs::path path = fs::path(LAMBERT_SHARED_DATA) / "compositing/openexr-images/TestImages/AllHalfValues.exr";
  if (!fs::exists(path)) GTEST_SKIP() << "needs " << path;
  // 65536 codes, of which 2 are infinities and 2046 are not numbers.
  const Image image = read_image(path);
  ASSERT_EQ(image.width() * image.height(), 65536);
  int infinities = 0, no_numbers = 0;
  for (int i = 0; i < 65536; ++i) {
    const float v = image.at(i % 256, i / 256, 0);
    infinities += std::isinf(v), no_numbers += std::isnan(v);
  }
  EXPECT_EQ(infinities, 2);
  EXPECT_EQ(no_numbers, 2046);
}

}  // namespace
}  // namespace lambert
