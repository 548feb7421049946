#include "lambert/base/number.h"
#include "lambert/image/formats/codecs.h"
#include "lambert/image/primaries.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
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

namespace {

/// What the header says of the numbers ("File Formats", Radiance 5).
struct Header {
  double exposure = 1;      // all of them multiplied
  Vec3d correction{1};      // COLORCORR, likewise
  double pixel_height = 1;  // PIXASPECT: height over width, likewise
  double gamma = 0;         // of the writers that have it: code = light^(1/gamma)
  bool xyz = false;
  std::optional<Chromaticities> primaries;
  std::map<std::string, std::string> metadata;
};

/// All `count` numbers of a value; nothing when there are fewer, others or one is not finite.
std::optional<std::vector<double>> numbers(std::string_view text, std::size_t count) {
  std::vector<double> values;
  const char *p = text.data(), *end = p + text.size();
  while (values.size() < count) {
    while (p != end && (*p == ' ' || *p == '\t')) ++p;
    double value = 0;
    p = parse_double(p, end, value);
    if (!p) return std::nullopt;
    values.push_back(value);
  }
  return values;
}

void read_line(std::string_view line, Header& h, const Reader& in) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return;  // a comment or a command that made the picture
  const std::string_view key = line.substr(0, equals);
  std::string_view value = line.substr(equals + 1);
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  const auto positive = [&](std::size_t count) {
    const auto all = numbers(value, count);
    if (!all || std::ranges::any_of(*all, [](double v) { return !(v > 0); }))
      in.fail("expected " + std::string(key) + "=" + (count == 1 ? "a positive number" : "three positive numbers") +
              ", got '" + printable(value) + "'");
    return *all;
  };
  if (key == "FORMAT") {
    h.xyz = value == "32-bit_rle_xyze";
    if (!h.xyz && value != "32-bit_rle_rgbe")
      in.fail("unknown FORMAT=" + printable(value) + ", expected 32-bit_rle_rgbe or 32-bit_rle_xyze");
  } else if (key == "EXPOSURE") {
    h.exposure *= positive(1)[0];
  } else if (key == "COLORCORR") {
    const auto v = positive(3);
    h.correction *= Vec3d(v[0], v[1], v[2]);
  } else if (key == "PIXASPECT") {
    h.pixel_height *= positive(1)[0];
  } else if (key == "GAMMA") {
    h.gamma = positive(1)[0];
  } else if (key == "PRIMARIES") {
    const auto v = numbers(value, 8);
    if (!v) in.fail("expected eight chromaticities, got '" + printable(value) + "'");
    const std::vector<double>& p = *v;
    h.primaries = Chromaticities{{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}, {p[6], p[7]}};
  } else if (key == "SOFTWARE" || key == "VIEW" || key == "OWNER" || key == "CAPDATE") {
    h.metadata[std::string(key)] = std::string(value);
  }
}

/// From the file's colours to Rec. 709. XYZ is as measured; its file's PRIMARIES, where there are any, say only which
/// white is to become white.
std::optional<glm::dmat3> conversion(const Header& h) {
  if (h.xyz) {
    if (!h.primaries) return to_rec709(cie_xyz);
    return to_rec709(*h.primaries) * glm::inverse(rgb_to_xyz(*h.primaries));
  }
  if (!h.primaries || same_primaries(*h.primaries, rec709)) return std::nullopt;
  return to_rec709(*h.primaries);
}

Image decode(Bytes data, const std::string& name) {
  Reader in(data, name);
  const std::string_view magic = in.line();
  if (!magic.starts_with("#?")) decode_error(name, "expected '#?RADIANCE'");
  Header header;
  for (std::string_view line = in.line(); !line.empty(); line = in.line()) read_line(line, header, in);
  const std::optional<glm::dmat3> matrix = conversion(header);
  const Orientation o = parse_orientation(in.line(), name);
  // A run of 127 takes two bytes a component; an old run of 255·256 takes eight.
  check_image_size(name, static_cast<std::uint64_t>(o.width), static_cast<std::uint64_t>(o.height), data.size(), 8192);
  Image image(o.width, o.height, rgb_channels());
  image.metadata = header.metadata;
  if (header.pixel_height != 1) image.attributes["pixelAspectRatio"] = {"float", number_text(1 / header.pixel_height)};
  // To radiance: what the header says was multiplied in is divided out.
  const Vec3 unit = Vec3(1.0 / (header.exposure * header.correction));
  if (!is_finite(unit)) in.fail("EXPOSURE and COLORCORR together are out of range");
  const Mat3 to_709 = matrix ? Mat3(*matrix) : Mat3(1);
  const float gamma = static_cast<float>(header.gamma);
  const auto radiance = [&](Pixel p) {
    Rgb c = decode_pixel(p);
    if (gamma > 0 && gamma != 1) c = {std::pow(c.r, gamma), std::pow(c.g, gamma), std::pow(c.b, gamma)};
    c = c * Rgb(unit.x, unit.y, unit.z);
    if (!matrix) return c;
    const Vec3 v = to_709 * Vec3(c.r, c.g, c.b);
    return Rgb(v.x, v.y, v.z);
  };
  std::vector<Pixel> row(static_cast<std::size_t>(o.x_is_outer ? o.height : o.width));
  const int lines = o.x_is_outer ? o.width : o.height;
  for (int j = 0; j < lines; ++j) {
    in.scanline(row);
    for (int i = 0; i < static_cast<int>(row.size()); ++i) {
      const int x = o.x_is_outer ? j : i, y = o.x_is_outer ? i : j;
      image.set_rgb(o.x_flipped ? o.width - 1 - x : x, o.y_flipped ? o.height - 1 - y : y,
                    radiance(row[static_cast<std::size_t>(i)]));
    }
  }
  return image;
}

}  // namespace

Image decode_rgbe(Bytes data, const std::string& name) {
  try {
    return decode(data, name);
  } catch (const std::exception&) {
    rethrow_named(name);
  }
}

namespace {

/// Software, view, shape of the pixels and primaries, for Radiance's own are others; not what would end the line.
std::string header_lines(const Image& image) {
  std::string lines;
  for (const auto& [key, line] : {std::pair{"SOFTWARE", "SOFTWARE"}, {"software", "SOFTWARE"}, {"VIEW", "VIEW"}})
    if (const auto text = image.metadata.find(key); text != image.metadata.end() && !text->second.empty()) {
      lines += std::string(line) + "=";
      for (const char c : text->second) lines += c == '\n' || c == '\r' ? ' ' : c;
      lines += "\n";
    }
  const auto aspect = image.attributes.find("pixelAspectRatio");
  double ratio = 0;
  if (aspect != image.attributes.end() &&
      parse_double(aspect->second.value.data(), aspect->second.value.data() + aspect->second.value.size(), ratio) &&
      ratio > 0)
    lines += "PIXASPECT=" + number_text(1 / ratio) + "\n";
  return lines + "PRIMARIES=" + text_of(rec709) + "\n";
}

}  // namespace

std::vector<std::byte> encode_rgbe(const Image& image, const WriteOptions&) {
  std::vector<std::byte> out;
  const auto put = [&](std::uint8_t b) { out.push_back(static_cast<std::byte>(b)); };
  const std::string header = "#?RADIANCE\n" + header_lines(image) + "FORMAT=32-bit_rle_rgbe\n\n-Y " +
                             std::to_string(image.height()) + " +X " + std::to_string(image.width()) + "\n";
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
