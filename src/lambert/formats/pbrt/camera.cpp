#include "lambert/formats/pbrt/camera.h"

#include "lambert/formats/pbrt/old_syntax.h"

namespace lambert::pbrt {
namespace {

/// The image plane's window: the shorter axis spans -1..1 unless the file says otherwise.
ScreenWindow screen_window(const ParameterList& list, Vec2i resolution) {
  const float aspect =
      list.number("frameaspectratio", static_cast<float>(resolution.x) / static_cast<float>(resolution.y));
  if (!(aspect > 0)) list.fail("'frameaspectratio' must be above 0");
  ScreenWindow w;
  if (aspect > 1) {
    w.x_min = -aspect, w.x_max = aspect;
  } else {
    w.y_min = -1 / aspect, w.y_max = 1 / aspect;
  }
  const std::vector<float> given = list.numbers("screenwindow");
  if (!given.empty()) {
    if (given.size() != 4) list.fail("'screenwindow' takes 4 numbers: x min, x max, y min, y max");
    w = {given[0], given[1], given[2], given[3]};
  }
  if (!(w.x_max > w.x_min && w.y_max > w.y_min)) list.fail("the screen window is empty");
  return w;
}

/// Sets what perspective and orthographic cameras share; `unit` is the size of 1 in the screen window.
template <class Projected>
Projected projected(const ParameterList& list, Vec2i resolution, float unit) {
  const ScreenWindow w = screen_window(list, resolution);
  Projected p;
  p.half_width = 0.5f * (w.x_max - w.x_min) * unit, p.half_height = 0.5f * (w.y_max - w.y_min) * unit;
  p.centre = 0.5f * Vec2(w.x_min + w.x_max, w.y_min + w.y_max) * unit;
  p.lens_radius = list.number("lensradius", 0);
  p.focal_distance = list.number("focaldistance", 1e6f);
  if (!(p.lens_radius >= 0 && p.focal_distance > 0)) list.fail("'lensradius' and 'focaldistance' must not be negative");
  return p;
}

Projection perspective_projection(const ParameterList& list, Vec2i resolution) {
  const float fov = list.number("fov", 90);
  if (!(fov > 0 && fov < 180)) list.fail("'fov' must lie between 0 and 180 degrees");
  return projected<Perspective>(list, resolution, tan(degrees(0.5f * fov)));
}

Projection panoramic_projection(const Context& context, const ParameterList& list) {
  const std::string mapping = list.string("mapping", "equalarea");
  if (mapping != "equalarea" && mapping != "equirectangular") {
    list.fail("unknown mapping " + unknown_word(mapping, {"equalarea", "equirectangular"}));
  }
  if (mapping == "equalarea")
    context.notes.add("a spherical camera's mapping 'equalarea' is done as 'equirectangular'");
  return Panoramic{};
}

}  // namespace

std::vector<std::string> camera_types() { return {"perspective", "orthographic", "spherical"}; }

Camera make_camera(const Context& context, const ParameterList& list, const std::string& type,
                   const Transform& camera_from_world, Vec2i resolution) {
  if (camera_from_world.is_singular()) list.fail("the camera's transformation is singular");
  Transform from_local = Transform::scale(Vec3(1, 1, -1));
  Camera camera;
  camera.name = type;
  if (type == "perspective") {
    camera.projection = perspective_projection(list, resolution);
  } else if (type == "orthographic") {
    camera.projection = projected<Orthographic>(list, resolution, 1);
  } else if (type == "spherical") {
    camera.projection = panoramic_projection(context, list);
    // pbrt's panorama has -x in the middle and -z to the right of it, ours -z and +x.
    from_local = Transform(Mat4(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1));
  } else {
    fail_unknown_type(list, "camera", type, camera_types(), old_type_hint(type));
  }
  camera.to_world = camera_from_world.inverse() * from_local;
  camera.resolution = resolution;
  camera.shutter_open = list.number("shutteropen", 0), camera.shutter_close = list.number("shutterclose", 1);
  return camera;
}

}  // namespace lambert::pbrt
