#include "lambert/formats/gltf/buffers.h"

#include "lambert/formats/gltf/meshopt.h"
#include "lambert/formats/gltf/uri.h"

namespace lambert::gltf {

std::span<const std::byte> Resource::bytes() const {
  if (const auto* file = std::get_if<MappedFile>(&content_)) return file->bytes();
  return std::get<std::vector<std::byte>>(content_);
}

Resource load_uri(const JsonView& place, const std::filesystem::path& folder) {
  const std::string uri = place.text();
  if (is_data_uri(uri)) return Resource(decode_data_uri(uri, place));
  return Resource(MappedFile(resolve_uri(uri, folder, place)));
}

JsonView referred(const JsonView& root, const char* array, const JsonView& reference) {
  const std::size_t index = reference.count(), size = root[array].size();
  if (index >= size)
    reference.fail("refers to " + std::to_string(index) + " of " + array + ", but there are " + std::to_string(size));
  return root[array][index];
}

std::span<const std::byte> Buffers::buffer(const JsonView& reference) {
  const JsonView json = referred(root_, "buffers", reference);
  const std::size_t index = reference.count(), length = json["byteLength"].count();
  std::span<const std::byte> bytes = glb_binary_;
  if (json["uri"]) {
    auto known = buffers_.find(index);
    if (known == buffers_.end()) {
      known = buffers_.emplace(index, load_uri(json["uri"], folder_)).first;
      budget_->earn(known->second.bytes().size());
    }
    bytes = known->second.bytes();
  } else if (index != 0 || glb_binary_.empty()) {
    json.fail("has neither a uri nor the binary chunk of a GLB file");
  }
  if (length > bytes.size())
    json["byteLength"].fail("says " + std::to_string(length) + ", but there are " + std::to_string(bytes.size()) +
                            " bytes");
  return bytes.first(length);
}

std::span<const std::byte> Buffers::slice(const JsonView& from, std::size_t length) {
  const auto bytes = buffer(from["buffer"]);
  const std::size_t offset = from["byteOffset"].count(0);
  if (offset > bytes.size() || length > bytes.size() - offset)
    from.fail("bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) +
              " lie outside of the buffer, which has " + std::to_string(bytes.size()));
  return bytes.subspan(offset, length);
}

BufferView Buffers::view(const JsonView& reference) {
  const JsonView json = referred(root_, "bufferViews", reference);
  if (const JsonView meshopt = json.extension("EXT_meshopt_compression"))
    return decompressed(reference.count(), meshopt);
  const std::size_t stride = json["byteStride"].count(0);
  if (stride > 252) json["byteStride"].fail("expected at most 252");
  return {slice(json, json["byteLength"].count()), stride};
}

BufferView Buffers::decompressed(std::size_t index, const JsonView& meshopt) {
  auto known = decompressed_.find(index);
  if (known == decompressed_.end()) {
    const auto compressed = slice(meshopt, meshopt["byteLength"].count());
    known = decompressed_.emplace(index, decode_meshopt(meshopt, compressed, *budget_)).first;
  }
  // Interleaved attributes keep the stride; for indices it is their size.
  return {known->second, meshopt["byteStride"].count()};
}

}  // namespace lambert::gltf
