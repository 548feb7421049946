#include "lambert/base/error.h"
#include "lambert/image/formats/codecs.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

namespace lambert {
namespace {

struct Memory {
  Bytes input;                    // when reading
  std::vector<std::byte> output;  // when writing
  std::size_t at = 0;
  std::size_t size() const { return input.empty() ? output.size() : input.size(); }
};

tmsize_t read_memory(thandle_t handle, void* to, tmsize_t count) {
  auto& m = *static_cast<Memory*>(handle);
  const auto& source = m.input.empty() ? Bytes(m.output) : m.input;
  const std::size_t n =
      std::min(static_cast<std::size_t>(std::max<tmsize_t>(0, count)), source.size() - std::min(m.at, source.size()));
  if (n) std::memcpy(to, source.data() + m.at, n);
  m.at += n;
  return static_cast<tmsize_t>(n);
}
tmsize_t write_memory(thandle_t handle, void* from, tmsize_t count) {
  auto& m = *static_cast<Memory*>(handle);
  const auto n = static_cast<std::size_t>(count);
  if (m.output.size() < m.at + n) m.output.resize(m.at + n);
  std::memcpy(m.output.data() + m.at, from, n);
  m.at += n;
  return count;
}
toff_t seek_memory(thandle_t handle, toff_t offset, int whence) {
  auto& m = *static_cast<Memory*>(handle);
  const toff_t base = whence == SEEK_CUR ? m.at : whence == SEEK_END ? m.size() : 0;
  m.at = static_cast<std::size_t>(base + offset);
  return m.at;
}
int close_memory(thandle_t) { return 0; }
/// libtiff 4.5 refuses uncompressed tiles below 1 kB that it has to read in pieces.
int map_memory(thandle_t handle, void** base, toff_t* size) {
  const auto& m = *static_cast<Memory*>(handle);
  *base = const_cast<std::byte*>(m.input.data());  // which libtiff does not write to
  *size = m.input.size();
  return !m.input.empty();
}
void unmap_memory(thandle_t, void*, toff_t) {}
toff_t size_memory(thandle_t handle) { return static_cast<Memory*>(handle)->size(); }

/// libtiff prints to standard error unless told otherwise; the first complaint of a thread is kept for the Error.
thread_local std::string complaint;
void keep_complaint(const char*, const char* format, va_list arguments) {
  if (!complaint.empty()) return;
  char text[256];
  std::vsnprintf(text, sizeof text, format, arguments);
  complaint = text;
}

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;
Tiff open(Memory& memory, const char* mode) {
  TIFFSetErrorHandler(keep_complaint);
  TIFFSetWarningHandler(nullptr);
  complaint.clear();
  // Strips and tiles of a damaged file may claim any size.
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t{1} << 30);
  return {TIFFClientOpenExt("memory", mode, &memory, read_memory, write_memory, seek_memory, close_memory, size_memory,
                            map_memory, unmap_memory, options.get()),
          TIFFClose};
}

template <class T>
T field(TIFF* tiff, std::uint32_t tag, T fallback) {
  T value = fallback;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// What the first extra sample is; nothing without one.
std::optional<std::uint16_t> kind_of_alpha(TIFF* tiff) {
  std::uint16_t count = 0, *kinds = nullptr;
  if (!TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &count, &kinds) || count == 0) return std::nullopt;
  return kinds[0];
}

/// Divides colours by alpha, the last channel.
void make_straight(Texels& t) {
  const auto channels = static_cast<std::size_t>(t.channels);
  for (std::size_t i = 0; i + channels <= t.bytes.size(); i += channels) {
    const unsigned alpha = t.bytes[i + channels - 1];
    for (std::size_t c = 0; alpha > 0 && c + 1 < channels; ++c)
      t.bytes[i + c] = static_cast<std::uint8_t>(std::min(255u, (t.bytes[i + c] * 255u + alpha / 2) / alpha));
  }
  for (std::size_t i = 0; i + channels <= t.floats.size(); i += channels) {
    const float alpha = t.floats[i + channels - 1];
    for (std::size_t c = 0; alpha > 0 && c + 1 < channels; ++c) t.floats[i + c] /= alpha;
  }
}

template <class T>
std::vector<T> oriented(const std::vector<T>& stored, std::size_t width, std::size_t height, std::size_t channels,
                        int orientation) {
  // Tag 274: where row 0 and column 0 are seen. From LEFTTOP on, rows are seen as columns.
  const bool turned = orientation >= ORIENTATION_LEFTTOP;
  const bool mirrored = orientation == ORIENTATION_TOPRIGHT || orientation == ORIENTATION_BOTRIGHT ||
                        orientation == ORIENTATION_RIGHTTOP || orientation == ORIENTATION_RIGHTBOT;
  const bool upside_down = orientation == ORIENTATION_BOTRIGHT || orientation == ORIENTATION_BOTLEFT ||
                           orientation == ORIENTATION_RIGHTBOT || orientation == ORIENTATION_LEFTBOT;
  const std::size_t seen_width = turned ? height : width, seen_height = turned ? width : height;
  std::vector<T> seen;
  seen.reserve(stored.size());
  for (std::size_t y = 0; y < seen_height && !stored.empty(); ++y)
    for (std::size_t x = 0; x < seen_width; ++x) {
      const std::size_t i = mirrored ? seen_width - 1 - x : x, j = upside_down ? seen_height - 1 - y : y;
      const std::size_t at = (turned ? i * width + j : j * width + i) * channels;
      seen.insert(seen.end(), stored.begin() + static_cast<std::ptrdiff_t>(at),
                  stored.begin() + static_cast<std::ptrdiff_t>(at + channels));
    }
  return seen;
}

Texels oriented(Texels t, int orientation) {
  if (orientation <= ORIENTATION_TOPLEFT || orientation > ORIENTATION_LEFTBOT) return t;
  const auto width = static_cast<std::size_t>(t.width), height = static_cast<std::size_t>(t.height);
  const auto channels = static_cast<std::size_t>(t.channels);
  t.bytes = oriented(t.bytes, width, height, channels, orientation);
  t.floats = oriented(t.floats, width, height, channels, orientation);
  if (orientation >= ORIENTATION_LEFTTOP) std::swap(t.width, t.height);
  return t;
}

Texels decode_strips(TIFF* tiff, const std::string& name, int width, int height, int channels, int bits) {
  const std::size_t row_values = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  const auto row_bytes = static_cast<std::size_t>(std::max<tmsize_t>(0, TIFFScanlineSize(tiff)));
  if (row_bytes < row_values * static_cast<std::size_t>(bits) / 8)
    decode_error(name, "its rows are shorter than its width");
  Texels t{.width = width, .height = height, .channels = channels, .linear = bits == 32};
  std::vector<std::uint8_t> row(row_bytes);
  for (int y = 0; y < height; ++y) {
    if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(y)) < 0)
      decode_error(name, complaint + " in row " + std::to_string(y));
    if (bits == 8) t.bytes.insert(t.bytes.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(row_values));
    for (std::size_t i = 0; bits > 8 && i < row_values; ++i) {
      float value = 0;
      std::uint16_t word = 0;
      if (bits == 32) std::memcpy(&value, row.data() + 4 * i, 4);
      if (bits == 16) std::memcpy(&word, row.data() + 2 * i, 2), value = static_cast<float>(word) / 65535.0f;
      t.floats.push_back(value);
    }
  }
  if (channels % 2 == 0 && kind_of_alpha(tiff) == EXTRASAMPLE_ASSOCALPHA) make_straight(t);
  return t;
}

/// Tiles, palettes, planes and rare colour spaces, through libtiff's own conversion to 8-bit RGBA.
Texels decode_rgba(TIFF* tiff, const std::string& name, int width, int height, std::uint16_t orientation) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint32_t> pixels(count);
  if (!TIFFReadRGBAImageOriented(tiff, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                                 pixels.data(), orientation, 1))
    decode_error(name, complaint.empty() ? "its kind of pixels is not supported" : complaint);
  const auto alpha = kind_of_alpha(tiff);
  Texels t{.width = width, .height = height, .channels = alpha ? 4 : 3};
  t.bytes.reserve(static_cast<std::size_t>(t.channels) * count);
  for (const std::uint32_t p : pixels) {
    for (const std::uint32_t c : {TIFFGetR(p), TIFFGetG(p), TIFFGetB(p)})
      t.bytes.push_back(static_cast<std::uint8_t>(c));
    if (alpha) t.bytes.push_back(static_cast<std::uint8_t>(TIFFGetA(p)));
  }
  if (alpha && *alpha != EXTRASAMPLE_UNSPECIFIED) make_straight(t);  // libtiff multiplies what is not yet
  return t;
}

}  // namespace

Texels decode_tiff(Bytes data, const std::string& name) {
  Memory memory{.input = data};
  const Tiff tiff = open(memory, "r");
  if (!tiff) decode_error(name, complaint.empty() ? "is not a TIFF file" : complaint);
  const auto width = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGEWIDTH, 0),
             height = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGELENGTH, 0);
  check_image_size(name, width, height, data.size(), 16384);
  const auto bits = field<std::uint16_t>(tiff.get(), TIFFTAG_BITSPERSAMPLE, 1),
             channels = field<std::uint16_t>(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto format = field<std::uint16_t>(tiff.get(), TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT),
             plane = field<std::uint16_t>(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  const auto photometric = field<std::uint16_t>(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  const bool plain =
      !TIFFIsTiled(tiff.get()) && plane == PLANARCONFIG_CONTIG &&
      ((photometric == PHOTOMETRIC_RGB && (channels == 3 || channels == 4)) ||
       (photometric == PHOTOMETRIC_MINISBLACK && (channels == 1 || channels == 2))) &&
      ((format == SAMPLEFORMAT_UINT && (bits == 8 || bits == 16)) || (format == SAMPLEFORMAT_IEEEFP && bits == 32));
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  const auto orientation = field<std::uint16_t>(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  return oriented(
      plain ? decode_strips(tiff.get(), name, w, h, channels, bits) : decode_rgba(tiff.get(), name, w, h, orientation),
      orientation);
}

std::vector<std::byte> encode_tiff(const DisplayImage& image) {
  Memory memory;
  {
    const Tiff tiff = open(memory, "wm");
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, image.channels);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, image.channels >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff.get(), 0));
    std::uint16_t straight_alpha = EXTRASAMPLE_UNASSALPHA;
    if (image.channels == 2 || image.channels == 4) TIFFSetField(tiff.get(), TIFFTAG_EXTRASAMPLES, 1, &straight_alpha);
    const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    for (int y = 0; y < image.height; ++y) {
      auto* from = const_cast<std::uint16_t*>(image.words.data()) + static_cast<std::size_t>(y) * row;
      if (TIFFWriteScanline(tiff.get(), from, static_cast<std::uint32_t>(y), 0) < 0) throw Error("TIFF: " + complaint);
    }
  }
  return std::move(memory.output);
}

}  // namespace lambert
