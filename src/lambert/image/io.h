#pragma once
/// Image files. Radiance formats (.exr .hdr .pfm) hold linear light; display formats (.png .jpg .tif .webp) hold sRGB
/// with straight alpha and are converted on the way in and out. In memory colours have Rec. 709 primaries and white
/// D65; what a file says to be in others is converted (image/primaries.h).

#include "lambert/image/image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// Reads any known format; its kind is found by its first bytes, not by its name. "-" is standard input. OpenEXR files
/// keep their windows (Image::data_window()): use displayed() for what is shown. Photographs are turned as their Exif
/// data say. Throws Error naming file and offset.
Image read_image(const std::filesystem::path& path);
/// The same of bytes in memory; `name` is used in errors.
Image decode_image(std::span<const std::byte> data, const std::string& name);

/// True when the first bytes are those of a known format; false also when there is no such file.
bool is_image_file(const std::filesystem::path& path);
/// True when they are those of a format that holds unbounded linear light. Throws Error unless it is a known one.
bool is_radiance_file(const std::filesystem::path& path);

/// How numbers are stored. `automatic`: `.exr` half, but full floats for Z, position, ids, counts and variances, and
/// for all where the image holds more than a half can (65504) or was read, in bands, from full floats;
/// `.png .jpg .webp` 8 bits; `.tif` 16 bits; `.hdr` and `.pfm` have no choice.
enum class Depth { automatic, bits8, bits16, half, full };
/// OpenEXR's. All but pxr24 (of floats), b44, b44a, dwaa and dwab are lossless.
enum class Compression { none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab };

struct WriteOptions {
  Depth depth = Depth::automatic;
  Compression compression = Compression::zip;  ///< of `.exr`; others have their own
  std::optional<int> quality = std::nullopt;   ///< 1 to 100; JPEG 92 without it, WebP lossless
};

/// "auto", "8", "16", "half", "float"; "none", "rle" ... Throw Error with the known words for another.
Depth parse_depth(std::string_view word);
Compression parse_compression(std::string_view word);
std::vector<std::string> depth_words();
std::vector<std::string> compression_words();

/// Writes by extension, whole or not at all; to standard output by the names "png:-", "exr:-" …, or "-" for OpenEXR,
/// unless that is a terminal. Formats without windows get displayed(). Display formats clip to [0,1]
/// after the sRGB curve, but for `.tif` of full floats, which is linear and not clipped; `.exr` keeps all channels,
/// windows and attributes. Throws Error naming the path, also when the format has not the depth asked for.
void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions& options = {});
/// The bytes that write_image() would put into a file of this path. Throws as it does.
std::vector<std::byte> encode_image(const std::filesystem::path& path, const Image& image,
                                    const WriteOptions& options = {});

/// Throws the Error that write_image() would for a path and options that do not go together, before there is an image.
void check_write_options(const std::filesystem::path& path, const WriteOptions& options);

/// True for formats that hold unbounded linear light. Throws Error with the known extensions for an unknown one.
bool is_radiance_format(const std::filesystem::path& path);
/// True for OpenEXR, which alone keeps layers and windows. Throws likewise.
bool writes_exr(const std::filesystem::path& path);
std::vector<std::string> image_extensions();

/// Texels as files store them, for textures: 8-bit data stays 8-bit, and is not decoded from sRGB.
struct Texels {
  int width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> bytes;  ///< rows from the top, straight alpha; empty when `floats` is used
  std::vector<float> floats;        ///< radiance formats, and 16-bit codes over 65535
  bool linear = false;              ///< floats that are linear light already
};
/// Decodes an image in memory (PNG, JPEG, WebP, TIFF, EXR, HDR, PFM): what is displayed() of it. Notes of gamma,
/// primaries and Exif in PNG and JPEG files are ignored, as glTF wants. `name` is used in errors; a number that is not
/// finite is one.
Texels decode_texels(std::span<const std::byte> data, const std::string& name);

}  // namespace lambert
