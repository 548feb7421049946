#pragma once
#include "lambert/base/angle.h"

#include <array>

namespace lambert::probe {

/// Right-handed turns about +z (roll), then +x (pitch), then +y (yaw): R = Ry Rx Rz. Yaw turns what is ahead (-z) to
/// the left (-x), pitch turns it up.
Mat3 rotation(Angle yaw, Angle pitch, Angle roll);
/// From nine numbers row by row; throws Error unless rows are unit and perpendicular to 1e-3 (mirroring is allowed).
Mat3 rotation(const std::array<float, 9>& rows);

}  // namespace lambert::probe
