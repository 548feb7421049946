#pragma once
/// The materials of an MTL file as it states them.

#include "lambert/base/notes.h"
#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace lambert::obj {

/// `map_Kd -s 2 2 -clamp on picture.png`
struct MtlMap {
  std::string file;  ///< empty: no map
  Vec2 scale{1}, offset{0};
  bool clamp = false;
  float multiplier = 1;  ///< -bm
};

struct MtlMaterial {
  std::optional<Rgb> kd, ks, ke;
  std::optional<float> ns, ni, dissolve;
  std::optional<float> roughness, metallic, sheen, clearcoat, clearcoat_roughness, anisotropy, anisotropy_rotation;
  int illumination = 2;
  MtlMap map_kd, map_ke, map_dissolve, map_roughness, map_metallic, normal_map;

  bool has_pbr_keys() const { return roughness || metallic || sheen || clearcoat || anisotropy; }
};

using MtlLibrary = std::map<std::string, MtlMaterial, std::less<>>;

/// Adds to `library`. Unknown keys are noted; numbers that are none throw Error with line and column.
void parse_mtl(std::string_view text, const std::string& name, MtlLibrary& library, Notes& notes);

}  // namespace lambert::obj
