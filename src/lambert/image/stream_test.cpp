#include "lambert/image/stream.h"

#include "damage.h"
#include "lambert/image/image_test_tools.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambert {
namespace {

namespace fs = std::filesystem;

Image sample() {
  Image image = noise(37, 53, {"R", "G", "B", "A", "Z"});
  image.place({-4, 7}, {0, 0, 30, 60});
  image.metadata["seed"] = "42";
  image.attributes["count"] = {"int", "3"};
  return image;
}

TEST(ImageStream, BandsAreTheRowsOfTheWhole) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a.png", "a.hdr"}) {
    const fs::path path = folder.path() / name;
    write_image(path, sample());
    const Image whole = read_image(path);
    ImageReader reader(path);
    EXPECT_EQ(reader.header().data, whole.data_window());
    EXPECT_EQ(reader.header().display, whole.display_window());
    EXPECT_EQ(reader.header().channels, whole.channels());
    EXPECT_EQ(reader.header().metadata, whole.metadata);
    EXPECT_EQ(reader.header().attributes, whole.attributes);
    for (const auto& [y0, y1] : {std::pair{0, 1}, {40, 53}, {1, 20}, {0, 53}, {5, 5}}) {
      if (y0 == y1) continue;
      const Image band = reader.band(y0, y1);
      EXPECT_EQ(band.data_window(),
                (Window{whole.data_window().x, whole.data_window().y + y0, whole.width(), y1 - y0}));
      const auto rows = whole.pixels().subspan(static_cast<std::size_t>(y0) * reader.header().row_size());
      EXPECT_TRUE(std::ranges::equal(band.pixels(), rows.first(band.pixels().size()))) << name << y0;
    }
    std::vector<float> row(reader.header().row_size());
    const std::string message = error_of([&] { reader.read(whole.height(), whole.height() + 1, row); });
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0u) << message;
    EXPECT_NE(error_of([&] { reader.read(-1, 0, row); }), "");
    EXPECT_NE(error_of([&] { reader.read(0, 2, row); }), "");
  }
}

TEST(ImageStream, KnowsFullFloatsAndKeepsThem) {
  const TemporaryFolder folder;
  Image image(2, 1, {"R"});
  image.at(0, 0, 0) = 0.1f;
  EXPECT_FALSE(header_of(image).full_floats);
  const fs::path halves = folder.path() / "h.exr", floats = folder.path() / "f.exr", copy = folder.path() / "c.exr";
  write_image(halves, image);
  write_image(floats, image, {.depth = Depth::full});
  EXPECT_FALSE(ImageReader(halves).header().full_floats);
  ImageReader reader(floats);
  EXPECT_TRUE(reader.header().full_floats);
  ImageWriter writer(copy, reader.header());
  writer.write(reader.band(0, 1).pixels());
  writer.close();
  EXPECT_EQ(read_image(copy).at(0, 0, 0), 0.1f);
  image.at(1, 0, 0) = 65505;
  EXPECT_TRUE(header_of(image).full_floats);
}

TEST(ImageStream, WhatIsWrittenInBandsIsTheWhole) {
  const TemporaryFolder folder;
  const Image image = sample();
  for (const char* name : {"a.exr", "a.tif"}) {
    const fs::path whole = folder.path() / name, bands = folder.path() / (std::string("b") + name);
    write_image(whole, image);
    ImageWriter writer(bands, header_of(image));
    const std::size_t row = writer.header().row_size();
    for (int y = 0; y < 53;) {
      const int count = std::min(1 + y % 7, 53 - y);
      writer.write(image.pixels().subspan(static_cast<std::size_t>(y) * row, static_cast<std::size_t>(count) * row));
      y += count;
      EXPECT_EQ(writer.rows_written(), y);
    }
    EXPECT_FALSE(fs::exists(bands)) << "before it is whole";
    EXPECT_NE(error_of([&] { writer.write(image.pixels().first(row)); }), "");
    writer.close();
    const Image a = read_image(whole), b = read_image(bands);
    EXPECT_EQ(a.channels(), b.channels());
    EXPECT_EQ(a.data_window(), b.data_window());
    EXPECT_EQ(a.attributes, b.attributes);
    EXPECT_TRUE(std::ranges::equal(a.pixels(), b.pixels())) << name;
  }
}

TEST(ImageStream, WhatIsNotClosedLeavesNothing) {
  const TemporaryFolder folder;
  const Image image = sample();
  for (const char* name : {"a.exr", "a.png"}) {
    ImageWriter writer(folder.path() / name, header_of(image));
    writer.write(image.pixels().first(writer.header().row_size()));
    EXPECT_NE(error_of([&] { writer.close(); }).find("has 1 of 53 rows"), std::string::npos);
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
  for (const char* name : {"none/a.exr", "a.bmp"})
    EXPECT_NE(error_of([&] { ImageWriter(folder.path() / name, header_of(image)); }), "");
  EXPECT_NE(error_of([&] { ImageWriter(folder.path() / "a.png", header_of(image), {.depth = Depth::half}); }), "");
}

}  // namespace
}  // namespace lambert
