#include "lambert/base/number.h"
#include "lambert/image/formats/codecs.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <sstream>

namespace lambert {
namespace {

/// The next word of the header: up to 32 characters between white space; the white space behind it is eaten too (one
/// character).
std::string next_word(Bytes data, std::size_t& at, const std::string& name) {
  const auto character = [&] { return static_cast<char>(data[at]); };
  const auto is_space = [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; };
  while (at < data.size() && is_space(character())) ++at;
  std::string word;
  while (at < data.size() && !is_space(character()) && word.size() < 32) word += character(), ++at;
  if (at >= data.size()) decode_error(name, "the header ends at byte " + std::to_string(at));
  ++at;
  return word;
}

float parse_float(const std::string& word, const std::string& what, const std::string& name) {
  std::istringstream in(word);
  in.imbue(std::locale::classic());
  float value = 0;
  if (!(in >> value) || !in.eof()) decode_error(name, "expected " + what + ", got '" + printable(word) + "'");
  return value;
}

float load(const std::byte* at, bool little) {
  std::uint32_t bits;
  std::memcpy(&bits, at, 4);
  if (little != (std::endian::native == std::endian::little)) bits = __builtin_bswap32(bits);
  return std::bit_cast<float>(bits);
}

}  // namespace

/// "PF" colour, "Pf" grey or "PF4" colour with alpha (Augustus), size, scale (negative: little-endian; the numbers are
/// in units of its absolute value), then rows from the bottom.
Image decode_pfm(Bytes data, const std::string& name) {
  std::size_t at = 0;
  const std::string magic = next_word(data, at, name);
  if (magic != "PF" && magic != "Pf" && magic != "PF4")
    decode_error(name, "expected PF, Pf or PF4, got '" + printable(magic) + "'");
  const float width = parse_float(next_word(data, at, name), "a width", name),
              height = parse_float(next_word(data, at, name), "a height", name);
  const float scale = parse_float(next_word(data, at, name), "a scale", name);
  const float unit = std::abs(scale);
  if (!(unit > 0) || !std::isfinite(unit)) decode_error(name, "expected a scale that is not 0");
  const std::vector<std::string> names = magic == "PF"    ? rgb_channels()
                                         : magic == "PF4" ? rgba_channels()
                                                          : std::vector<std::string>{"Y"};
  const std::size_t channels = names.size();
  if (!(width >= 1 && height >= 1 && width < 1e8f && height < 1e8f)) decode_error(name, "the size is not positive");
  const auto w = static_cast<std::uint64_t>(width), h = static_cast<std::uint64_t>(height);
  check_image_size(name, w, h, data.size(), 1);
  if (data.size() - at < w * h * channels * 4)
    decode_error(name, "ends at byte " + std::to_string(data.size()) + ", expected " +
                           std::to_string(at + w * h * channels * 4));
  Image image(static_cast<int>(w), static_cast<int>(h), names);
  const std::byte* from = data.data() + at;
  for (int y = image.height(); y-- > 0;)
    for (float& v : image.row(y)) v = unit * load(from, scale < 0), from += 4;
  return image;
}

std::vector<std::byte> encode_pfm(const Image& image, const WriteOptions&) {
  const bool grey = !image.has_colour();
  const std::string header =
      (grey ? "Pf\n" : "PF\n") + std::to_string(image.width()) + " " + std::to_string(image.height()) + "\n-1.0\n";
  const std::size_t width = static_cast<std::size_t>(image.width()), channels = grey ? 1 : 3;
  std::vector<std::byte> out(header.size() + width * channels * static_cast<std::size_t>(image.height()) * 4);
  std::memcpy(out.data(), header.data(), header.size());
  std::byte* to = out.data() + header.size();
  for (int y = image.height(); y-- > 0;) {
    const std::span<const float> row = image.row(y);
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < channels; ++c, to += 4) {
        std::uint32_t bits = std::bit_cast<std::uint32_t>(row[x * image.channel_count() + c]);
        if (std::endian::native != std::endian::little) bits = __builtin_bswap32(bits);
        std::memcpy(to, &bits, 4);
      }
  }
  return out;
}

}  // namespace lambert
