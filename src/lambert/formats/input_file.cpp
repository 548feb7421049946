#include "lambert/formats/input_file.h"

#include "lambert/base/error.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>

namespace lambert {
namespace {

constexpr std::size_t piece_size = std::size_t{1} << 16;

struct EndInflate {
  void operator()(z_stream* s) const { inflateEnd(s); }
};

}  // namespace

bool is_gzip(std::span<const std::byte> data) {
  return data.size() >= 2 && data[0] == std::byte{0x1f} && data[1] == std::byte{0x8b};
}

std::string inflate_gzip(std::span<const std::byte> data, const std::string& name, std::size_t max_bytes) {
  z_stream stream{};
  std::size_t offset = 0;
  const auto fail = [&](const std::string& why) {
    throw Error(name + ": gzip data at byte " + std::to_string(offset) + ": " + why);
  };
  if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) throw Error(name + ": cannot start zlib");
  const std::unique_ptr<z_stream, EndInflate> ends(&stream);

  std::string out;
  std::array<char, piece_size> piece;
  for (;;) {
    const std::size_t input = std::min(piece_size, data.size() - offset);
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(data.data() + offset));
    stream.avail_in = static_cast<uInt>(input);
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = piece_size;
    const int status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t consumed = input - stream.avail_in, produced = piece_size - stream.avail_out;
    if (produced > max_bytes - out.size()) fail("inflates to more than " + std::to_string(max_bytes) + " bytes");
    out.append(piece.data(), produced);
    offset += consumed;
    if (status == Z_STREAM_END) {
      // Another member may follow; anything else behind the end is padding.
      if (!is_gzip(data.subspan(offset))) return out;
      inflateReset(&stream);
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      fail(stream.msg ? stream.msg : "is damaged");
    } else if (consumed == 0 && produced == 0) {
      fail("ends too early");
    }
  }
}

InputFile::InputFile(const std::filesystem::path& path) : mapped_(path) {
  if (is_gzip(mapped_.bytes())) inflated_ = inflate_gzip(mapped_.bytes(), path.string());
}

}  // namespace lambert
