#include "lambert/formats/pbrt/builder.h"

#include "lambert/formats/pbrt/camera.h"
#include "lambert/formats/pbrt/film.h"
#include "lambert/formats/pbrt/lights.h"
#include "lambert/formats/pbrt/materials.h"
#include "lambert/formats/pbrt/old_syntax.h"
#include "lambert/formats/pbrt/shapes.h"
#include "lambert/formats/pbrt/textures.h"

#include <algorithm>
#include <utility>

namespace lambert::pbrt {
namespace {

template <class Map>
std::vector<std::string> keys(const Map& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

const std::vector<std::string> attribute_targets{"shape", "light", "material", "medium", "texture"};

}  // namespace

Builder::Builder(SceneGraph& graph, Notes& notes, std::filesystem::path folder)
    : context_{graph, notes, std::move(folder), {}, {}, {}, {}, {}, {}}, resolution_(default_resolution) {
  // Its id is taken on first use: a scene that names all its materials has no other.
  state_.material = no_material;
}

void Builder::set_transform(const Transform& t) {
  if (state_.active_start) state_.ctm = t;
  if (state_.active_end) state_.ctm_at_end = t;
}

void Builder::concat_transform(const Transform& t) {
  if (state_.active_start) state_.ctm = state_.ctm * t;
  if (state_.active_end) state_.ctm_at_end = state_.ctm_at_end * t;
}

void Builder::set_colour_space(const std::string& name, const Place& place) {
  if (const auto known = ColourSpace::names(); std::find(known.begin(), known.end(), name) == known.end()) {
    throw Error(place, "unknown colour space " + unknown_word(name, known));
  }
  state_.colour_space = ColourSpace(name);
}

void Builder::use_coordinate_system(const std::string& name, const Place& place) {
  const auto found = coordinate_systems_.find(name);
  if (found == coordinate_systems_.end()) {
    throw Error(place, "unknown coordinate system " + unknown_word(name, keys(coordinate_systems_)));
  }
  state_.ctm = found->second.start, state_.ctm_at_end = found->second.end;
}

void Builder::end_attributes(const Place& place) {
  if (saved_states_.size() <= states_outside_object_) throw Error(place, "AttributeEnd without AttributeBegin");
  state_ = std::move(saved_states_.back());
  saved_states_.pop_back();
}

void Builder::add_attributes(const std::string& target, const ParameterList& list) {
  if (std::find(attribute_targets.begin(), attribute_targets.end(), target) == attribute_targets.end()) {
    throw Error(list.place(), "unknown target of Attribute: " + unknown_word(target, attribute_targets));
  }
  std::vector<Parameter>& known = state_.attributes[target];
  for (Parameter p : list.all()) {
    p.inherited = true;
    std::erase_if(known, [&](const Parameter& q) { return q.name == p.name; });
    known.push_back(std::move(p));
  }
}

void Builder::inherit(ParameterList& list, const char* target) const {
  if (const auto found = state_.attributes.find(target); found != state_.attributes.end()) list.inherit(found->second);
}

void Builder::film(const ParameterList& list, const std::string& type) {
  resolution_ = read_film(context_, list, type);
}

void Builder::camera(ParameterList list, const std::string& type) {
  coordinate_systems_["camera"] = {state_.ctm.inverse(), state_.ctm_at_end.inverse()};
  if (state_.ctm != state_.ctm_at_end) context_.notes.add("motion of the camera is ignored: it stands as at the start");
  camera_ = {std::move(list), type, state_.ctm};
}

void Builder::world_begin(const Place& place) {
  if (in_world_) throw Error(place, "WorldBegin is given twice");
  in_world_ = true;
  if (camera_) {
    context_.graph.add_camera(
        make_camera(context_, camera_->list, camera_->type, camera_->camera_from_world, resolution_));
    camera_->list.note_unused(context_.notes);
  }
  state_.ctm = state_.ctm_at_end = Transform();
  state_.active_start = state_.active_end = true;
  coordinate_systems_["world"] = {};
}

void Builder::material(ParameterList list, const std::string& type) {
  inherit(list, "material");
  state_.material = add_material(context_, list, type, "");
  list.note_unused(context_.notes);
}

void Builder::make_named_material(ParameterList list, const std::string& name) {
  inherit(list, "material");
  if (!list.has("type")) list.fail("has no \"string type\"");
  context_.named_materials[name] = add_material(context_, list, list.string("type", ""), name);
  list.note_unused(context_.notes);
}

void Builder::use_named_material(const std::string& name, const Place& place) {
  const auto found = context_.named_materials.find(name);
  if (found == context_.named_materials.end()) {
    throw Error(place, "unknown material " + unknown_word(name, keys(context_.named_materials)));
  }
  state_.material = found->second;
}

void Builder::texture(ParameterList list, const std::string& name, const std::string& type,
                      const std::string& type_class) {
  inherit(list, "texture");
  if (type == "float") {
    add_float_texture(context_, list, name, type_class, state_);
  } else if (type == "spectrum") {
    add_spectrum_texture(context_, list, name, type_class, state_);
  } else {
    list.fail("unknown type of texture " + unknown_word(type, {"float", "spectrum"}) +
              old_parameter_type_hint(type == "color" ? type : ""));
  }
  list.note_unused(context_.notes);
}

void Builder::light(ParameterList list, const std::string& type) {
  inherit(list, "light");
  add_light(context_, list, type, state_);
  list.note_unused(context_.notes);
}

void Builder::area_light(ParameterList list, const std::string& type) {
  inherit(list, "light");
  if (type != "diffuse") fail_unknown_type(list, "area light", type, {"diffuse"}, old_type_hint(type));
  area_emission(context_, list, 1);  // so that its faults show even if no shape follows
  list.note_unused(context_.notes);
  state_.area_light = std::make_shared<const ParameterList>(std::move(list));
}

MaterialId Builder::default_material() {
  const auto [entry, is_new] = context_.named_materials.try_emplace("", no_material);
  if (is_new) {
    Material m;
    m.name = "default";
    entry->second = context_.graph.materials.add(std::move(m));
  }
  return *entry->second;
}

std::optional<Emission> Builder::emission(GeometryId geometry) {
  if (!state_.area_light) return std::nullopt;
  const float area = world_area(context_.graph.geometry(geometry), state_.ctm);
  return area_emission(context_, *state_.area_light, area);
}

void Builder::shape(ParameterList list, const std::string& type) {
  inherit(list, "shape");
  if (state_.ctm.is_singular()) list.fail("its transformation is singular");
  if (state_.ctm != state_.ctm_at_end) context_.notes.add("motion of shapes is ignored: they stand as at the start");
  Surface surface;
  surface.geometry = add_geometry(context_, list, type);
  const FloatParameter alpha = float_parameter(context_, list, "alpha", 1);
  list.note_unused(context_.notes);
  if (!state_.material) {
    context_.notes.add(state_.area_light ? "area lights with the interface material are ignored"
                                         : "shapes with the interface material show nothing and are left out");
    return;
  }
  if (*state_.material == no_material) state_.material = default_material();
  surface.material = with_alpha(context_, *state_.material, alpha);
  surface.emission = emission(surface.geometry);
  surface.reverse_orientation = state_.reverse_orientation;
  place({type + " at line " + std::to_string(list.place().line), state_.ctm, std::move(surface)});
}

void Builder::place(Placed shape) {
  if (in_object_) {
    objects_[open_object_].push_back(std::move(shape));
    return;
  }
  SceneGraph& graph = context_.graph;
  graph.add_surface(graph.add_node(graph.root(), std::move(shape.name), shape.to_world), std::move(shape.surface));
}

void Builder::begin_object(const std::string& name, const Place& place) {
  if (in_object_) throw Error(place, "ObjectBegin within an object");
  if (objects_.contains(name)) throw Error(place, "object '" + name + "' is defined twice");
  begin_attributes();
  objects_[name];
  open_object_ = name, in_object_ = true;
  states_outside_object_ = saved_states_.size();
}

void Builder::end_object(const Place& place) {
  if (!in_object_) throw Error(place, "ObjectEnd without ObjectBegin");
  if (saved_states_.size() != states_outside_object_) throw Error(place, "ObjectEnd before AttributeEnd");
  in_object_ = false;
  states_outside_object_ = 0;
  end_attributes(place);
}

void Builder::instance(const std::string& name, const Place& place) {
  if (in_object_) throw Error(place, "ObjectInstance cannot stand within an object");
  const auto found = objects_.find(name);
  if (found == objects_.end()) throw Error(place, "unknown object " + unknown_word(name, keys(objects_)));
  if (state_.ctm.is_singular()) throw Error(place, "the transformation of the instance is singular");
  SceneGraph& graph = context_.graph;
  const NodeId node = graph.add_node(graph.root(), name, state_.ctm);
  for (const Placed& shape : found->second) {
    const bool in_place = shape.to_world.is_identity();
    graph.add_surface(in_place ? node : graph.add_node(node, shape.name, shape.to_world), shape.surface);
  }
}

void Builder::finish(const Place& end) {
  if (!in_world_) throw Error(end, "the file ends without WorldBegin");
  if (in_object_) throw Error(end, "the file ends before ObjectEnd of '" + open_object_ + "'");
  if (!saved_states_.empty()) throw Error(end, "the file ends before AttributeEnd");
}

}  // namespace lambert::pbrt
