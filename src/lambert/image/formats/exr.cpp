#include "lambert/image/formats/codecs.h"
#include "lambert/image/formats/exr_reader.h"
#include "lambert/image/formats/exr_writer.h"

namespace lambert {

Image decode_exr(Bytes data, const std::string& name) {
  ExrReader reader(data, name);
  Image image = image_of(reader.header());
  reader.read(0, image.height(), image.pixels().data());
  return image;
}

std::vector<std::byte> encode_exr(const Image& image, const WriteOptions& options) {
  ExrWriter writer({}, {}, header_of(image), options);
  writer.write(image.pixels());
  return writer.finish();
}

}  // namespace lambert
