#include "lambert/image/formats/exif.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace lambert {
namespace {

using Bytes = std::span<const std::byte>;

/// Numbers in bytes of either order; behind the end there are zeros.
class Numbers {
 public:
  Numbers(Bytes data, bool little) : data_(data), little_(little) {}

  std::uint64_t at(std::uint64_t place, unsigned size) const {
    std::uint64_t value = 0;
    if (place > data_.size() || data_.size() - place < size) return 0;
    for (unsigned i = 0; i < size; ++i) {
      const auto byte = std::to_integer<std::uint64_t>(data_[static_cast<std::size_t>(place) + i]);
      value |= byte << (8 * (little_ ? i : size - 1 - i));
    }
    return value;
  }
  std::uint32_t u16(std::uint64_t place) const { return static_cast<std::uint32_t>(at(place, 2)); }
  std::uint32_t u32(std::uint64_t place) const { return static_cast<std::uint32_t>(at(place, 4)); }
  std::size_t size() const { return data_.size(); }

 private:
  Bytes data_;
  bool little_;
};

enum Tag : std::uint32_t {
  orientation = 274,
  exposure_time = 33434,
  f_number = 33437,
  exif_directory = 34665,
  iso_speed = 34855,
  output_sensitivity = 34865,
  exposure_index = 34866,
  shutter_speed = 37377,
  aperture = 37378,
};

/// The first value of the directory entry at `entry`, of any of TIFF's types of numbers.
std::optional<double> value_of(const Numbers& n, std::uint64_t entry) {
  const std::uint32_t type = n.u16(entry + 2), count = n.u32(entry + 4);
  if (count == 0) return std::nullopt;
  const std::uint64_t inside = entry + 8, outside = n.u32(entry + 8);
  switch (type) {
    case 1: return static_cast<double>(n.at(inside, 1));
    case 3: return static_cast<double>(n.u16(count > 2 ? outside : inside));
    case 4: return static_cast<double>(n.u32(count > 1 ? outside : inside));
    case 5: return static_cast<double>(n.u32(outside)) / static_cast<double>(n.u32(outside + 4));
    case 10:
      return static_cast<double>(static_cast<std::int32_t>(n.u32(outside))) /
             static_cast<double>(static_cast<std::int32_t>(n.u32(outside + 4)));
    default: return std::nullopt;
  }
}

struct Found {
  std::optional<double> shutter, aperture, sensitivity;
  std::optional<std::uint64_t> directory;  // where the first directory says the Exif one is
  Exif exif;
};

void read_directory(const Numbers& n, std::uint64_t place, Found& found) {
  const std::uint32_t entries = n.u16(place);
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::uint64_t entry = place + 2 + 12 * std::uint64_t{i};
    if (entry + 12 > n.size()) return;
    const std::optional<double> value = value_of(n, entry);
    if (!value || !std::isfinite(*value)) continue;
    const std::optional<double> positive = *value > 0 ? value : std::nullopt;
    switch (n.u16(entry)) {
      case orientation:
        if (*value >= 1 && *value <= 8) found.exif.orientation = static_cast<int>(*value);
        break;
      case exposure_time: found.exif.exposure_time = positive; break;
      case f_number: found.exif.f_number = positive; break;
      case iso_speed: found.exif.iso = positive; break;
      case output_sensitivity:
      case exposure_index: found.sensitivity = positive; break;
      case shutter_speed: found.shutter = value; break;
      case aperture: found.aperture = value; break;
      case exif_directory:
        if (!found.directory && positive) found.directory = static_cast<std::uint64_t>(*value);
        break;
      default: break;
    }
  }
}

bool starts_with(Bytes data, std::string_view text) {
  return data.size() >= text.size() && std::memcmp(data.data(), text.data(), text.size()) == 0;
}

std::optional<Exif> read_tiff(Bytes data) {
  const bool little = starts_with(data, std::string_view("II*\0", 4));
  if (!little && !starts_with(data, std::string_view("MM\0*", 4))) return std::nullopt;
  const Numbers n(data, little);
  const std::uint32_t first = n.u32(4);
  if (first < 8 || std::uint64_t{first} + 14 > data.size() || n.u16(first) == 0) return std::nullopt;
  Found found;
  read_directory(n, first, found);
  if (found.directory) read_directory(n, *found.directory, found);
  Exif& exif = found.exif;
  // Apex values: Tv = -log2 t, Av = 2 log2 N. A speed that does not fit in its 16 bits is 65535.
  if (!exif.exposure_time && found.shutter && std::abs(*found.shutter) < 60)
    exif.exposure_time = std::exp2(-*found.shutter);
  if (!exif.f_number && found.aperture && std::abs(*found.aperture) < 60)
    exif.f_number = std::exp2(*found.aperture / 2);
  if ((!exif.iso || *exif.iso == 65535) && found.sensitivity) exif.iso = found.sensitivity;
  return exif;
}

std::optional<Exif> read_jpeg(Bytes data) {
  const Numbers n(data, false);
  for (std::size_t at = 2; at + 4 <= data.size();) {
    const std::uint32_t marker = n.u16(at);
    if (marker == 0xffff) {  // a fill byte
      ++at;
      continue;
    }
    const bool pixels_begin = marker == 0xffda || marker == 0xffd9;
    const std::size_t length = n.u16(at + 2);
    if ((marker & 0xff00) != 0xff00 || pixels_begin || length < 2 || length > data.size() - at - 2) return std::nullopt;
    const Bytes segment = data.subspan(at + 4, length - 2);
    if (marker == 0xffe1 && starts_with(segment, std::string_view("Exif\0\0", 6)))
      if (const auto exif = read_tiff(segment.subspan(6))) return exif;
    at += 2 + length;
  }
  return std::nullopt;
}

/// PNG's chunks are size, name, content and sum, in big-endian order; those of RIFF name, size and content.
std::optional<Exif> read_chunks(Bytes data, std::size_t at, bool png) {
  const Numbers n(data, !png);
  while (at + 8 <= data.size()) {
    const std::size_t length = n.u32(png ? at : at + 4);
    const Bytes name = data.subspan(png ? at + 4 : at, 4), rest = data.subspan(at + 8);
    if (length > rest.size()) return std::nullopt;
    if (starts_with(name, png ? "eXIf" : "EXIF")) {
      const Bytes content = rest.first(length);
      return read_tiff(starts_with(content, std::string_view("Exif\0\0", 6)) ? content.subspan(6) : content);
    }
    at += 8 + length + (png ? 4 : length % 2);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Exif> read_exif(Bytes file) {
  if (starts_with(file, "\xff\xd8")) return read_jpeg(file);
  if (starts_with(file, "\x89PNG")) return read_chunks(file, 8, true);
  if (starts_with(file, "RIFF")) return read_chunks(file, 12, false);
  return read_tiff(file);
}

namespace {

struct Rational {
  std::uint32_t numerator, denominator;
};

/// The nearest with a denominator, or for what is below 1 a numerator, of 10^6; 1/t for the times that cameras show as
/// such. None when it does not fit.
std::optional<Rational> rational(double value) {
  constexpr double largest = 4294967295.0, fine = 1e6;
  if (!(value > 1 / largest && value < largest)) return std::nullopt;
  const auto word = [](double v) { return static_cast<std::uint32_t>(std::llround(v)); };
  if (value <= 1 && std::abs(std::round(1 / value) * value - 1) < 1e-9) return Rational{1, word(1 / value)};
  const double scale = std::min(fine, std::floor(largest / std::max(value, 1 / value)));
  return value < 1 ? Rational{word(scale), word(scale / value)} : Rational{word(value * scale), word(scale)};
}

class BlockWriter {
 public:
  void u16(std::uint32_t v) { number(v, 2); }
  void u32(std::uint32_t v) { number(v, 4); }
  std::vector<std::byte> bytes;

 private:
  void number(std::uint32_t v, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::byte>(v >> (8 * i)));
  }
};

}  // namespace

std::vector<std::byte> exif_block(const Exif& exif) {
  const auto time = rational(exif.exposure_time.value_or(0)), aperture = rational(exif.f_number.value_or(0));
  const double iso = std::round(exif.iso.value_or(0));
  const bool has_iso = iso >= 1 && iso < 65535;
  const std::uint32_t entries = (time ? 1u : 0u) + (aperture ? 1u : 0u) + (has_iso ? 1u : 0u);
  constexpr std::uint32_t first = 8, second = first + 2 + 12 + 4;
  std::uint32_t values = second + 2 + 12 * entries + 4;
  BlockWriter out;
  out.u32(0x002a4949), out.u32(first);
  const auto entry = [&](Tag tag, std::uint32_t type, std::uint32_t value) {
    out.u16(tag), out.u16(type), out.u32(1), out.u32(value);
  };
  const auto rational_entry = [&](Tag tag) { entry(tag, 5, values), values += 8; };
  out.u16(1), entry(exif_directory, 4, second), out.u32(0);
  out.u16(entries);
  if (time) rational_entry(exposure_time);
  if (aperture) rational_entry(f_number);
  if (has_iso) entry(iso_speed, 3, static_cast<std::uint32_t>(iso));
  out.u32(0);
  for (const auto& r : {time, aperture})
    if (r) out.u32(r->numerator), out.u32(r->denominator);
  return std::move(out.bytes);
}

}  // namespace lambert
