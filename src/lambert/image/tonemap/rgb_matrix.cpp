#include "lambert/image/tonemap/rgb_matrix.h"

namespace lambert::tone {
namespace {

Vec3d xyz(Vec2d chromaticity) {
  return {chromaticity.x / chromaticity.y, 1, (1 - chromaticity.x - chromaticity.y) / chromaticity.y};
}

Matrix3d diagonal(Vec3d d) { return {Vec3d(d.x, 0, 0), Vec3d(0, d.y, 0), Vec3d(0, 0, d.z)}; }

/// Scales in Bradford's cone responses.
Matrix3d adaptation(Vec2d from, Vec2d to) {
  const Matrix3d cones =
      glm::transpose(Matrix3d(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const Vec3d source = cones * xyz(from), target = cones * xyz(to);
  return glm::inverse(cones) * diagonal(target / source) * cones;
}

}  // namespace

Matrix3d rgb_to_xyz(const Primaries& p) {
  const Matrix3d columns(xyz(p.red), xyz(p.green), xyz(p.blue));
  return columns * diagonal(glm::inverse(columns) * xyz(p.white));
}

Matrix3d rgb_to_rgb(const Primaries& from, const Primaries& to) {
  const Matrix3d into = glm::inverse(rgb_to_xyz(to));
  if (from.white == to.white) return into * rgb_to_xyz(from);
  return into * adaptation(from.white, to.white) * rgb_to_xyz(from);
}

Matrix3d saturation_matrix(Vec3d weights, double amount) {
  const Matrix3d grey = glm::transpose(Matrix3d(weights, weights, weights));
  return Matrix3d(amount) + (1 - amount) * grey;
}

RgbMatrix::RgbMatrix(const Matrix3d& matrix) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) m[3 * row + column] = static_cast<float>(matrix[column][row]);
}

}  // namespace lambert::tone
