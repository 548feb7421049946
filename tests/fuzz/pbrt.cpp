#include "lambert/base/error.h"
#include "lambert/formats/readers.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

/// Whatever the bytes are, the reader returns or throws Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lambert;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    Notes notes;
    read_pbrt(text, "fuzz.pbrt", {}, notes);
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
