#pragma once
#include "lambert/formats/gltf/document.h"

namespace lambert::gltf {

/// Which materials primitives show (KHR_materials_variants).
class Variants {
 public:
  /// Throws Error that lists the variants of the document when the settings ask for another one.
  explicit Variants(const Document& document);

  /// The member of `primitive` that holds its material's index; it may be absent.
  JsonView material_of(const JsonView& primitive) const;

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  std::size_t chosen_ = none;
};

}  // namespace lambert::gltf
