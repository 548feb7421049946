#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace lambert {
namespace {

Image read(const std::string& text) { return decode_pfm(bytes_of(text), "a.pfm"); }

// rows: LF-18
TEST(Pfm, TwelveBytesPerPixelBehindAHeader) {
  const Image image = noise(4, 2, rgb_channels());
  const std::string text = text_of(encode_pfm(image));
  const std::string header = "PF\n4 2\n-1.0\n";
  EXPECT_EQ(text.substr(0, header.size()), header);
  EXPECT_EQ(text.size() - header.size(), 96u);
  // Rows stand from the bottom.
  std::uint32_t bits = 0;
  text.copy(reinterpret_cast<char*>(&bits), 4, header.size());
  EXPECT_EQ(std::bit_cast<float>(bits), image.at(0, 1, 0));
}

TEST(Pfm, KeepsEveryBit) {
  for (const std::vector<std::string>& channels : {rgb_channels(), std::vector<std::string>{"Y"}}) {
    Image image = noise(5, 3, channels, 1e9f);
    image.at(0, 0, 0) = std::numeric_limits<float>::infinity();
    image.at(1, 0, 0) = -1e-40f;
    image.at(2, 0, 0) = std::numeric_limits<float>::quiet_NaN();
    const Image back = decode_pfm(encode_pfm(image), "a.pfm");
    EXPECT_EQ(back.channels(), channels);
    ASSERT_EQ(back.pixels().size(), image.pixels().size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) EXPECT_TRUE(same(back.pixels()[i], image.pixels()[i])) << i;
  }
}

TEST(Pfm, BothByteOrders) {
  const std::string big("\x3f\x80\x00\x00\xc0\x00\x00\x00", 8), little("\x00\x00\x80\x3f\x00\x00\x00\xc0", 8);
  for (const Image& image : {read("Pf\n1 2\n1.0\n" + big), read("Pf 1 2 -1\n" + little)}) {
    EXPECT_EQ(image.at(0, 1, 0), 1) << "the bottom row comes first";
    EXPECT_EQ(image.at(0, 0, 0), -2);
  }
}

// rows: LF-18
TEST(Pfm, NumbersAreInUnitsOfTheScale) {
  const Image image = read("Pf 1 2 -0.5\n" + std::string("\x00\x00\x80\x3f\x00\x00\x00\xc0", 8));
  EXPECT_EQ(image.at(0, 1, 0), 0.5f);
  EXPECT_EQ(image.at(0, 0, 0), -1);
}

TEST(Pfm, FourChannelsHaveAlpha) {
  std::string pixel;
  for (const float v : {0.5f, 0.25f, 0.0f, 0.5f}) append(pixel, v);
  const Image image = read("PF4\n1 1\n-1\n" + pixel);
  EXPECT_EQ(image.channels(), rgba_channels());
  EXPECT_EQ(image.rgb(0, 0), Rgb(0.5f, 0.25f, 0));
  EXPECT_EQ(image.at(0, 0, 3), 0.5f);
}

TEST(Pfm, SaysWhatItCannotRead) {
  const std::string pixel(12, '\0');
  for (const auto& [text, part] : {std::pair{std::string("PF\n0 2\n-1\n") + pixel, "size"},
                                   {"PF\n-1 2\n-1\n" + pixel, "size"},
                                   {"PF\nx 2\n-1\n" + pixel, "a width, got 'x'"},
                                   {"PF\n1 1\nnan\n" + pixel, "a scale"},
                                   {"PG\n1 1\n-1\n" + pixel, "PF, Pf or PF4"},
                                   {"PF\n1 1\n0\n" + pixel, "scale that is not 0"},
                                   {"PF4\n1 1\n-1\n" + pixel, "ends at byte"},
                                   {"PF\n1 1\n", "header ends"},
                                   {"PF\n1 2\n-1\n" + pixel, "ends at byte"}}) {
    const std::string message = error_of([&] { read(text); });
    EXPECT_EQ(message.rfind("a.pfm: ", 0), 0u) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace lambert
