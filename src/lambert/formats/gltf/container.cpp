#include "lambert/formats/gltf/container.h"

#include "lambert/base/error.h"

#include <cstdint>

namespace lambert::gltf {
namespace {

constexpr std::uint32_t glb_magic = 0x46546c67, json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;

std::uint32_t word_at(std::span<const std::byte> data, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(data[offset + i]) << (8 * i);
  return word;
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Container split_container(std::span<const std::byte> data, const std::string& name) {
  if (data.size() < 4 || word_at(data, 0) != glb_magic) return {as_text(data), {}};
  const auto fail = [&](std::size_t offset, const std::string& why) {
    throw Error(name + ": GLB at byte " + std::to_string(offset) + ": " + why);
  };
  if (data.size() < 12) fail(data.size(), "the header is cut off");
  if (word_at(data, 4) != 2) fail(4, "expected version 2, found " + std::to_string(word_at(data, 4)));
  const std::size_t length = word_at(data, 8);
  if (length > data.size())
    fail(8, "says that it has " + std::to_string(length) + " bytes, but the file has " + std::to_string(data.size()));

  Container parts;
  // Padding behind the last chunk is no chunk.
  for (std::size_t offset = 12, index = 0; offset + 8 <= length; ++index) {
    const std::size_t size = word_at(data, offset);
    const std::uint32_t type = word_at(data, offset + 4);
    if (size > length - offset - 8)
      fail(offset, "a chunk of " + std::to_string(size) + " bytes does not fit into the file");
    const auto content = data.subspan(offset + 8, size);
    if (index == 0 && type != json_chunk) fail(offset + 4, "expected the JSON chunk first");
    if (index == 0) parts.json = as_text(content);
    if (index == 1 && type == binary_chunk) parts.binary = content;
    offset += 8 + size;
  }
  if (parts.json.empty()) fail(12, "there is no JSON chunk");
  return parts;
}

}  // namespace lambert::gltf
