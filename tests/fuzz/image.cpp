#include "lambert/base/error.h"
#include "lambert/image/formats/exif.h"
#include "lambert/image/io.h"

#include <cstddef>
#include <cstdint>
#include <span>

/// Whatever the bytes are, the reader returns or throws Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lambert;
  const auto bytes = std::as_bytes(std::span(data, size));
  try {
    decode_texels(bytes, "fuzz.image");
  } catch (const Error&) {
  }
  // Keeps windows and attributes, honours what textures ignore.
  try {
    decode_image(bytes, "fuzz.image");
  } catch (const Error&) {
  }
  read_exif(bytes);
  return 0;
}
