#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lambert {

/// How a photograph was taken (CIPA DC-008, Exif 2.32).
struct Exif {
  std::optional<double> exposure_time;  ///< seconds; from ShutterSpeedValue where ExposureTime is missing
  std::optional<double> f_number;       ///< from ApertureValue where FNumber is missing
  std::optional<double> iso;            ///< of several speeds the first
  int orientation = 1;                  ///< 1 to 8 as in tag 274: where row 0 and column 0 are seen
};

/// The Exif data of a JPEG (APP1), PNG (eXIf), WebP (EXIF) or TIFF file in memory; none when it has none or it is
/// damaged beyond its first entry. Values that make no sense (zero, negative, not finite) are left out.
std::optional<Exif> read_exif(std::span<const std::byte> file);

/// The TIFF structure that holds exposure time, f-number and speed as far as they are known and representable:
/// rationals of 32 bits, a speed of 16. It stands as it is in PNG's eXIf, and behind "Exif\0\0" in JPEG's APP1.
std::vector<std::byte> exif_block(const Exif& exif);

}  // namespace lambert
