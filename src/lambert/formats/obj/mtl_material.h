#pragma once
#include "lambert/formats/obj/mtl.h"
#include "lambert/scene/scene_graph.h"

#include <filesystem>

namespace lambert::obj {

struct ConvertedMaterial {
  MaterialId material = 0;
  std::optional<Emission> emission;
};

/// What an MTL material means here:
/// - illum 6 and 7, and 4 and 9 with d < 1: a smooth dielectric of index Ni (default 1.5);
/// - illum 5: a mirror of reflectance Ks (white if there is none);
/// - illum 0 and 1, or a black or absent Ks, without PBR keys: diffuse Kd;
/// - else the metallic-roughness model: base colour Kd, metallic Pm, roughness Pr or (2 / (Ns + 2))^(1/4), normal
///   reflectance 0.08 Ks (so that Blender's usual Ks = 0.5 is glass-like 0.04), sheen Ps, clear coat Pc and Pcr.
/// Ke emits from both sides. d and map_d are opacity. A map beside a black Kd or Ke counts as with a white one. Maps
/// that cannot be read are noted.
ConvertedMaterial add_mtl_material(SceneGraph& graph, const std::string& name, const MtlMaterial& mtl,
                                   const std::filesystem::path& folder, Notes& notes);

}  // namespace lambert::obj
