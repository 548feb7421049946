#include "lambert/base/error.h"
#include "lambert/polygon/formats/file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Whatever the bytes are, each reader returns or throws Error, and what one has read goes through every format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lambert;
  using namespace lambert::polygon;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  constexpr FileFormat formats[] = {FileFormat::geojson, FileFormat::wkt, FileFormat::vertex_list};
  for (const FileFormat format : formats) {
    Features features;
    try {
      features = parse_features(text, "fuzz", format);
    } catch (const Error&) {
      continue;
    }
    for (const FileFormat other : formats) {
      const Features back = parse_features(features_text(features, other), "written", other);
      if (other != FileFormat::vertex_list && rings_of(back) != rings_of(features)) std::abort();
    }
  }
  return 0;
}
