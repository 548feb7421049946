#include "lambert/formats/gltf/variants.h"

#include "lambert/base/error.h"

#include <algorithm>

namespace lambert::gltf {

Variants::Variants(const Document& document) {
  const std::string& wanted = document.settings.variant;
  if (wanted.empty()) return;
  std::vector<std::string> names;
  for_each(document.root().extension("KHR_materials_variants")["variants"],
           [&](const JsonView& variant) { names.push_back(variant["name"].text()); });
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (names.empty()) throw Error(document.name + ": has no material variants, so there is no '" + wanted + "'");
  if (found == names.end()) throw Error(document.name + ": unknown variant " + unknown_word(wanted, names));
  chosen_ = static_cast<std::size_t>(found - names.begin());
}

JsonView Variants::material_of(const JsonView& primitive) const {
  JsonView material = primitive["material"];
  if (chosen_ == none) return material;
  for_each(primitive.extension("KHR_materials_variants")["mappings"], [&](const JsonView& mapping) {
    for_each(mapping["variants"], [&](const JsonView& variant) {
      if (variant.count() == chosen_) material = mapping["material"];
    });
  });
  return material;
}

}  // namespace lambert::gltf
