#include "lambert/base/error.h"
#include "lambert/image/formats/codecs.h"
#include "lambert/image/formats/orientation.h"

#include <half.h>
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

/// How a file stores its samples.
struct Layout {
  int width = 0, height = 0, samples = 0, bits = 0;
  bool floating = false, planes = false;
  std::size_t sample_bytes() const { return static_cast<std::size_t>(bits) / 8; }
  std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(samples) * sample_bytes();
  }
};

/// All samples as they are stored, interleaved.
using Samples = std::vector<std::uint8_t>;

/// Puts `count` samples of one plane (or all planes, when they are interleaved) into row y from column x.
void put_row(Samples& to, const Layout& l, const std::uint8_t* from, int x, int y, std::size_t columns, int plane) {
  const std::size_t size = l.sample_bytes(), pixel = static_cast<std::size_t>(l.samples) * size;
  std::uint8_t* row = to.data() + static_cast<std::size_t>(y) * l.row_bytes() + static_cast<std::size_t>(x) * pixel;
  if (!l.planes) {
    std::memcpy(row, from, columns * pixel);
    return;
  }
  for (std::size_t i = 0; i < columns; ++i)
    std::memcpy(row + i * pixel + static_cast<std::size_t>(plane) * size, from + i * size, size);
}

void read_strips(TIFF* tiff, const std::string& name, const Layout& l, Samples& to) {
  const auto stored = static_cast<std::size_t>(std::max<tmsize_t>(0, TIFFScanlineSize(tiff)));
  const std::size_t planes = l.planes ? static_cast<std::size_t>(l.samples) : 1;
  if (stored < l.row_bytes() / planes) decode_error(name, "its rows are shorter than its width");
  std::vector<std::uint8_t> row(stored);
  for (std::size_t plane = 0; plane < planes; ++plane)
    for (int y = 0; y < l.height; ++y) {
      if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(y), static_cast<std::uint16_t>(plane)) < 0)
        decode_error(name, complaint + " in row " + std::to_string(y));
      put_row(to, l, row.data(), 0, y, static_cast<std::size_t>(l.width), static_cast<int>(plane));
    }
}

void read_tiles(TIFF* tiff, const std::string& name, const Layout& l, Samples& to) {
  const auto tile_width = field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0),
             tile_height = field<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0);
  check_image_size(name, tile_width, tile_height, to.size() + 65536, 4096);
  const int planes = l.planes ? l.samples : 1;
  const auto size = static_cast<std::size_t>(std::max<tmsize_t>(0, TIFFTileSize(tiff)));
  const std::size_t tile_row =
      static_cast<std::size_t>(tile_width) * l.sample_bytes() * static_cast<std::size_t>(l.planes ? 1 : l.samples);
  if (size < tile_row * tile_height) decode_error(name, "its tiles are smaller than their size");
  std::vector<std::uint8_t> tile(size);
  for (int plane = 0; plane < planes; ++plane)
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(l.height); y += tile_height)
      for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(l.width); x += tile_width) {
        if (TIFFReadTile(tiff, tile.data(), x, y, 0, static_cast<std::uint16_t>(plane)) < 0)
          decode_error(name, complaint + " in the tile at " + std::to_string(x) + ", " + std::to_string(y));
        const std::uint32_t columns = std::min(tile_width, static_cast<std::uint32_t>(l.width) - x);
        const std::uint32_t rows = std::min(tile_height, static_cast<std::uint32_t>(l.height) - y);
        for (std::uint32_t j = 0; j < rows; ++j)
          put_row(to, l, tile.data() + j * tile_row, static_cast<int>(x), static_cast<int>(y + j), columns, plane);
      }
}

/// A sample as a number: integers over their largest value.
float number(const std::uint8_t* from, const Layout& l) {
  const auto load = [from]<class T>(T value) {
    std::memcpy(&value, from, sizeof value);
    return value;
  };
  if (l.floating) {
    if (l.bits == 16) {
      half h;
      h.setBits(load(std::uint16_t{}));
      return h;
    }
    return l.bits == 32 ? load(0.0f) : static_cast<float>(load(0.0));
  }
  if (l.bits == 16) return static_cast<float>(load(std::uint16_t{})) / 65535.0f;
  return static_cast<float>(static_cast<double>(load(std::uint32_t{})) / 4294967295.0);
}

/// Alpha beside `colours` colours: its place among the samples, and whether the colours are multiplied by it.
struct Alpha {
  int sample = 0;
  bool premultiplied = false;
};
std::optional<Alpha> find_alpha(TIFF* tiff, int samples, int colours) {
  std::uint16_t count = 0, *kinds = nullptr;
  if (!TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &count, &kinds)) count = 0;
  for (int i = 0; i < count && colours + i < samples; ++i)
    if (kinds[i] == EXTRASAMPLE_ASSOCALPHA || kinds[i] == EXTRASAMPLE_UNASSALPHA)
      return Alpha{colours + i, kinds[i] == EXTRASAMPLE_ASSOCALPHA};
  if (samples == colours + 1) return Alpha{colours, false};
  return std::nullopt;
}

Texels decode_plain(TIFF* tiff, const std::string& name, const Layout& l, int colours, bool white_is_zero,
                    DisplayNotes* notes) {
  Samples samples(l.row_bytes() * static_cast<std::size_t>(l.height));
  TIFFIsTiled(tiff) ? read_tiles(tiff, name, l, samples) : read_strips(tiff, name, l, samples);
  const std::optional<Alpha> alpha = find_alpha(tiff, l.samples, colours);
  Texels t{.width = l.width, .height = l.height, .channels = colours + (alpha ? 1 : 0), .linear = l.floating};
  std::vector<std::size_t> places;
  for (int c = 0; c < colours; ++c) places.push_back(static_cast<std::size_t>(c) * l.sample_bytes());
  if (alpha) places.push_back(static_cast<std::size_t>(alpha->sample) * l.sample_bytes());
  const std::size_t pixel = static_cast<std::size_t>(l.samples) * l.sample_bytes();
  const std::size_t values = samples.size() / pixel * places.size();
  l.bits == 8 ? t.bytes.reserve(values) : t.floats.reserve(values);
  for (std::size_t at = 0; at < samples.size(); at += pixel)
    for (std::size_t c = 0; c < places.size(); ++c) {
      const bool inverted = white_is_zero && c < static_cast<std::size_t>(colours);
      const std::uint8_t* from = samples.data() + at + places[c];
      if (l.bits == 8)
        t.bytes.push_back(inverted ? static_cast<std::uint8_t>(255 - *from) : *from);
      else
        t.floats.push_back(inverted ? 1 - number(from, l) : number(from, l));
    }
  if (alpha && alpha->premultiplied) {
    if (notes && l.floating)
      notes->premultiplied = true;
    else
      make_straight(t);
  }
  return t;
}

/// XYZ, as LogLuv files are decoded, to RGB.
void make_rgb(Texels& t) {
  const glm::dmat3 m = to_rec709(cie_xyz);
  for (std::size_t i = 0; i + 2 < t.floats.size(); i += static_cast<std::size_t>(t.channels)) {
    const Rgb c = apply(m, {t.floats[i], t.floats[i + 1], t.floats[i + 2]});
    t.floats[i] = c.r, t.floats[i + 1] = c.g, t.floats[i + 2] = c.b;
  }
}

constexpr std::pair<std::uint32_t, const char*> text_tags[] = {{TIFFTAG_IMAGEDESCRIPTION, "ImageDescription"},
                                                               {TIFFTAG_SOFTWARE, "Software"},
                                                               {TIFFTAG_DATETIME, "DateTime"},
                                                               {TIFFTAG_ARTIST, "Artist"},
                                                               {TIFFTAG_COPYRIGHT, "Copyright"}};

/// Palettes, few bits and rare colour spaces, through libtiff's own conversion to 8-bit RGBA.
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

Texels decode_tiff(Bytes data, const std::string& name, DisplayNotes* notes) {
  Memory memory{.input = data};
  const Tiff tiff = open(memory, "r");
  if (!tiff) decode_error(name, complaint.empty() ? "is not a TIFF file" : complaint);
  const auto width = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGEWIDTH, 0),
             height = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGELENGTH, 0);
  check_image_size(name, width, height, data.size(), 16384);
  const auto photometric = field<std::uint16_t>(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK),
             compression = field<std::uint16_t>(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const bool logarithmic = compression == COMPRESSION_SGILOG || compression == COMPRESSION_SGILOG24;
  const bool log_luv = logarithmic && photometric == PHOTOMETRIC_LOGLUV;
  const bool log_l = logarithmic && photometric == PHOTOMETRIC_LOGL;
  if (log_luv || log_l) TIFFSetField(tiff.get(), TIFFTAG_SGILOGDATAFMT, SGILOGDATAFMT_FLOAT);
  const auto format = field<std::uint16_t>(tiff.get(), TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const Layout l{
      .width = static_cast<int>(width),
      .height = static_cast<int>(height),
      .samples = field<std::uint16_t>(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1),
      .bits = field<std::uint16_t>(tiff.get(), TIFFTAG_BITSPERSAMPLE, 1),
      .floating = format == SAMPLEFORMAT_IEEEFP,
      .planes = field<std::uint16_t>(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE};
  const bool colour = photometric == PHOTOMETRIC_RGB || log_luv;
  const bool grey = photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE || log_l;
  const bool known_bits = l.floating ? l.bits == 16 || l.bits == 32 || l.bits == 64
                                     : format == SAMPLEFORMAT_UINT && (l.bits == 8 || l.bits == 16 || l.bits == 32);
  const int colours = colour ? 3 : 1;
  if (notes)
    for (const auto& [tag, key] : text_tags) {
      const char* text = nullptr;
      if (TIFFGetField(tiff.get(), tag, &text) && text) notes->metadata[key] = text;
    }
  const auto orientation = field<std::uint16_t>(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  if (!(colour || grey) || !known_bits || l.samples < colours)
    return oriented(decode_rgba(tiff.get(), name, l.width, l.height, orientation), orientation);
  check_image_size(name, width, std::uint64_t{height} * static_cast<std::uint64_t>(l.samples), data.size(), 16384);
  Texels t = decode_plain(tiff.get(), name, l, colours, photometric == PHOTOMETRIC_MINISWHITE, notes);
  if (log_luv) make_rgb(t);
  return oriented(std::move(t), orientation);
}

std::vector<std::byte> encode_tiff(const DisplayImage& image, const WriteOptions&) {
  Memory memory;
  {
    const Tiff tiff = open(memory, "wm");
    const int bits = !image.floats.empty() ? 32 : !image.words.empty() ? 16 : 8;
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, image.channels);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLEFORMAT, bits == 32 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, image.channels >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    if (bits == 32) TIFFSetField(tiff.get(), TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT);
    TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff.get(), 0));
    for (const auto& [tag, key] : text_tags)
      if (const auto text = image.metadata.find(key); text != image.metadata.end())
        TIFFSetField(tiff.get(), tag, text->second.c_str());
    std::uint16_t alpha = bits == 32 ? EXTRASAMPLE_ASSOCALPHA : EXTRASAMPLE_UNASSALPHA;
    if (image.channels == 2 || image.channels == 4) TIFFSetField(tiff.get(), TIFFTAG_EXTRASAMPLES, 1, &alpha);
    const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels) *
                            static_cast<std::size_t>(bits / 8);
    const void* pixels = bits == 32   ? static_cast<const void*>(image.floats.data())
                         : bits == 16 ? static_cast<const void*>(image.words.data())
                                      : static_cast<const void*>(image.bytes.data());
    std::vector<std::uint8_t> line(row);  // a predictor works in place
    for (int y = 0; y < image.height; ++y) {
      std::memcpy(line.data(), static_cast<const std::uint8_t*>(pixels) + static_cast<std::size_t>(y) * row, row);
      if (TIFFWriteScanline(tiff.get(), line.data(), static_cast<std::uint32_t>(y), 0) < 0)
        throw Error("TIFF: " + complaint);
    }
  }
  return std::move(memory.output);
}

}  // namespace lambert
