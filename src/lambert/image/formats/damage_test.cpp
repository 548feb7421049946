#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <map>
#include <sstream>

namespace lambert {
namespace {

/// A small file of each format.
const std::map<std::string, std::string>& samples() {
  static const std::map<std::string, std::string> all = [] {
    const Image image = noise(20, 12, rgb_channels());
    DisplayImage shown{.width = 20, .height = 12, .channels = 3};
    for (const float v : image.pixels()) {
      shown.bytes.push_back(static_cast<std::uint8_t>(255 * v));
      shown.words.push_back(static_cast<std::uint16_t>(65535 * v));
    }
    return std::map<std::string, std::string>{
        {"a.exr", text_of(encode_exr(image))},  {"a.hdr", text_of(encode_rgbe(image))},
        {"a.pfm", text_of(encode_pfm(image))},  {"a.png", text_of(encode_png(shown))},
        {"a.jpg", text_of(encode_jpeg(shown))}, {"a.tif", text_of(encode_tiff(shown))},
        {"a.webp", text_of(encode_webp(shown))}};
  }();
  return all;
}

void read(const std::string& name, const std::string& text) {
  try {
    decode_texels(bytes_of(text), name);
  } catch (const Error& e) {
    EXPECT_EQ(std::string(e.what()).rfind(name + ": ", 0), 0u) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
    throw;
  }
}

TEST(DamagedImages, WholeOnesAreRead) {
  for (const auto& [name, text] : samples()) EXPECT_NO_THROW(read(name, text)) << name;
}

TEST(DamagedImages, EveryTruncationIsRefused) {
  for (const auto& [name, text] : samples()) {
    for (std::size_t length = 0; length < text.size(); length += length + 60 < text.size() ? 7 : 1) {
      EXPECT_THROW(read(name, text.substr(0, length)), Error) << name << " of " << length << " bytes";
    }
  }
}

TEST(DamagedImages, AreReadOrRefused) {
  for (const auto& [name, text] : samples()) {
    SCOPED_TRACE(name);
    expect_survives_damage(text, 300, [&](const std::string& damaged) { read(name, damaged); });
  }
}

/// The most memory the process has held since reset_peak(), in kB.
long peak() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stol(line.substr(6));
  }
  return 0;
}
void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

std::string patched(std::string text, std::size_t at, std::string_view bytes) {
  return text.replace(at, bytes.size(), bytes);
}
/// With a header whose checksum is right.
std::string with_png_header(std::string text, std::string_view size_and_kind) {
  text = patched(text, 16, size_and_kind);
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(text.data()) + 12, 17);
  for (std::size_t i = 0; i < 4; ++i) text[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  return text;
}
std::string huge_exr(std::string text, bool both_windows) {
  for (const char* window : {"dataWindow", "displayWindow"}) {
    if (window[1] == 'i' && !both_windows) continue;
    const std::size_t value = text.find(window) + std::string_view(window).size() + 1 + 6 + 4;  // "box2i", size
    text = patched(text, value + 8, "\xff\xff\xff\x2f");
    text = patched(text, value + 12, "\xff\xff\xff\x2f");
  }
  return text;
}
std::string huge_jpeg(const std::string& text) { return patched(text, text.find("\xff\xc0") + 5, "\xff\xdc\xff\xdc"); }
/// The width, tag 256 of the (little-endian) directory.
std::string huge_tiff(const std::string& text) {
  const std::size_t at = text.rfind(std::string_view("\x00\x01\x03\x00", 4));
  return patched(text, at + 2, std::string_view("\x04\x00\x01\x00\x00\x00\x00\x00\x00\x10", 10));
}

// A few bytes that announce billions of pixels must not cost memory for them.
TEST(DamagedImages, HugeSizesAreRefusedBeforeTheyAreAllocated) {
  const std::map<std::string, std::string> huge = {
      {"a.exr", huge_exr(samples().at("a.exr"), true)},
      {"b.exr", huge_exr(samples().at("a.exr"), false)},
      {"a.hdr", "#?RADIANCE\n\n-Y 2000000000 +X 2000000000\n...."},
      {"b.hdr", "#?RADIANCE\n\n-Y 15000 +X 15000\n...."},
      {"a.pfm", "PF\n90000 90000\n-1\n...."},
      {"a.png", with_png_header(samples().at("a.png"), {"\x00\x00\xff\xff\x00\x00\xff\xff", 8})},
      // 16384x16384 of 16 bits and four channels: more than deflate can pack into 50 kB.
      {"c.png", with_png_header(samples().at("a.png"), {"\0\0\x40\0\0\0\x40\0\x10\x06", 10}) + std::string(50000, '.')},
      {"b.png", samples().at("a.png").substr(0, 33) + std::string("\x70\0\0\0tEXt", 8) + "...."},
      {"a.jpg", huge_jpeg(samples().at("a.jpg"))},
      {"a.tif", huge_tiff(samples().at("a.tif"))},
  };
  for (const auto& [name, text] : huge) {
    reset_peak();
    const long before = peak();
    const std::string message = error_of([&] { read(name, text); });
    EXPECT_LT(peak() - before, 40000) << name << ": " << message;
    if (name == "b.png") {
      EXPECT_NE(message.find("ends at byte"), std::string::npos) << message;
    } else if (name != "a.exr" && name != "b.exr") {
      EXPECT_TRUE(message.find("above 2^28") != std::string::npos || message.find("has only") != std::string::npos)
          << message;
    }
  }
}

}  // namespace
}  // namespace lambert
