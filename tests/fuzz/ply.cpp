#include "lambert/base/error.h"
#include "lambert/formats/readers.h"

#include <cstddef>
#include <cstdint>
#include <span>

/// Whatever the bytes are, the reader returns or throws Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lambert;
  const auto bytes = std::as_bytes(std::span(data, size));
  try {
    Notes notes;
    read_ply(bytes, "fuzz.ply", notes);
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
