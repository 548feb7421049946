#pragma once
#include "lambert/base/file.h"
#include "lambert/formats/gltf/budget.h"
#include "lambert/formats/gltf/json.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <variant>
#include <vector>

namespace lambert::gltf {

/// Bytes that a URI means, decoded or mapped.
class Resource {
 public:
  explicit Resource(std::vector<std::byte> bytes) : content_(std::move(bytes)) {}
  explicit Resource(MappedFile file) : content_(std::move(file)) {}
  std::span<const std::byte> bytes() const;

 private:
  std::variant<std::vector<std::byte>, MappedFile> content_;
};

/// `place` is a "uri" member.
Resource load_uri(const JsonView& place, const std::filesystem::path& folder);

/// A part of a buffer. A stride of 0 means that elements lie close together.
struct BufferView {
  std::span<const std::byte> bytes;
  std::size_t stride = 0;
};

/// The buffers and buffer views of a document, loaded and decompressed when they are first asked for.
class Buffers {
 public:
  Buffers(JsonView root, std::span<const std::byte> glb_binary, std::filesystem::path folder, Budget& budget)
      : root_(std::move(root)), glb_binary_(glb_binary), folder_(std::move(folder)), budget_(&budget) {}

  /// `reference` is a member that holds the index of a buffer view. Throws Error at the place that is wrong. What is
  /// returned stays valid.
  BufferView view(const JsonView& reference);

 private:
  std::span<const std::byte> buffer(const JsonView& reference);
  std::span<const std::byte> slice(const JsonView& from, std::size_t length);
  BufferView decompressed(std::size_t index, const JsonView& meshopt);

  JsonView root_;
  std::span<const std::byte> glb_binary_;
  std::filesystem::path folder_;
  Budget* budget_;
  std::map<std::size_t, Resource> buffers_;
  std::map<std::size_t, std::vector<std::byte>> decompressed_;
};

/// The element of an array of the root (such as "accessors") that `reference` holds the index of. Throws Error at
/// `reference` when there is none.
JsonView referred(const JsonView& root, const char* array, const JsonView& reference);

}  // namespace lambert::gltf
