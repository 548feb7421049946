#include "lambert/image/formats/codecs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace lambert {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

/// (R, G, B) / 256 2^(E - 128); all zero for E = 0 (E-LF-01).
Rgb decode_pixel(Pixel p) {
  if (p[3] == 0) return {};
  const float scale = std::ldexp(1.0f, static_cast<int>(p[3]) - 136);
  return {scale * p[0], scale * p[1], scale * p[2]};
}

/// Mantissas are rounded to nearest, which brings the mean error to 0; what is negative or not a number becomes 0.
Pixel encode_pixel(Rgb c) {
  const auto usable = [](float v) { return v > 0 ? std::min(v, 1.6e38f) : 0.0f; };
  c = {usable(c.r), usable(c.g), usable(c.b)};
  const float largest = max_component(c);
  if (largest < 1e-32f) return {0, 0, 0, 0};
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (std::ldexp(largest, 8 - exponent) > 255.5f) ++exponent;
  const auto mantissa = [&](float v) { return static_cast<std::uint8_t>(std::lround(std::ldexp(v, 8 - exponent))); };
  return {mantissa(c.r), mantissa(c.g), mantissa(c.b), static_cast<std::uint8_t>(exponent + 128)};
}

class Reader {
 public:
  Reader(Bytes data, std::string name) : data_(data), name_(std::move(name)) {}

  std::string_view line() {
    const std::size_t from = at_;
    while (at_ < data_.size() && static_cast<char>(data_[at_]) != '\n') ++at_;
    if (at_ >= data_.size()) fail("the header ends");
    const std::string_view text(reinterpret_cast<const char*>(data_.data()) + from, at_ - from);
    ++at_;
    return !text.empty() && text.back() == '\r' ? text.substr(0, text.size() - 1) : text;
  }

  std::uint8_t byte() {
    if (at_ >= data_.size()) fail("the pixels end");
    return static_cast<std::uint8_t>(data_[at_++]);
  }
  Pixel pixel() { return {byte(), byte(), byte(), byte()}; }
  Pixel peek() {
    const std::size_t from = at_;
    const Pixel p = pixel();
    at_ = from;
    return p;
  }

  void scanline(std::vector<Pixel>& row) {
    const Pixel start = peek();
    const std::size_t width = row.size();
    const bool new_style = width >= 8 && width < 32768 && start[0] == 2 && start[1] == 2 && start[2] < 128;
    if (!new_style) return old_scanline(row);
    pixel();
    if ((static_cast<std::size_t>(start[2]) << 8 | start[3]) != width) fail("a scan line says another width");
    for (std::size_t component = 0; component < 4; ++component) component_run(row, component);
  }

  [[noreturn]] void fail(const std::string& reason) const {
    decode_error(name_, reason + " at byte " + std::to_string(at_));
  }

 private:
  /// Runs of one component: a count above 128 repeats the next byte, below it copies that many.
  void component_run(std::vector<Pixel>& row, std::size_t component) {
    for (std::size_t x = 0; x < row.size();) {
      std::size_t count = byte();
      const bool repeats = count > 128;
      if (repeats) count -= 128;
      if (count == 0 || count > row.size() - x) fail("a run leaves the scan line");
      const std::uint8_t value = repeats ? byte() : std::uint8_t{0};
      for (; count > 0; --count) row[x++][component] = repeats ? value : byte();
    }
  }

  /// Whole pixels; (1, 1, 1, n) repeats the last one n times, and following such pixels count higher digits of n.
  void old_scanline(std::vector<Pixel>& row) {
    unsigned shift = 0;
    for (std::size_t x = 0; x < row.size();) {
      const Pixel p = pixel();
      if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
        row[x++] = p;
        shift = 0;
        continue;
      }
      const std::size_t count = shift < 32 ? static_cast<std::size_t>(p[3]) << shift : row.size() + 1;
      if (x == 0 || count > row.size() - x) fail("a run leaves the scan line");
      std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
      x += count;
      shift += 8;
    }
  }

  Bytes data_;
  std::string name_;
  std::size_t at_ = 0;
};

/// "-Y 480 +X 640": which axis runs along scan lines, and which way each runs. Standard is -Y +X: rows from the top.
struct Orientation {
  bool x_is_outer = false, x_flipped = false, y_flipped = false;
  int width = 0, height = 0;
};

Orientation parse_orientation(std::string_view line, const std::string& name) {
  const auto wrong = [&] {
    decode_error(name, "expected a size such as '-Y 480 +X 640', got '" + std::string(line.substr(0, 40)) + "'");
  };
  Orientation o;
  for (int axis = 0; axis < 2; ++axis) {
    if (line.size() < 4 || (line[0] != '+' && line[0] != '-') || (line[1] != 'X' && line[1] != 'Y') || line[2] != ' ')
      wrong();
    int size = 0;
    const auto [end, status] = std::from_chars(line.data() + 3, line.data() + line.size(), size);
    if (status != std::errc() || size <= 0) wrong();
    const bool x = line[1] == 'X';
    if ((x ? o.width : o.height) != 0) wrong();
    (x ? o.width : o.height) = size;
    if (axis == 0) o.x_is_outer = x;
    if (x)
      o.x_flipped = line[0] == '-';
    else
      o.y_flipped = line[0] == '+';
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (!line.empty() && line[0] == ' ') line.remove_prefix(1);
  }
  return o;
}

}  // namespace

Image decode_rgbe(Bytes data, const std::string& name) {
  Reader in(data, name);
  const std::string_view magic = in.line();
  if (!magic.starts_with("#?")) decode_error(name, "expected '#?RADIANCE'");
  float exposure = 1;
  for (std::string_view line = in.line(); !line.empty(); line = in.line()) {
    if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
      decode_error(name, "unknown " + std::string(line.substr(0, 60)) + ", expected FORMAT=32-bit_rle_rgbe");
    if (!line.starts_with("EXPOSURE=")) continue;
    float value = 0;
    const char* from = line.data() + 9;
    while (from < line.data() + line.size() && *from == ' ') ++from;
    std::from_chars(from, line.data() + line.size(), value);
    if (!(value > 0) || !std::isfinite(value)) in.fail("EXPOSURE is not positive");
    exposure *= value;  // several multiply
  }
  const Orientation o = parse_orientation(in.line(), name);
  // A run of 127 takes two bytes a component; an old run of 255·256 takes eight.
  check_image_size(name, static_cast<std::uint64_t>(o.width), static_cast<std::uint64_t>(o.height), data.size(), 8192);
  Image image(o.width, o.height, rgb_channels());
  std::vector<Pixel> row(static_cast<std::size_t>(o.x_is_outer ? o.height : o.width));
  const int lines = o.x_is_outer ? o.width : o.height;
  for (int j = 0; j < lines; ++j) {
    in.scanline(row);
    for (int i = 0; i < static_cast<int>(row.size()); ++i) {
      const int x = o.x_is_outer ? j : i, y = o.x_is_outer ? i : j;
      image.set_rgb(o.x_flipped ? o.width - 1 - x : x, o.y_flipped ? o.height - 1 - y : y,
                    decode_pixel(row[static_cast<std::size_t>(i)]) / exposure);
    }
  }
  return image;
}

std::vector<std::byte> encode_rgbe(const Image& image) {
  std::vector<std::byte> out;
  const auto put = [&](std::uint8_t b) { out.push_back(static_cast<std::byte>(b)); };
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height()) + " +X " +
                             std::to_string(image.width()) + "\n";
  for (const char c : header) put(static_cast<std::uint8_t>(c));
  const auto width = static_cast<std::size_t>(image.width());
  const bool compressed = width >= 8 && width < 32768;
  std::vector<Pixel> row(width);
  for (int y = 0; y < image.height(); ++y) {
    for (std::size_t x = 0; x < width; ++x) row[x] = encode_pixel(image.rgb(static_cast<int>(x), y));
    if (!compressed) {
      for (const Pixel& p : row)
        for (const std::uint8_t b : p) put(b);
      continue;
    }
    put(2), put(2), put(static_cast<std::uint8_t>(width >> 8)), put(static_cast<std::uint8_t>(width & 255));
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t x = 0; x < width;) {
        std::size_t run = 1;
        while (x + run < width && run < 127 && row[x + run][c] == row[x][c]) ++run;
        if (run >= 4) {
          put(static_cast<std::uint8_t>(128 + run)), put(row[x][c]);
          x += run;
          continue;
        }
        // Copies until the next run of four begins.
        std::size_t copied = 0;
        const auto run_begins = [&](std::size_t i) {
          return i + 3 < width && row[i][c] == row[i + 1][c] && row[i][c] == row[i + 2][c] &&
                 row[i][c] == row[i + 3][c];
        };
        while (x + copied < width && copied < 128 && !run_begins(x + copied)) ++copied;
        put(static_cast<std::uint8_t>(copied));
        for (std::size_t i = 0; i < copied; ++i) put(row[x + i][c]);
        x += copied;
      }
  }
  return out;
}

}  // namespace lambert
