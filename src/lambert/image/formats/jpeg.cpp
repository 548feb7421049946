#include "lambert/base/error.h"
#include "lambert/image/formats/codecs.h"

// jpeglib.h needs FILE declared before it.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <jpeglib.h>

namespace lambert {
namespace {

[[noreturn]] void fail(j_common_ptr info) {
  char message[JMSG_LENGTH_MAX];
  info->err->format_message(info, message);
  throw Error(message);
}

/// Damage that libjpeg would paper over with grey is an error here; other warnings (levels above) are not.
void on_message(j_common_ptr info, int level) {
  if (level < 0) fail(info);
}

jpeg_error_mgr* errors(jpeg_error_mgr& manager) {
  jpeg_std_error(&manager);
  manager.error_exit = fail;
  manager.emit_message = on_message;
  return &manager;
}

class Decoder {
 public:
  Decoder() {
    info_.err = errors(manager_);
    jpeg_create_decompress(&info_);
  }
  ~Decoder() { jpeg_destroy_decompress(&info_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  Texels decode(Bytes data, const std::string& name) {
    jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(data.data()), data.size());
    jpeg_read_header(&info_, TRUE);
    check_image_size(name, info_.image_width, info_.image_height, data.size(), 4096);
    const bool cmyk = info_.num_components == 4;
    info_.out_color_space = cmyk ? JCS_CMYK : info_.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_start_decompress(&info_);
    const auto width = static_cast<std::size_t>(info_.output_width),
               height = static_cast<std::size_t>(info_.output_height);
    const auto components = static_cast<std::size_t>(info_.output_components);
    std::vector<std::uint8_t> pixels(width * height * components);
    while (info_.output_scanline < info_.output_height) {
      JSAMPROW row = pixels.data() + info_.output_scanline * width * components;
      jpeg_read_scanlines(&info_, &row, 1);
    }
    jpeg_finish_decompress(&info_);
    Texels t;
    t.width = static_cast<int>(width), t.height = static_cast<int>(height);
    t.channels = cmyk ? 3 : static_cast<int>(components);
    t.bytes = cmyk ? rgb_of_inverted_cmyk(pixels) : std::move(pixels);
    return t;
  }

 private:
  /// Adobe's programs, which alone write such files, store CMYK inverted: 255 is no ink.
  static std::vector<std::uint8_t> rgb_of_inverted_cmyk(const std::vector<std::uint8_t>& cmyk) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(cmyk.size() / 4 * 3);
    for (std::size_t i = 0; i + 3 < cmyk.size(); i += 4)
      for (std::size_t c = 0; c < 3; ++c) rgb.push_back(static_cast<std::uint8_t>(cmyk[i + c] * cmyk[i + 3] / 255));
    return rgb;
  }
  jpeg_error_mgr manager_{};
  jpeg_decompress_struct info_{};
};

struct Encoder {
  jpeg_error_mgr manager{};
  jpeg_compress_struct info{};
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  Encoder() {
    info.err = errors(manager);
    jpeg_create_compress(&info);
  }
  ~Encoder() {
    jpeg_destroy_compress(&info);
    std::free(buffer);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
};

}  // namespace

Texels decode_jpeg(Bytes data, const std::string& name, DisplayNotes*) {
  try {
    return Decoder().decode(data, name);
  } catch (const std::exception&) {
    rethrow_named(name);
  }
}

std::vector<std::byte> encode_jpeg(const DisplayImage& image, const WriteOptions& options) {
  Encoder encoder;
  jpeg_compress_struct& info = encoder.info;
  jpeg_mem_dest(&info, &encoder.buffer, &encoder.size);
  info.image_width = static_cast<JDIMENSION>(image.width), info.image_height = static_cast<JDIMENSION>(image.height);
  info.input_components = image.channels;
  info.in_color_space = image.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, options.quality.value_or(92), TRUE);
  jpeg_start_compress(&info, TRUE);
  if (image.exif) {
    constexpr char kind[6] = {'E', 'x', 'i', 'f', 0, 0};
    std::vector<std::byte> segment(sizeof kind);
    std::memcpy(segment.data(), kind, sizeof kind);
    const std::vector<std::byte> block = exif_block(*image.exif);
    segment.insert(segment.end(), block.begin(), block.end());
    jpeg_write_marker(&info, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(segment.data()),
                      static_cast<unsigned>(segment.size()));
  }
  const std::size_t row_size = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  while (info.next_scanline < info.image_height) {
    JSAMPROW row = const_cast<JSAMPROW>(image.bytes.data()) + info.next_scanline * row_size;
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  const auto* bytes = reinterpret_cast<const std::byte*>(encoder.buffer);
  return {bytes, bytes + encoder.size};
}

}  // namespace lambert
