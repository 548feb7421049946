#pragma once
/// One pair of functions per file format; image/io.cpp chooses. Decoders take bytes, so that they also serve embedded
/// images and fuzzing. They throw Error "name: reason", and check sizes before they allocate.

#include "lambert/image/formats/exif.h"
#include "lambert/image/image.h"
#include "lambert/image/io.h"
#include "lambert/image/primaries.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lambert {

using Bytes = std::span<const std::byte>;

Image decode_exr(Bytes data, const std::string& name);
Image decode_rgbe(Bytes data, const std::string& name);
Image decode_pfm(Bytes data, const std::string& name);

/// What a display file says about its numbers beside them; for readers that honour it.
struct DisplayNotes {
  float exponent = 0;                       ///< linear = code^exponent; 0: sRGB's curve
  std::optional<Chromaticities> primaries;  ///< Rec. 709 without
  bool premultiplied = false;               ///< floats times alpha
  std::map<std::string, std::string> metadata;
};
Texels decode_png(Bytes data, const std::string& name, DisplayNotes* notes = nullptr);
Texels decode_jpeg(Bytes data, const std::string& name, DisplayNotes* notes = nullptr);
Texels decode_tiff(Bytes data, const std::string& name, DisplayNotes* notes = nullptr);
Texels decode_webp(Bytes data, const std::string& name, DisplayNotes* notes = nullptr);

/// Radiance formats take the image as it is; those without windows get what is displayed of it.
std::vector<std::byte> encode_exr(const Image& image, const WriteOptions& options = {});
std::vector<std::byte> encode_rgbe(const Image& image, const WriteOptions& options = {});
std::vector<std::byte> encode_pfm(const Image& image, const WriteOptions& options = {});

/// An image as display formats store it: sRGB, straight alpha, 1 to 4 channels of 8 or 16 bits; or linear floats with
/// premultiplied alpha.
struct DisplayImage {
  int width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> words;  ///< instead of bytes, for 16 bits
  std::vector<float> floats;         ///< instead of either
  std::map<std::string, std::string> metadata;
  std::optional<Exif> exif;  ///< PNG and JPEG keep what exif_block() does
};
std::vector<std::byte> encode_png(const DisplayImage& image, const WriteOptions& options = {});
std::vector<std::byte> encode_jpeg(const DisplayImage& image, const WriteOptions& options = {});
std::vector<std::byte> encode_tiff(const DisplayImage& image, const WriteOptions& options = {});
std::vector<std::byte> encode_webp(const DisplayImage& image, const WriteOptions& options = {});

bool is_exr(Bytes data);

[[noreturn]] void decode_error(const std::string& name, const std::string& reason);
/// In a handler: throws what is being handled as an Error "name: reason", of one line.
[[noreturn]] void rethrow_named(const std::string& name);
/// Refuses sizes that are not positive, above 2^28 pixels, or so large that `bytes` of the file cannot hold them even
/// if each byte were worth `most_pixels_per_byte` pixels.
void check_image_size(const std::string& name, std::uint64_t width, std::uint64_t height, std::size_t bytes,
                      std::uint64_t most_pixels_per_byte);

}  // namespace lambert
