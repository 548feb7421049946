#include "lambert/base/error.h"
#include "lambert/image/formats/codecs.h"
#include "lambert/image/formats/png_rows.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lambert {
namespace {

struct Input {
  Bytes data;
  std::size_t at = 0;
};

/// libpng reports errors by longjmp; from C++ functions that it calls, an exception is as good and runs destructors.
[[noreturn]] void fail(png_structp, png_const_charp message) { throw Error(message); }
void ignore(png_structp, png_const_charp) {}

Error cut_off(Bytes data) { return Error("ends at byte " + std::to_string(data.size())); }

/// libpng allocates what a chunk claims to hold before it finds that the file is shorter.
void check_chunk_sizes(Bytes data) {
  constexpr std::size_t signature = 8, begin = 8, around = 12;  // size and name, and the checksum
  for (std::size_t at = signature; at + begin <= data.size();) {
    const auto* chunk = reinterpret_cast<png_const_bytep>(&data[at]);
    const std::size_t size = png_get_uint_32(chunk);
    if (at + around + size > data.size()) throw cut_off(data);
    if (std::memcmp(chunk + 4, "IEND", 4) == 0) return;
    at += size + around;
  }
}

void read_bytes(png_structp png, png_bytep to, png_size_t count) {
  auto& in = *static_cast<Input*>(png_get_io_ptr(png));
  if (count > in.data.size() - in.at) throw cut_off(in.data);
  std::memcpy(to, in.data.data() + in.at, count);
  in.at += count;
}

void write_bytes(png_structp png, png_bytep from, png_size_t count) {
  auto& out = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  const auto* bytes = reinterpret_cast<const std::byte*>(from);
  out.insert(out.end(), bytes, bytes + count);
}
void flush(png_structp) {}

/// How far deflate shrinks what repeats: 258 bytes to 2 bits, and a little more for what stands around.
constexpr std::size_t most_deflated = 1032;

class Decoder {
 public:
  Decoder()
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore)),
        info_(png_create_info_struct(png_)) {}
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  Texels decode(Bytes data, const std::string& name, DisplayNotes* notes) {
    Input in{data};
    check_chunk_sizes(data);
    png_set_read_fn(png_, &in, read_bytes);
    png_set_chunk_malloc_max(png_, 8'000'000);  // of what is compressed in a chunk, such as a profile
    png_read_info(png_, info_);
    const png_uint_32 width = png_get_image_width(png_, info_), height = png_get_image_height(png_, info_);
    check_image_size(name, width, height, data.size(), 8 * most_deflated);  // a byte may be 8 pixels
    if (png_get_rowbytes(png_, info_) * height > most_deflated * data.size())
      throw Error("has only " + std::to_string(data.size()) + " bytes, too few for its pixels");
    Texels t;
    t.width = static_cast<int>(width), t.height = static_cast<int>(height);
    std::optional<std::vector<std::uint8_t>> plain = plain_rows(in);
    std::vector<std::uint8_t> pixels = plain ? std::move(*plain) : any_rows();
    png_read_end(png_, info_);
    t.channels = png_get_channels(png_, info_);
    if (notes) read_notes(*notes);
    if (png_get_bit_depth(png_, info_) < 16) {
      t.bytes = std::move(pixels);
      return t;
    }
    t.floats.resize(pixels.size() / 2);
    for (std::size_t i = 0; i < t.floats.size(); ++i)
      t.floats[i] = static_cast<float>(pixels[2 * i] << 8 | pixels[2 * i + 1]) / 65535.0f;
    return t;
  }

 private:
  /// Without libpng, which goes on behind the image data: the common kinds, undamaged.
  std::optional<std::vector<std::uint8_t>> plain_rows(Input& in) {
    const unsigned depth = png_get_bit_depth(png_, info_);
    if (depth < 8 || png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE ||
        png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE || png_get_valid(png_, info_, PNG_INFO_tRNS))
      return std::nullopt;
    constexpr std::size_t chunk_header = 8;  // read already
    auto rows = png_rows(in.data, in.at - chunk_header, png_get_rowbytes(png_, info_),
                         png_get_image_height(png_, info_), png_get_channels(png_, info_) * depth / 8);
    if (!rows) return std::nullopt;
    in.at = rows->end;
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, reinterpret_cast<png_const_bytep>("IDAT"), 1);
    return std::move(rows->pixels);
  }

  /// Palettes, small depths and transparent colours are expanded.
  std::vector<std::uint8_t> any_rows() {
    png_set_expand(png_);
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    const std::size_t row_bytes = png_get_rowbytes(png_, info_), height = png_get_image_height(png_, info_);
    std::vector<std::uint8_t> pixels(row_bytes * height);
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t y = 0; y < height; ++y) png_read_row(png_, pixels.data() + y * row_bytes, nullptr);
    return pixels;
  }

  /// An sRGB chunk or a profile outdoes gamma and primaries; profiles are taken for sRGB's. A gamma about 1/2.2 means
  /// sRGB, too.
  void read_notes(DisplayNotes& notes) {
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png_, info_, &texts, &count);
    for (int i = 0; i < count; ++i)
      if (texts[i].key && *texts[i].key && texts[i].text) notes.metadata[texts[i].key] = texts[i].text;
    if (png_get_valid(png_, info_, PNG_INFO_sRGB) || png_get_valid(png_, info_, PNG_INFO_iCCP)) return;
    double gamma = 0;
    if (png_get_gAMA(png_, info_, &gamma) && gamma > 0.1 && gamma < 10 && std::abs(1 / gamma - 2.2) > 0.05)
      notes.exponent = static_cast<float>(1 / gamma);
    Chromaticities c;
    if (!png_get_cHRM(png_, info_, &c.white.x, &c.white.y, &c.red.x, &c.red.y, &c.green.x, &c.green.y, &c.blue.x,
                      &c.blue.y))
      return;
    to_rec709(c);  // throws for what is no system
    notes.primaries = c;
  }

  png_structp png_;
  png_infop info_;
};

struct Encoder {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png_create_info_struct(png);
  Encoder() = default;
  ~Encoder() { png_destroy_write_struct(&png, &info); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
};

/// How zlib looks for what repeats, after filtering.
enum class Search { runs, all };

std::vector<std::byte> encoded(const DisplayImage& image, std::size_t first, std::size_t last, Search search) {
  static constexpr int colour_types[] = {0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                         PNG_COLOR_TYPE_RGBA};
  std::vector<std::byte> out;
  const Encoder encoder;
  const png_structp png = encoder.png;
  const png_infop info = encoder.info;
  png_set_write_fn(png, &out, write_bytes, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(last - first),
               image.words.empty() ? 8 : 16, colour_types[image.channels], PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (search == Search::runs) {
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_RLE);
  }
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  std::vector<png_text> texts;
  for (const auto& [key, value] : image.metadata) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(key.c_str());
    text.text = const_cast<char*>(value.c_str());
    text.text_length = value.size();
    if (!key.empty() && key.size() < 80) texts.push_back(text);
  }
  png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
  std::vector<std::byte> exif = image.exif ? exif_block(*image.exif) : std::vector<std::byte>();
  if (image.exif)
    png_set_eXIf_1(png, info, static_cast<png_uint_32>(exif.size()), reinterpret_cast<png_bytep>(exif.data()));
  png_write_info(png, info);
  png_set_swap(png);  // of 16 bits, from the machine's order
  const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  for (std::size_t y = first; y < last; ++y)
    png_write_row(png, image.words.empty() ? image.bytes.data() + y * row
                                           : reinterpret_cast<png_const_bytep>(image.words.data() + y * row));
  png_write_end(png, info);
  return out;
}

/// Runs when they cost at most a thirtieth of size in three samples of the image. Of filtered photographs and
/// renderings they find nearly all that is to be found, in a quarter of the time; tiles and dithers need the rest.
/// A sample is twice what deflate can look back on.
Search best_search(const DisplayImage& image) {
  constexpr std::size_t sample_bytes = 1 << 16, samples = 3;
  const std::size_t height = static_cast<std::size_t>(image.height),
                    row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels) *
                          (image.words.empty() ? 1 : 2),
                    rows = std::min(height, sample_bytes / row + 1);
  std::size_t by_runs = 0, by_all = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t first = (height - rows) * (2 * i + 1) / (2 * samples);
    by_runs += encoded(image, first, first + rows, Search::runs).size();
    by_all += encoded(image, first, first + rows, Search::all).size();
  }
  return by_runs <= by_all + by_all / 30 ? Search::runs : Search::all;
}

}  // namespace

Texels decode_png(Bytes data, const std::string& name, DisplayNotes* notes) {
  try {
    return Decoder().decode(data, name, notes);
  } catch (const std::exception&) {
    rethrow_named(name);
  }
}

std::vector<std::byte> encode_png(const DisplayImage& image, const WriteOptions&) {
  return encoded(image, 0, static_cast<std::size_t>(image.height), best_search(image));
}

}  // namespace lambert
