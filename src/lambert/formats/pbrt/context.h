#pragma once
/// What the parts of the pbrt reader share.

#include "lambert/base/notes.h"
#include "lambert/base/transform.h"
#include "lambert/formats/pbrt/parameters.h"
#include "lambert/scene/scene_graph.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace lambert::pbrt {

template <class T>
using ByName = std::map<std::string, T, std::less<>>;

/// The scene under construction and everything in it that has a name.
struct Context {
  SceneGraph& graph;
  Notes& notes;
  std::filesystem::path folder;  ///< of the scene file: all relative paths start here

  ByName<FloatParameter> float_textures;
  ByName<RgbParameter> spectrum_textures;
  ByName<std::optional<MaterialId>> named_materials;  ///< none: the interface material
  ByName<GeometryId> ply_meshes;                      ///< by path
  ByName<std::shared_ptr<const MipMap>> images;
  std::map<std::tuple<MaterialId, float, TextureId>, MaterialId> materials_with_alpha;

  std::filesystem::path resolve(const std::string& path) const { return folder / path; }
};

/// What AttributeBegin saves and AttributeEnd restores.
struct GraphicsState {
  Transform ctm;         ///< at the start of the shutter interval
  Transform ctm_at_end;  ///< at its end
  bool active_start = true, active_end = true;
  bool reverse_orientation = false;
  ColourSpace colour_space;
  std::optional<MaterialId> material;  ///< none: the interface material, which shows nothing
  std::shared_ptr<const ParameterList> area_light;
  ByName<std::vector<Parameter>> attributes;  ///< by target: "shape", "light", "material", "medium", "texture"
};

/// Calls `f`; an Error without a place gets that of the directive.
template <class F>
auto at_directive(const ParameterList& list, F&& f) {
  try {
    return f();
  } catch (const Error& e) {
    list.fail(e.what());
  }
}

/// Throws Error that names the unknown type, the known ones, and a hint if there is one.
[[noreturn]] inline void fail_unknown_type(const ParameterList& list, const char* what, const std::string& type,
                                           const std::vector<std::string>& known, const std::string& hint = "") {
  throw Error(list.place(), std::string("unknown ") + what + " " + unknown_word(type, known) + hint);
}

}  // namespace lambert::pbrt
