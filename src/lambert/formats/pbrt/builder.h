#pragma once
/// The meaning of pbrt's directives: keeps the graphics state and fills the scene.

#include "lambert/formats/pbrt/context.h"

#include <string>
#include <vector>

namespace lambert::pbrt {

class Builder {
 public:
  Builder(SceneGraph& graph, Notes& notes, std::filesystem::path folder);

  const ColourSpace& colour_space() const { return state_.colour_space; }
  void set_colour_space(const std::string& name, const Place& place);

  // Transformations act on the active ones.
  void set_transform(const Transform& t);
  void concat_transform(const Transform& t);
  void set_active_transforms(bool start, bool end) { state_.active_start = start, state_.active_end = end; }
  void define_coordinate_system(const std::string& name) {
    coordinate_systems_[name] = {state_.ctm, state_.ctm_at_end};
  }
  void use_coordinate_system(const std::string& name, const Place& place);

  void begin_attributes() { saved_states_.push_back(state_); }
  void end_attributes(const Place& place);
  void reverse_orientation() { state_.reverse_orientation = !state_.reverse_orientation; }
  void add_attributes(const std::string& target, const ParameterList& list);

  void film(const ParameterList& list, const std::string& type);
  void camera(ParameterList list, const std::string& type);
  void world_begin(const Place& place);
  bool in_world() const { return in_world_; }

  void material(ParameterList list, const std::string& type);
  void make_named_material(ParameterList list, const std::string& name);
  void use_named_material(const std::string& name, const Place& place);
  void texture(ParameterList list, const std::string& name, const std::string& type, const std::string& type_class);
  void light(ParameterList list, const std::string& type);
  void area_light(ParameterList list, const std::string& type);
  void shape(ParameterList list, const std::string& type);

  void begin_object(const std::string& name, const Place& place);
  void end_object(const Place& place);
  void instance(const std::string& name, const Place& place);

  /// Checks that everything that was begun has ended.
  void finish(const Place& end);
  Context& context() { return context_; }

 private:
  struct Placed {
    std::string name;
    Transform to_world;
    Surface surface;
  };
  struct PendingCamera {
    ParameterList list;
    std::string type;
    Transform camera_from_world;
  };
  struct CoordinateSystem {
    Transform start, end;
  };
  void inherit(ParameterList& list, const char* target) const;
  MaterialId default_material();
  std::optional<Emission> emission(GeometryId geometry);
  void place(Placed shape);

  Context context_;
  GraphicsState state_;
  std::vector<GraphicsState> saved_states_;
  ByName<CoordinateSystem> coordinate_systems_;
  ByName<std::vector<Placed>> objects_;
  std::string open_object_;
  bool in_object_ = false, in_world_ = false;
  std::size_t states_outside_object_ = 0;
  Vec2i resolution_;
  std::optional<PendingCamera> camera_;
};

}  // namespace lambert::pbrt
