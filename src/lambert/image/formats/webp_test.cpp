#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>
#include <webp/encode.h>

namespace lambert {
namespace {

TEST(Webp, IsWrittenWithoutLoss) {
  for (const int channels : {3, 4}) {
    DisplayImage shown{.width = 9, .height = 5, .channels = channels};
    for (int i = 0; i < 45 * channels; ++i) shown.bytes.push_back(static_cast<std::uint8_t>(1 + i * 37 % 255));
    const Texels t = decode_webp(encode_webp(shown), "a.webp");
    EXPECT_EQ(t.width, 9);
    EXPECT_EQ(t.height, 5);
    EXPECT_EQ(t.channels, channels);
    EXPECT_EQ(t.bytes, shown.bytes);
  }
}

TEST(Webp, LossyOnesAreRead) {
  std::vector<std::uint8_t> grey(32 * 32 * 4, 128);
  std::uint8_t* buffer = nullptr;
  const std::size_t size = WebPEncodeRGBA(grey.data(), 32, 32, 128, 90, &buffer);
  const std::string text(reinterpret_cast<const char*>(buffer), size);
  WebPFree(buffer);
  const Texels t = decode_webp(bytes_of(text), "a.webp");
  ASSERT_EQ(t.channels, 4);
  for (const std::uint8_t code : t.bytes) ASSERT_NEAR(code, 128, 3);
}

TEST(Webp, WhatIsShorterThanItSaysIsRefused) {
  DisplayImage shown{.width = 2, .height = 2, .channels = 3, .bytes = std::vector<std::uint8_t>(12, 9)};
  const auto bytes = encode_webp(shown);
  const std::string message = error_of([&] { decode_webp(Bytes(bytes).subspan(0, bytes.size() - 1), "a.webp"); });
  EXPECT_EQ(message.rfind("a.webp: ends at byte", 0), 0u) << message;
}

}  // namespace
}  // namespace lambert
