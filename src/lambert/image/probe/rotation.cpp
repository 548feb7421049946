#include "lambert/image/probe/rotation.h"

#include "lambert/base/error.h"

#include <cmath>

namespace lambert::probe {
namespace {

/// A turn by `angle` from axis i towards axis j.
Mat3 turn(Angle angle, int i, int j) {
  Mat3 m(1);
  m[i][i] = m[j][j] = cos(angle);
  m[i][j] = sin(angle), m[j][i] = -sin(angle);
  return m;
}

}  // namespace

Mat3 rotation(Angle yaw, Angle pitch, Angle roll) { return turn(yaw, 2, 0) * turn(pitch, 1, 2) * turn(roll, 0, 1); }

Mat3 rotation(const std::array<float, 9>& rows) {
  Mat3 m;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) m[column][row] = rows[static_cast<std::size_t>(3 * row + column)];
  const Mat3 product = glm::transpose(m) * m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!(std::abs(product[i][j] - (i == j ? 1.0f : 0.0f)) < 1e-3f))
        throw Error("a rotation needs rows that are unit and perpendicular to each other");
  return m;
}

}  // namespace lambert::probe
