#pragma once
#include "lambert/formats/gltf/draco.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lambert::gltf {

/// The vertices of a primitive: its attributes, from accessors or Draco data, and its indices. When the indices use few
/// of many vertices (several primitives share one set of accessors), only those are read.
class Vertices {
 public:
  /// Throws Error when an index is out of range.
  Vertices(Document& document, const JsonView& primitive);

  std::size_t count() const { return selection_.empty() ? total_ : selection_.size(); }
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  bool has(const std::string& attribute) const { return attributes_[attribute].exists(); }
  std::size_t components(const std::string& attribute) const;
  /// One vector per vertex; none when the attribute is absent. Throws Error when there are more or fewer.
  template <class Vec>
  std::vector<Vec> vectors(const std::string& attribute) const {
    return has(attribute) ? grouped<Vec>(floats(attribute, static_cast<std::size_t>(Vec::length())))
                          : std::vector<Vec>{};
  }
  /// The same for an accessor that goes with the vertices (a morph target's).
  template <class Vec>
  std::vector<Vec> vectors(const JsonView& reference) const {
    return reference ? matching(reference).template vectors<Vec>(selection_) : std::vector<Vec>{};
  }

 private:
  void read_indices(const JsonView& primitive);
  void select_used();
  Accessor matching(const JsonView& reference) const;
  std::vector<float> floats(const std::string& attribute, std::size_t components) const;

  Document* document_;
  JsonView attributes_;
  std::optional<DracoMesh> draco_;
  std::size_t total_ = 0;
  std::vector<std::uint32_t> indices_;
  Selection selection_;
};

}  // namespace lambert::gltf
