#include "lambert/image/io.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/number.h"
#include "lambert/base/parallel.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/colour.h"
#include "lambert/image/formats/codecs.h"
#include "lambert/image/formats/exif.h"
#include "lambert/image/formats/orientation.h"
#include "lambert/image/stream.h"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>

namespace lambert {
namespace {

struct Format {
  std::vector<std::string> extensions;
  std::vector<Depth> depths;                                                      // the first is what `automatic` means
  std::vector<std::byte> (*encode)(const Image&, const WriteOptions&) = nullptr;  // radiance formats
  std::vector<std::byte> (*encode_display)(const DisplayImage&, const WriteOptions&) = nullptr;  // display formats
  bool keeps_alpha = true;
  bool needs_colour = false;  // has no grey
  bool windows = false;
};

/// Every format has its line here; CONTRIBUTING says how to add one.
const std::vector<Format>& formats() {
  using enum Depth;
  static const std::vector<Format> table{
      {.extensions = {".exr"}, .depths = {automatic, half, full}, .encode = encode_exr, .windows = true},
      {.extensions = {".hdr", ".pic"}, .depths = {automatic}, .encode = encode_rgbe},
      {.extensions = {".pfm"}, .depths = {full}, .encode = encode_pfm},
      {.extensions = {".png"}, .depths = {bits8, bits16}, .encode_display = encode_png},
      {.extensions = {".jpg", ".jpeg"}, .depths = {bits8}, .encode_display = encode_jpeg, .keeps_alpha = false},
      {.extensions = {".tif", ".tiff"}, .depths = {bits16, bits8, full}, .encode_display = encode_tiff},
      {.extensions = {".webp"}, .depths = {bits8}, .encode_display = encode_webp, .needs_colour = true},
  };
  return table;
}

const Format& format_of(const std::filesystem::path& path) {
  std::string extension = format_extension(path);
  if (extension.empty() && is_standard_stream(path)) extension = ".exr";
  for (const Format& f : formats())
    if (std::find(f.extensions.begin(), f.extensions.end(), extension) != f.extensions.end()) return f;
  throw Error(path.string() + ": unknown image format " + unknown_word(extension, image_extensions()));
}

bool starts_with(Bytes data, std::string_view magic) {
  return data.size() >= magic.size() && std::memcmp(data.data(), magic.data(), magic.size()) == 0;
}
bool is_webp(Bytes data) {
  return starts_with(data, "RIFF") && data.size() >= 12 && std::memcmp(data.data() + 8, "WEBP", 4) == 0;
}

using ImageDecoder = Image (*)(Bytes, const std::string&);
using TexelDecoder = Texels (*)(Bytes, const std::string&, DisplayNotes*);

ImageDecoder radiance_decoder(Bytes data) {
  if (is_exr(data)) return decode_exr;
  if (starts_with(data, "#?")) return decode_rgbe;
  if (starts_with(data, "PF") || starts_with(data, "Pf")) return decode_pfm;  // and PF4
  return nullptr;
}
TexelDecoder display_decoder(Bytes data) {
  if (starts_with(data, "\x89PNG")) return decode_png;
  if (starts_with(data, "\xff\xd8")) return decode_jpeg;
  if (starts_with(data, std::string_view("II*\0", 4)) || starts_with(data, std::string_view("MM\0*", 4)))
    return decode_tiff;
  if (is_webp(data)) return decode_webp;
  return nullptr;
}
bool is_image(Bytes data) { return radiance_decoder(data) || display_decoder(data); }
[[noreturn]] void unknown_kind(const std::string& name) {
  decode_error(name, "is none of the known image formats (EXR, HDR, PFM, PNG, JPEG, TIFF, WebP)");
}

std::vector<std::string> channel_names(int channels) {
  if (channels == 1) return {"Y"};
  if (channels == 2) return {"Y", "A"};
  return channels == 3 ? rgb_channels() : rgba_channels();
}

/// Codes with straight alpha to linear light, premultiplied.
Image to_image(const Texels& t, const DisplayNotes& notes) {
  Image image(t.width, t.height, channel_names(t.channels));
  const auto channels = static_cast<std::size_t>(t.channels);
  const bool has_alpha = t.channels == 2 || t.channels == 4;
  const std::size_t colours = has_alpha ? channels - 1 : channels;
  std::array<float, 256> codes{};
  for (std::size_t i = 0; i < codes.size(); ++i)
    codes[i] = notes.exponent > 0 ? std::pow(static_cast<float>(i) / 255, notes.exponent)
                                  : srgb_decode8(static_cast<std::uint8_t>(i));
  const auto linear = [&](float v) {
    if (t.linear) return v;
    return notes.exponent > 0 ? std::copysign(std::pow(std::abs(v), notes.exponent), v) : srgb_decode(v);
  };
  const std::size_t row = static_cast<std::size_t>(t.width) * channels;
  parallel_for(static_cast<std::size_t>(t.height), [&](std::size_t y) {
    const auto pixels = image.pixels();
    for (std::size_t i = y * row; i < (y + 1) * row; i += channels) {
      float alpha = 1;
      if (has_alpha)
        alpha = t.floats.empty() ? static_cast<float>(t.bytes[i + colours]) / 255.0f : t.floats[i + colours];
      const float factor = notes.premultiplied ? 1 : alpha;
      for (std::size_t c = 0; c < colours; ++c)
        pixels[i + c] = factor * (t.floats.empty() ? codes[t.bytes[i + c]] : linear(t.floats[i + c]));
      if (has_alpha) pixels[i + colours] = alpha;
    }
  });
  if (notes.primaries && colours == 3 && !same_primaries(*notes.primaries, rec709)) {
    const glm::dmat3 m = to_rec709(*notes.primaries);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) image.set_rgb(x, y, apply(m, image.rgb(x, y)));
  }
  image.metadata = notes.metadata;
  return image;
}

/// Exposure and speed under the names that OpenEXR has for them.
void note_exif(Image& image, const Exif& exif) {
  const auto note = [&](const char* name, std::optional<double> value) {
    std::string text;
    if (value) append_number(text, static_cast<float>(*value)), image.attributes[name] = {"float", text};
  };
  note("expTime", exif.exposure_time);
  note("aperture", exif.f_number);
  note("isoSpeed", exif.iso);
}

/// How the channels of an image stand in a display file.
struct Shown {
  const Image& image;
  std::optional<std::size_t> alpha;
  bool colour = true;
  std::size_t colours() const { return colour ? 3 : 1; }
  std::size_t channels() const { return colours() + (alpha ? 1 : 0); }

  /// Row y: colours, and alpha behind them.
  void row(int y, float* to) const {
    const std::span<const float> from = image.row(y);
    const std::size_t n = image.channel_count(), shown = channels();
    if (n == shown && colour == image.has_colour() && (!alpha || *alpha + 1 == n)) {
      std::ranges::copy(from, to);
      return;
    }
    for (int x = 0; x < image.width(); ++x, to += shown) {
      const Rgb c = image.rgb(x, y);
      to[0] = c.r;
      if (colour) to[1] = c.g, to[2] = c.b;
      if (alpha) to[colours()] = image.at(x, y, *alpha);
    }
  }
};

/// Colours over alpha; alpha is not negative and a number.
void unpremultiply(std::span<float> row, std::size_t channels) {
  for (std::size_t i = 0; i < row.size(); i += channels) {
    float& a = row[i + channels - 1];
    a = a > 0 ? a : 0.0f;
    for (std::size_t c = 0; a > 0 && c + 1 < channels; ++c) row[i + c] /= a;
  }
}

std::uint8_t code8(float v) { return static_cast<std::uint8_t>(std::round(std::min(v, 1.0f) * 255)); }
/// Of a positive number, that is; what is not is black.
std::uint16_t code16(float v) { return static_cast<std::uint16_t>(std::round(std::min(v, 1.0f) * 65535)); }

/// Linear to sRGB, straight alpha, rounded to the codes of the format; or floats as they are.
DisplayImage to_display(const Image& image, const Format& format, Depth depth) {
  const Shown shown{.image = image,
                    .alpha = format.keeps_alpha ? image.channel("A") : std::nullopt,
                    .colour = image.has_colour() || format.needs_colour};
  const std::size_t channels = shown.channels();
  DisplayImage d{.width = image.width(),
                 .height = image.height(),
                 .channels = static_cast<int>(channels),
                 .metadata = image.metadata};
  const std::size_t row = static_cast<std::size_t>(d.width) * channels;
  const std::size_t size = row * static_cast<std::size_t>(d.height);
  if (depth == Depth::full)
    d.floats.resize(size);
  else if (depth == Depth::bits16)
    d.words.resize(size);
  else
    d.bytes.resize(size);
  parallel_for(static_cast<std::size_t>(d.height), [&](std::size_t y) {
    if (depth == Depth::full) return shown.row(static_cast<int>(y), d.floats.data() + y * row);
    std::vector<float> linear(row);
    shown.row(static_cast<int>(y), linear.data());
    if (shown.alpha) unpremultiply(linear, channels);
    const auto alphas = [&](const auto& code, auto* to) {
      for (std::size_t i = channels - 1; shown.alpha && i < row; i += channels) to[i] = code(linear[i]);
    };
    if (depth == Depth::bits8) {
      std::uint8_t* const to = d.bytes.data() + y * row;
      srgb_encode8(linear, {to, row});
      alphas(code8, to);
    } else {
      std::uint16_t* const to = d.words.data() + y * row;
      for (std::size_t i = 0; i < row; ++i) to[i] = linear[i] > 0 ? code16(srgb_encode(std::min(linear[i], 1.0f))) : 0;
      alphas(code16, to);
    }
  });
  return d;
}

const char* depth_name(Depth depth) {
  switch (depth) {
    case Depth::bits8: return "8 bits";
    case Depth::bits16: return "16 bits";
    case Depth::half: return "half floats";
    case Depth::full: return "floats";
    default: return "numbers of its own";
  }
}

/// The depth that is meant; throws Error when the format has it not.
Depth chosen_depth(const Format& format, Depth depth) {
  if (depth == Depth::automatic) return format.depths.front();
  if (std::ranges::find(format.depths, depth) != format.depths.end()) return depth;
  std::string known;
  for (const Depth d : format.depths)
    if (d != Depth::automatic) known += (known.empty() ? "" : " or ") + std::string(depth_name(d));
  if (known.empty()) known = depth_name(Depth::automatic);
  throw Error("this format stores " + known + ", not " + depth_name(depth));
}

}  // namespace

void decode_error(const std::string& name, const std::string& reason) { throw Error(name + ": " + reason); }

void rethrow_named(const std::string& name) {
  std::string reason;
  try {
    throw;
  } catch (const std::bad_alloc&) {
    reason = "not enough memory";
  } catch (const std::exception& e) {
    reason = e.what();
  }
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw Error(reason.starts_with(name + ":") ? reason : name + ": " + reason);
}

void check_image_size(const std::string& name, std::uint64_t width, std::uint64_t height, std::size_t bytes,
                      std::uint64_t most_pixels_per_byte) {
  constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width == 0 || height == 0) decode_error(name, "its size is " + size);
  if (width > most_pixels || height > most_pixels || width * height > most_pixels)
    decode_error(name, "its size, " + size + ", is above 2^28 pixels");
  if (width * height / most_pixels_per_byte > bytes)
    decode_error(name, "says " + size + " pixels but has only " + std::to_string(bytes) + " bytes");
}

bool is_exr(Bytes data) { return starts_with(data, "\x76\x2f\x31\x01"); }
bool writes_exr(const std::filesystem::path& path) { return format_of(path).encode == encode_exr; }

Image read_image(const std::filesystem::path& path) {
  const MappedFile file = open_input(path);
  return decode_image(file.bytes(), input_name(path));
}

bool is_image_file(const std::filesystem::path& path) {
  if (path == "-") {
    const MappedFile file = open_input(path);
    return is_image(file.bytes());
  }
  std::array<char, 16> start{};
  std::ifstream in(path, std::ios::binary);
  in.read(start.data(), start.size());
  return is_image(
      std::as_bytes(std::span(start)).first(static_cast<std::size_t>(std::max<std::streamsize>(0, in.gcount()))));
}

bool is_radiance_file(const std::filesystem::path& path) {
  const MappedFile file = open_input(path);
  if (!is_image(file.bytes())) unknown_kind(input_name(path));
  return radiance_decoder(file.bytes()) != nullptr;
}

Image decode_image(Bytes data, const std::string& name) {
  if (const auto decode = radiance_decoder(data)) return decode(data, name);
  const auto decode = display_decoder(data);
  if (!decode) unknown_kind(name);
  DisplayNotes notes;
  Texels texels = decode(data, name, &notes);
  const auto exif = read_exif(data);
  if (exif && decode != decode_tiff) texels = oriented(std::move(texels), exif->orientation);
  Image image = to_image(texels, notes);
  if (exif) note_exif(image, *exif);
  return image;
}

Texels decode_texels(Bytes data, const std::string& name) {
  if (const auto decode = display_decoder(data)) return decode(data, name, nullptr);
  const auto decode = radiance_decoder(data);
  if (!decode) unknown_kind(name);
  Image image = decode(data, name);
  if (const Window shown = image.display_window(); shown != image.data_window()) {
    // A small file may place its pixels in a huge picture.
    check_image_size(name, static_cast<std::uint64_t>(shown.width), static_cast<std::uint64_t>(shown.height),
                     data.size() + 4096, 4096);
    image = displayed(std::move(image));
  }
  // Of many layers the colour; they come first.
  const bool colour = image.channel("R") && image.channel("G") && image.channel("B");
  const int channels = colour ? (image.channel("A") ? 4 : 3) : 1;
  Texels t{.width = image.width(), .height = image.height(), .channels = channels, .linear = true};
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < channels; ++c) {
        const float value = image.at(x, y, static_cast<std::size_t>(c));
        if (!std::isfinite(value))
          throw Error(name + ": pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is not finite");
        t.floats.push_back(value);
      }
  return t;
}

namespace {

template <class T>
using Words = std::vector<std::pair<std::string, T>>;
const Words<Depth>& depths() {
  static const Words<Depth> all{{"auto", Depth::automatic},
                                {"8", Depth::bits8},
                                {"16", Depth::bits16},
                                {"half", Depth::half},
                                {"float", Depth::full}};
  return all;
}
const Words<Compression>& compressions() {
  using enum Compression;
  static const Words<Compression> all{{"none", none},   {"rle", rle}, {"zips", zips}, {"zip", zip},   {"piz", piz},
                                      {"pxr24", pxr24}, {"b44", b44}, {"b44a", b44a}, {"dwaa", dwaa}, {"dwab", dwab}};
  return all;
}
template <class T>
std::vector<std::string> words_of(const Words<T>& words) {
  std::vector<std::string> all;
  for (const auto& [word, value] : words) all.push_back(word);
  return all;
}
template <class T>
T value_of(const Words<T>& words, std::string_view word, const std::string& what) {
  for (const auto& [known, value] : words)
    if (known == word) return value;
  throw Error("unknown " + what + " " + unknown_word(word, words_of(words)));
}

}  // namespace

Depth parse_depth(std::string_view word) { return value_of(depths(), word, "depth"); }
Compression parse_compression(std::string_view word) { return value_of(compressions(), word, "compression"); }
std::vector<std::string> depth_words() { return words_of(depths()); }
std::vector<std::string> compression_words() { return words_of(compressions()); }

void check_write_options(const std::filesystem::path& path, const WriteOptions& options) {
  const Format& format = format_of(path);
  try {
    chosen_depth(format, options.depth);
    if (options.quality && (*options.quality < 1 || *options.quality > 100))
      throw Error("a quality is from 1 to 100, not " + std::to_string(*options.quality));
    if (is_standard_stream(path) && ::isatty(standard_output()))
      throw Error("is a terminal, which shows no image: expected a pipe or a file behind '>'");
  } catch (const Error&) {
    rethrow_named(output_name(path));
  }
}

namespace {

std::vector<std::byte> encoded(const Image& image, const Format& format, const WriteOptions& options) {
  if (image.empty()) throw Error("an image without pixels cannot be written");
  const bool cropped = !format.windows && image.data_window() != image.display_window();
  const Image shown = cropped ? displayed(image) : Image();
  const Image& written = cropped ? shown : image;
  return format.encode
             ? format.encode(written, options)
             : format.encode_display(to_display(written, format, chosen_depth(format, options.depth)), options);
}

}  // namespace

std::vector<std::byte> encode_image(const std::filesystem::path& path, const Image& image,
                                    const WriteOptions& options) {
  check_write_options(path, options);
  try {
    return encoded(image, format_of(path), options);
  } catch (const std::exception&) {
    rethrow_named(output_name(path));
  }
}

void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions& options) {
  check_write_options(path, options);
  const Format& format = format_of(path);
  try {
    if (format.encode != encode_exr || image.empty()) return write_atomically(path, encoded(image, format, options));
    // Block by block: the whole file would be as much memory again.
    ImageWriter writer(path, header_of(image), options);
    writer.write(image.pixels());
    writer.close();
  } catch (const std::exception&) {
    rethrow_named(output_name(path));
  }
}

bool is_radiance_format(const std::filesystem::path& path) { return format_of(path).encode != nullptr; }

std::vector<std::string> image_extensions() {
  std::vector<std::string> all;
  for (const Format& f : formats()) all.insert(all.end(), f.extensions.begin(), f.extensions.end());
  return all;
}

}  // namespace lambert
