#pragma once
/// Image files. Radiance formats (.exr .hdr .pfm) hold linear light; display formats (.png .jpg .tif .webp) hold sRGB
/// with straight alpha and are converted on the way in and out.

#include "lambert/image/image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lambert {

/// Reads any known format; its kind is found by its first bytes, not by its name. Throws Error naming file and offset.
Image read_image(const std::filesystem::path& path);

/// Writes by extension, whole or not at all. Display formats clip to [0,1] after the sRGB curve; `.exr` keeps all
/// channels, half floats for colour and full floats for Z, position, ids and counts; `.tif` is 16 bit. Throws Error
/// naming the path.
void write_image(const std::filesystem::path& path, const Image& image);

/// True for formats that hold unbounded linear light. Throws Error with the known extensions for an unknown one.
bool is_radiance_format(const std::filesystem::path& path);
std::vector<std::string> image_extensions();

/// Texels as files store them, for textures: 8-bit data stays 8-bit, and is not decoded from sRGB.
struct Texels {
  int width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> bytes;  ///< rows from the top, straight alpha; empty when `floats` is used
  std::vector<float> floats;        ///< radiance formats, and 16-bit codes over 65535
  bool linear = false;              ///< floats that are linear light already
};
/// Decodes an image in memory (PNG, JPEG, WebP, TIFF, EXR, HDR, PFM). `name` is used in errors; a number
/// that is not finite is one.
Texels decode_texels(std::span<const std::byte> data, const std::string& name);

}  // namespace lambert
