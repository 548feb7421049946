#pragma once
#include "lambert/base/angle.h"
#include "lambert/image/probe/map_point.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::probe {

/// Radius of the image of a direction at the angle θ to the axis, up to a constant.
enum class Lens : std::uint8_t {
  equidistant,    ///< θ
  equisolid,      ///< sin θ/2: equal solid angles take equal areas
  stereographic,  ///< tan θ/2
  orthographic,   ///< sin θ
};
Lens lens(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> lens_names();

/// A fisheye image whose disk touches all four sides of the square, looking along -z with +x to the right. With an
/// equidistant lens of 360 degrees it is the angular map of Debevec's light probes: the centre is ahead, the rim
/// behind.
struct Fisheye {
  static constexpr int charts = 1;
  Lens lens = Lens::equidistant;
  Angle field_of_view = degrees(180);  ///< the full angle; see fisheye() for the largest
  static constexpr int axis = -1;      ///< the centre shows -z

  float angle(float radius) const;  ///< θ from the axis, at a radius of [0, 1] on the disk
  float radius(float angle) const;  ///< above 1 for what is not seen

  bool operator==(const Fisheye&) const = default;

  std::optional<Vec3> direction(MapPoint at) const;
  std::optional<MapPoint> point(Vec3 d) const;
  float density(MapPoint at) const;
};

/// Throws Error unless the angle is above 0 and at most 360 degrees (below it for stereographic, 180 for orthographic
/// lenses).
Fisheye fisheye(Lens lens, Angle field_of_view);
inline Fisheye angular_map() { return {Lens::equidistant, degrees(360)}; }

}  // namespace lambert::probe
