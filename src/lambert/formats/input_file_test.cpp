#include "lambert/formats/input_file.h"

#include "lambert/formats/format_test_tools.h"

#include <zlib.h>

#include <gtest/gtest.h>

namespace lambert {
namespace {

std::string gzip(const std::string& text) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string inflate(const std::string& data, std::size_t cap = max_inflated_bytes) {
  return inflate_gzip(std::as_bytes(std::span(data.data(), data.size())), "x.gz", cap);
}

std::string long_text() {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += std::to_string(i) + " ";
  return text;
}

TEST(InputFile, InflatesAllMembers) {
  const std::string text = long_text();
  EXPECT_EQ(inflate(gzip(text)), text);
  EXPECT_EQ(inflate(gzip("one ") + gzip("two")), "one two");
  EXPECT_EQ(inflate(gzip("")), "");
}

TEST(InputFile, StopsAtTheCap) {
  const std::string bomb = gzip(std::string(20'000'000, 'x'));
  EXPECT_LT(bomb.size(), 40000u);
  const std::string message = error_of([&] { inflate(bomb, 1'000'000); });
  EXPECT_NE(message.find("x.gz"), std::string::npos) << message;
  EXPECT_NE(message.find("more than 1000000 bytes"), std::string::npos) << message;
  EXPECT_EQ(inflate(gzip(std::string(1000, 'x')), 1000).size(), 1000u);
}

TEST(InputFile, RefusesDamage) {
  const std::string whole = gzip(long_text());
  EXPECT_NE(error_of([&] { inflate(whole.substr(0, whole.size() / 2)); }).find("ends too early"), std::string::npos);
  std::string broken = whole;
  for (std::size_t i = 100; i < 200; ++i) broken[i] = static_cast<char>(~broken[i]);
  EXPECT_NE(error_of([&] { inflate(broken); }).find("gzip data at byte"), std::string::npos);
}

TEST(InputFile, FindsGzipByContent) {
  const TemporaryFolder folder;
  EXPECT_EQ(InputFile(folder.write("a", gzip("hello"))).text(), "hello");
  EXPECT_EQ(InputFile(folder.write("b.gz", "hello")).text(), "hello");
  EXPECT_EQ(InputFile(folder.write("c", "")).text(), "");
}

}  // namespace
}  // namespace lambert
