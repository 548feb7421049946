#include "lambert/base/error.h"
#include "lambert/image/formats/codecs.h"

#include <webp/decode.h>
#include <webp/encode.h>

namespace lambert {

Texels decode_webp(Bytes data, const std::string& name, DisplayNotes*) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(data.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes, data.size(), &features) != VP8_STATUS_OK)
    decode_error(name, "is not a complete WebP file");
  // "RIFF", the size of what follows, "WEBP"; the decoder is content when the pixels it needs are there.
  const auto size_byte = [bytes](int i) { return std::uint64_t{bytes[4 + i]} << (8 * i); };
  if (const std::uint64_t size = size_byte(0) | size_byte(1) | size_byte(2) | size_byte(3); size + 8 > data.size())
    decode_error(name, "ends at byte " + std::to_string(data.size()) + ", expected " + std::to_string(size + 8));
  if (features.has_animation) decode_error(name, "is an animation, expected a still image");
  check_image_size(name, static_cast<std::uint64_t>(features.width), static_cast<std::uint64_t>(features.height),
                   data.size(), 65536);
  Texels t{.width = features.width, .height = features.height, .channels = features.has_alpha ? 4 : 3};
  t.bytes.resize(static_cast<std::size_t>(t.width) * static_cast<std::size_t>(t.height) *
                 static_cast<std::size_t>(t.channels));
  const int stride = t.width * t.channels;
  const auto* decoded = features.has_alpha
                            ? WebPDecodeRGBAInto(bytes, data.size(), t.bytes.data(), t.bytes.size(), stride)
                            : WebPDecodeRGBInto(bytes, data.size(), t.bytes.data(), t.bytes.size(), stride);
  if (!decoded) decode_error(name, "its pixels are damaged or end early");
  return t;
}

/// Lossless without a quality.
std::vector<std::byte> encode_webp(const DisplayImage& image, const WriteOptions& options) {
  std::uint8_t* buffer = nullptr;
  const std::uint8_t* pixels = image.bytes.data();
  const int w = image.width, h = image.height, stride = w * image.channels;
  const float quality = static_cast<float>(options.quality.value_or(0));
  std::size_t size = 0;
  if (options.quality)
    size = image.channels == 4 ? WebPEncodeRGBA(pixels, w, h, stride, quality, &buffer)
                               : WebPEncodeRGB(pixels, w, h, stride, quality, &buffer);
  else
    size = image.channels == 4 ? WebPEncodeLosslessRGBA(pixels, w, h, stride, &buffer)
                               : WebPEncodeLosslessRGB(pixels, w, h, stride, &buffer);
  if (size == 0) throw Error("WebP holds at most 16383x16383 pixels");
  const auto* bytes = reinterpret_cast<const std::byte*>(buffer);
  std::vector<std::byte> out(bytes, bytes + size);
  WebPFree(buffer);
  return out;
}

}  // namespace lambert
