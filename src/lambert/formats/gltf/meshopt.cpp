#include "lambert/formats/gltf/meshopt.h"

#include "lambert/base/error.h"

#include <meshoptimizer.h>

#include <algorithm>

namespace lambert::gltf {
namespace {

/// The library checks some of its preconditions by assertions only.
void check_stride(const JsonView& json, const std::string& mode, const std::string& filter, std::size_t stride,
                  std::size_t count) {
  const bool attributes = mode == "ATTRIBUTES";
  if (attributes ? stride == 0 || stride > 256 || stride % 4 != 0 : stride != 2 && stride != 4)
    json["byteStride"].fail("does not fit the mode " + mode);
  if (mode == "TRIANGLES" && count % 3 != 0) json["count"].fail("is no multiple of 3");
  if (filter == "NONE") return;
  const bool fits = filter == "OCTAHEDRAL" ? stride == 4 || stride == 8 : filter == "QUATERNION" ? stride == 8 : true;
  if (!attributes || !fits) json["filter"].fail("does not fit the mode and byteStride");
}

void check_words(const JsonView& json, const std::string& mode, const std::string& filter) {
  const std::vector<std::string> modes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
  const std::vector<std::string> filters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
  if (std::find(modes.begin(), modes.end(), mode) == modes.end())
    json["mode"].fail("unknown mode " + unknown_word(mode, modes));
  if (std::find(filters.begin(), filters.end(), filter) == filters.end())
    json["filter"].fail("unknown filter " + unknown_word(filter, filters));
}

}  // namespace

std::vector<std::byte> decode_meshopt(const JsonView& json, std::span<const std::byte> compressed, Budget& budget) {
  const std::string mode = json["mode"].text(), filter = json["filter"].text("NONE");
  const std::size_t count = json["count"].count(), stride = json["byteStride"].count();
  check_words(json, mode, filter);
  check_stride(json, mode, filter, stride, count);
  // 16 attribute bytes take at least 2 bits, an index or a triangle at least a byte.
  const std::size_t most = mode == "ATTRIBUTES" ? 64 * compressed.size() / stride : 3 * compressed.size();
  if (count > most) json["count"].fail("is more than the compressed data can hold");
  budget.charge(count, stride, json["count"]);

  std::vector<std::byte> out(count * stride);
  const auto* data = reinterpret_cast<const unsigned char*>(compressed.data());
  int status = 0;
  if (mode == "ATTRIBUTES") {
    status = meshopt_decodeVertexBuffer(out.data(), count, stride, data, compressed.size());
  } else if (mode == "TRIANGLES") {
    status = meshopt_decodeIndexBuffer(out.data(), count, stride, data, compressed.size());
  } else {
    status = meshopt_decodeIndexSequence(out.data(), count, stride, data, compressed.size());
  }
  if (status != 0) json.fail("the compressed data are malformed");
  if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), count, stride);
  if (filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), count, stride);
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), count, stride);
  return out;
}

}  // namespace lambert::gltf
