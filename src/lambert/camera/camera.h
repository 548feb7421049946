#pragma once
/// Cameras look along their local -z, +y up, +x right. Film coordinates are in pixels, (0, 0) the top left corner of
/// the image.

#include "lambert/base/angle.h"
#include "lambert/base/ray.h"
#include "lambert/base/transform.h"
#include "lambert/base/vec.h"

#include <string>
#include <variant>

namespace lambert {

/// What part of the image plane is seen, in units where the shorter (or, for glTF, the vertical) side spans -1..1 at
/// unit distance times tan(fov / 2).
struct ScreenWindow {
  float x_min = -1, x_max = 1, y_min = -1, y_max = 1;
};

/// Pinhole when lens_radius is 0, thin lens otherwise.
struct Perspective {
  float half_width = 0.5f, half_height = 0.5f;  ///< of the image at unit distance: tan of the half angles
  Vec2 centre{0};                               ///< of the image at unit distance (shifted windows)
  float lens_radius = 0;                        ///< scene units
  float focal_distance = 1;                     ///< along the axis
};
struct Orthographic {
  float half_width = 1, half_height = 1;  ///< scene units
  Vec2 centre{0};
  float lens_radius = 0, focal_distance = 1;
};
/// The full sphere in latitude and longitude: the image's centre is -z, its top +y.
struct Panoramic {};

using Projection = std::variant<Perspective, Orthographic, Panoramic>;

/// How a field of view fills an image of another aspect.
enum class FovAxis { shorter, vertical, horizontal };
Perspective perspective(Angle fov, FovAxis axis, Vec2i resolution);

struct CameraRay {
  Ray ray;  ///< world, unit direction
  RayCone cone;
};

struct Camera {
  std::string name;
  Transform to_world;  ///< rigid, perhaps mirrored or scaled: directions are normalised after it
  Projection projection = Perspective{};
  Vec2i resolution{512, 512};
  float shutter_open = 0, shutter_close = 0;

  bool has_lens() const;                                              ///< whether ray() takes notice of u_lens
  bool has_shutter() const { return shutter_close != shutter_open; }  ///< and of u_time
  /// The ray through film point (x, y); `u_lens` picks the point on the lens, `u_time` the moment.
  CameraRay ray(Vec2 film, Vec2 u_lens = Vec2(0.5f), float u_time = 0) const;
  /// How far the point at `t` of a camera ray lies along the camera's axis; along the ray for panoramas.
  float axis_depth(const Ray& ray, float t) const;
  /// The same view at another resolution: a perspective or orthographic image keeps its vertical extent.
  Camera with_resolution(Vec2i r) const;
};

/// A camera that sees all of `bounds` from the front, a little above (for scenes that have none). A single point is
/// seen from some distance, an empty box is taken for the origin.
Camera framing_camera(const Bounds3& bounds, Vec2i resolution);

}  // namespace lambert
