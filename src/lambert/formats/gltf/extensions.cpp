#include "lambert/formats/gltf/extensions.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <algorithm>

namespace lambert::gltf {
namespace {

const std::vector<std::string>& known_extensions() {
  static const std::vector<std::string> known{
      "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression",   "EXT_texture_webp",
      "KHR_draco_mesh_compression", "KHR_lights_punctual",       "KHR_materials_anisotropy",
      "KHR_materials_clearcoat",    "KHR_materials_dispersion",  "KHR_materials_emissive_strength",
      "KHR_materials_ior",          "KHR_materials_iridescence", "KHR_materials_pbrSpecularGlossiness",
      "KHR_materials_sheen",        "KHR_materials_specular",    "KHR_materials_transmission",
      "KHR_materials_unlit",        "KHR_materials_variants",    "KHR_materials_volume",
      "KHR_mesh_quantization",      "KHR_texture_transform"};
  return known;
}

bool is_known(const std::string& extension) {
  const auto& known = known_extensions();
  return std::find(known.begin(), known.end(), extension) != known.end();
}

}  // namespace

void check_version_and_extensions(Document& document) {
  const JsonView root = document.root(), asset = root["asset"];
  if (!asset) root["asset"].fail("is missing: this is no glTF document");
  const JsonView minimum = asset["minVersion"], version = minimum ? minimum : asset["version"];
  const std::string text = version.text();
  if (minimum ? text != "2.0" : !text.starts_with("2."))
    version.fail("expected glTF version 2.0, found '" + printable(text) + "'");

  for_each(root["extensionsRequired"], [&](const JsonView& e) {
    if (!is_known(e.text()))
      e.fail("the document requires an unknown extension " + unknown_word(e.text(), known_extensions()));
  });
  for_each(root["extensionsUsed"], [&](const JsonView& e) {
    if (!is_known(e.text())) document.notes.add("glTF extension " + printable(e.text()) + " is ignored");
  });
}

}  // namespace lambert::gltf
