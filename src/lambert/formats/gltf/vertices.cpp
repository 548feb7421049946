#include "lambert/formats/gltf/vertices.h"

#include <algorithm>
#include <numeric>

namespace lambert::gltf {

Vertices::Vertices(Document& document, const JsonView& primitive)
    : document_(&document), attributes_(primitive["attributes"]) {
  if (primitive.extension("KHR_draco_mesh_compression")) draco_ = decode_draco(document, primitive);
  total_ = draco_ ? draco_->vertex_count : document.accessor(attributes_["POSITION"]).count();
  read_indices(primitive);
  if (!draco_ && 2 * indices_.size() < total_) select_used();
}

void Vertices::read_indices(const JsonView& primitive) {
  if (draco_) {
    indices_ = std::move(draco_->indices);
  } else if (primitive["indices"]) {
    indices_ = document_->accessor(primitive["indices"]).integers();
  } else {
    document_->budget.charge(total_, sizeof(std::uint32_t), attributes_["POSITION"]);
    indices_.resize(total_);
    std::iota(indices_.begin(), indices_.end(), 0u);
  }
  const auto bad = std::find_if(indices_.begin(), indices_.end(), [this](std::uint32_t i) { return i >= total_; });
  if (bad != indices_.end())
    primitive["indices"].fail("index " + std::to_string(*bad) + " at element " +
                              std::to_string(bad - indices_.begin()) + " is out of range: there are " +
                              std::to_string(total_) + " vertices");
}

void Vertices::select_used() {
  selection_ = indices_;
  std::sort(selection_.begin(), selection_.end());
  selection_.erase(std::unique(selection_.begin(), selection_.end()), selection_.end());
  for (std::uint32_t& index : indices_) {
    const auto found = std::lower_bound(selection_.begin(), selection_.end(), index);
    index = static_cast<std::uint32_t>(found - selection_.begin());
  }
}

Accessor Vertices::matching(const JsonView& reference) const {
  Accessor accessor = document_->accessor(reference);
  if (accessor.count() != total_)
    reference.fail("has " + std::to_string(accessor.count()) + " elements, but there are " + std::to_string(total_) +
                   " vertices");
  return accessor;
}

std::size_t Vertices::components(const std::string& attribute) const {
  return document_->accessor(attributes_[attribute]).components();
}

std::vector<float> Vertices::floats(const std::string& attribute, std::size_t components) const {
  const JsonView reference = attributes_[attribute];
  const auto wrong = [&](std::size_t found) {
    reference.fail("expected " + std::to_string(components) + " components, found " + std::to_string(found));
  };
  if (draco_) {
    const auto decoded = draco_->attributes.find(attribute);
    if (decoded != draco_->attributes.end()) {
      if (decoded->second.components != components) wrong(decoded->second.components);
      return decoded->second.floats;
    }
  }
  const Accessor accessor = matching(reference);
  if (accessor.components() != components) wrong(accessor.components());
  return accessor.floats(selection_);
}

}  // namespace lambert::gltf
