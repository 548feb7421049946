#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "temporary_folder.h"

namespace lambert {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

Image round_trip(const Image& image) { return decode_exr(encode_exr(image), "a.exr"); }

TEST(Exr, LayersComeBackByName) {
  const std::vector<std::string> names = {"R",        "G",        "B",        "A",          "Z",
                                          "albedo.R", "normal.X", "normal.Z", "position.X", "CryptoObject00.R"};
  Image image = noise(7, 5, names, 100);
  image.metadata = {{"software", "Lambert"}, {"seed", "42"}};
  const Image back = round_trip(image);
  EXPECT_EQ(back.metadata, image.metadata);
  ASSERT_EQ(back.width(), 7);
  ASSERT_EQ(back.height(), 5);
  ASSERT_EQ(back.channel_count(), names.size());
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(back.channels()[c], names[c]) << "the colour first";
  for (std::size_t c = 0; c < names.size(); ++c) {
    const bool precise = names[c] == "Z" || names[c] == "position.X" || names[c] == "CryptoObject00.R";
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 7; ++x) {
        const float v = image.at(x, y, c);
        EXPECT_NEAR(back.at(x, y, *back.channel(names[c])), v, precise ? 0 : v / 2048) << names[c];
      }
    }
  }
}

TEST(Exr, KeepsWhatIsNotFinite) {
  Image image(4, 1, {"R", "Z"});
  const std::array values = {inf, -inf, nan, 1e9f};
  for (int x = 0; x < 4; ++x) image.at(x, 0, 0) = image.at(x, 0, 1) = values[static_cast<std::size_t>(x)];
  const Image back = round_trip(image);
  for (int x = 0; x < 3; ++x) {
    EXPECT_TRUE(same(back.at(x, 0, 0), values[static_cast<std::size_t>(x)])) << x;
    EXPECT_TRUE(same(back.at(x, 0, 1), values[static_cast<std::size_t>(x)])) << x;
  }
  EXPECT_EQ(back.at(3, 0, 0), 65504) << "the largest half";
  EXPECT_EQ(back.at(3, 0, 1), 1e9f);
}

TEST(Exr, GreyWithAlphaStaysGrey) {
  Image image(1, 1, {"Y", "A"});
  image.at(0, 0, 0) = 0.25f, image.at(0, 0, 1) = 0.5f;
  EXPECT_EQ(round_trip(image).channels(), image.channels());
  EXPECT_EQ(round_trip(image).rgb(0, 0), Rgb(0.25f));
}

// rows: LF-20
// Six bytes for R, G and B, whose codes are those of IEEE 754 binary16, compressed without loss.
TEST(Exr, StoresHalves) {
  const std::array values = {1.0f, -2.0f, 65504.0f, 0.1f, 5.96046447754e-08f};
  const std::array<std::uint16_t, 5> codes = {0x3c00, 0xc000, 0x7bff, 0x2e66, 0x0001};
  Image image(5, 1, rgb_channels());
  for (int x = 0; x < 5; ++x) image.set_rgb(x, 0, Rgb(values[static_cast<std::size_t>(x)]));
  const TemporaryFolder folder;
  Imf::InputFile file(folder.write("a.exr", text_of(encode_exr(image))).c_str());
  EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
  Imf::FrameBuffer frame;
  std::array<std::array<std::uint16_t, 5>, 3> stored{};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(file.header().channels()[rgb_channels()[c]].type, Imf::HALF);
    frame.insert(rgb_channels()[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(stored[c].data()), 2, 10));
  }
  file.setFrameBuffer(frame);
  file.readPixels(0);
  for (const auto& channel : stored) EXPECT_EQ(channel, codes);
}

/// One float channel "Y" whose value at (x, y) is 100 y + x + 1.
std::string with_windows(const Imath::Box2i& display, const Imath::Box2i& data) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  {
    Imf::Header header(display, data);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    const int width = data.max.x - data.min.x + 1;
    std::vector<float> row(static_cast<std::size_t>(width));
    Imf::OutputFile file(path.c_str(), header);
    for (int y = data.min.y; y <= data.max.y; ++y) {
      for (int x = 0; x < width; ++x)
        row[static_cast<std::size_t>(x)] = static_cast<float>(100 * y + data.min.x + x + 1);
      Imf::FrameBuffer frame;
      frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row.data() - data.min.x), 4, 0));
      file.setFrameBuffer(frame);
      file.writePixels(1);
    }
  }
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Exr, TheDataWindowLiesInTheDisplayWindow) {
  const Imath::Box2i display({10, 20}, {15, 24});
  for (const Imath::Box2i& data : {display, Imath::Box2i({12, 21}, {13, 22}), Imath::Box2i({8, 18}, {20, 30}),
                                   Imath::Box2i({14, 23}, {30, 40}), Imath::Box2i({40, 40}, {41, 41})}) {
    const Image image = decode_exr(bytes_of(with_windows(display, data)), "a.exr");
    ASSERT_EQ(image.width(), 6);
    ASSERT_EQ(image.height(), 5);
    for (int y = 20; y <= 24; ++y) {
      for (int x = 10; x <= 15; ++x) {
        const float expected = data.intersects(Imath::V2i(x, y)) ? static_cast<float>(100 * y + x + 1) : 0;
        EXPECT_EQ(image.at(x - 10, y - 20, 0), expected) << x << " " << y;
      }
    }
  }
}

TEST(Exr, ErrorsOfLengthNameTheFile) {
  const std::string whole = text_of(encode_exr(noise(20, 20, rgb_channels())));
  for (const std::size_t length : {std::size_t{5}, std::size_t{100}, whole.size() - 1}) {
    const std::string message = error_of([&] { decode_exr(bytes_of(whole).subspan(0, length), "a.exr"); });
    EXPECT_EQ(message.rfind("a.exr: ", 0), 0u) << message;
  }
}

}  // namespace
}  // namespace lambert
