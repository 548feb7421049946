#include "lambert/base/error.h"
#include "lambert/image/formats/codecs.h"

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace {

std::uint32_t big_endian(const std::byte* from) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(from[i]);
  return value;
}

/// Makes the checksums of all whole chunks right: a reader that checks them would turn away nearly all that a fuzzer
/// thinks of.
void mend_checksums(std::vector<std::byte>& file) {
  constexpr std::size_t signature = 8, around = 12;  // size, name and checksum
  for (std::size_t at = signature; at + around <= file.size();) {
    const std::size_t size = big_endian(&file[at]);
    if (size > file.size() - at - around) return;
    const auto sum = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(&file[at + 4]), static_cast<uInt>(size + 4)));
    for (std::size_t i = 0; i < 4; ++i) file[at + 8 + size + i] = static_cast<std::byte>(sum >> (24 - 8 * i));
    at += size + around;
  }
}

}  // namespace

/// Whatever the bytes are, the reader returns or throws Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  std::vector<std::byte> file(bytes.begin(), bytes.end());
  mend_checksums(file);
  try {
    lambert::decode_png(file, "fuzz.png");
  } catch (const lambert::Error&) {
  }
  return 0;
}
