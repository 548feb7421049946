#include "lambert/image/io.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/colour.h"
#include "lambert/image/formats/codecs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <new>

namespace lambert {
namespace {

struct Format {
  std::vector<std::string> extensions;
  bool radiance = false;
  std::vector<std::byte> (*encode)(const Image&) = nullptr;                 // radiance formats
  std::vector<std::byte> (*encode_display)(const DisplayImage&) = nullptr;  // display formats
  bool sixteen_bits = false;
  bool keeps_alpha = true;
  bool needs_colour = false;  // has no grey
};

/// Every format has its line here; CONTRIBUTING says how to add one.
const std::vector<Format>& formats() {
  static const std::vector<Format> table{
      {.extensions = {".exr"}, .radiance = true, .encode = encode_exr},
      {.extensions = {".hdr", ".pic"}, .radiance = true, .encode = encode_rgbe},
      {.extensions = {".pfm"}, .radiance = true, .encode = encode_pfm},
      {.extensions = {".png"}, .encode_display = encode_png},
      {.extensions = {".jpg", ".jpeg"}, .encode_display = encode_jpeg, .keeps_alpha = false},
      {.extensions = {".tif", ".tiff"}, .encode_display = encode_tiff, .sixteen_bits = true},
      {.extensions = {".webp"}, .encode_display = encode_webp, .needs_colour = true},
  };
  return table;
}

const Format& format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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
using TexelDecoder = Texels (*)(Bytes, const std::string&);

ImageDecoder radiance_decoder(Bytes data) {
  if (starts_with(data, "\x76\x2f\x31\x01")) return decode_exr;
  if (starts_with(data, "#?")) return decode_rgbe;
  if (starts_with(data, "PF") || starts_with(data, "Pf")) return decode_pfm;
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
[[noreturn]] void unknown_kind(const std::string& name) {
  decode_error(name, "is none of the known image formats (EXR, HDR, PFM, PNG, JPEG, TIFF, WebP)");
}

std::vector<std::string> channel_names(int channels) {
  if (channels == 1) return {"Y"};
  if (channels == 2) return {"Y", "A"};
  return channels == 3 ? rgb_channels() : rgba_channels();
}

/// sRGB with straight alpha to linear light, premultiplied.
Image to_image(const Texels& t) {
  Image image(t.width, t.height, channel_names(t.channels));
  const auto channels = static_cast<std::size_t>(t.channels);
  const bool has_alpha = t.channels == 2 || t.channels == 4;
  const std::size_t colours = has_alpha ? channels - 1 : channels;
  const auto pixels = image.pixels();
  for (std::size_t i = 0; i < pixels.size(); i += channels) {
    const auto stored = [&](std::size_t c) {
      return t.floats.empty() ? static_cast<float>(t.bytes[i + c]) / 255.0f : t.floats[i + c];
    };
    const float alpha = has_alpha ? stored(colours) : 1;
    for (std::size_t c = 0; c < colours; ++c) {
      const float linear = !t.floats.empty() ? (t.linear ? t.floats[i + c] : srgb_decode(t.floats[i + c]))
                                             : srgb_decode8(t.bytes[i + c]);
      pixels[i + c] = linear * alpha;
    }
    if (has_alpha) pixels[i + colours] = alpha;
  }
  return image;
}

/// Linear to sRGB, straight alpha, rounded to the codes of the format.
DisplayImage to_display(const Image& image, const Format& format) {
  const auto alpha = format.keeps_alpha ? image.channel("A") : std::nullopt;
  const bool colour = image.has_colour() || format.needs_colour;
  DisplayImage d{.width = image.width(),
                 .height = image.height(),
                 .channels = (colour ? 3 : 1) + (alpha ? 1 : 0),
                 .metadata = image.metadata};
  const float top = format.sixteen_bits ? 65535.0f : 255.0f;
  const auto put = [&](float v) {
    const float code = std::round(std::clamp(v, 0.0f, 1.0f) * top);
    if (format.sixteen_bits)
      d.words.push_back(static_cast<std::uint16_t>(code));
    else
      d.bytes.push_back(static_cast<std::uint8_t>(code));
  };
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const float a = alpha ? image.at(x, y, *alpha) : 1;
      Rgb c = image.rgb(x, y);
      if (alpha && a > 0) c = c / a;
      // clamp() keeps NaN, which no code stands for: black.
      const auto shown = [](float v) { return srgb_encode(v > 0 ? std::min(v, 1.0f) : 0.0f); };
      put(shown(c.r));
      if (colour) put(shown(c.g)), put(shown(c.b));
      if (alpha) put(a > 0 ? a : 0.0f);
    }
  return d;
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

Image read_image(const std::filesystem::path& path) {
  const MappedFile file(path);
  const Bytes data = file.bytes();
  if (const auto decode = radiance_decoder(data)) return decode(data, path.string());
  if (const auto decode = display_decoder(data)) return to_image(decode(data, path.string()));
  unknown_kind(path.string());
}

Texels decode_texels(Bytes data, const std::string& name) {
  if (const auto decode = display_decoder(data)) return decode(data, name);
  const auto decode = radiance_decoder(data);
  if (!decode) unknown_kind(name);
  const Image image = decode(data, name);
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

void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions&) {
  const Format& format = format_of(path);
  try {
    if (image.empty()) throw Error("an image without pixels cannot be written");
    write_atomically(path, format.radiance ? format.encode(image) : format.encode_display(to_display(image, format)));
  } catch (const std::exception&) {
    rethrow_named(path.string());
  }
}

bool is_radiance_format(const std::filesystem::path& path) { return format_of(path).radiance; }

std::vector<std::string> image_extensions() {
  std::vector<std::string> all;
  for (const Format& f : formats()) all.insert(all.end(), f.extensions.begin(), f.extensions.end());
  return all;
}

}  // namespace lambert
