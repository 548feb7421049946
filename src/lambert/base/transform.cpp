#include "lambert/base/transform.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace lambert {

Transform::Transform(const Mat4& m) : m_(m) {
  // In double: a scene's matrices may mix millimetres and kilometres.
  const glm::dmat4 wide(m);
  const double det = glm::determinant(wide);
  inverse_ = det != 0 && std::isfinite(det) ? Mat4(glm::inverse(wide)) : Mat4(0);
  if (!is_finite(inverse_)) inverse_ = Mat4(0);
}

Transform Transform::translate(Vec3 d) { return {glm::translate(Mat4(1), d), glm::translate(Mat4(1), -d)}; }
Transform Transform::scale(Vec3 s) { return Transform(glm::scale(Mat4(1), s)); }
Transform Transform::rotate(Angle a, Vec3 axis) {
  const Mat4 m = glm::rotate(Mat4(1), a.radians(), normalize(axis));
  return {m, glm::transpose(m)};
}
Transform Transform::look_at(Vec3 eye, Vec3 target, Vec3 up) {
  const Mat4 world_to_camera = glm::lookAt(eye, target, up);
  return Transform(world_to_camera).inverse();
}

Ray Transform::ray(const Ray& r) const {
  Ray moved = r;
  moved.origin = point(r.origin), moved.direction = vector(r.direction);
  return moved;
}

Bounds3 Transform::bounds(const Bounds3& b) const {
  Bounds3 moved;
  if (b.empty()) return moved;
  for (int i = 0; i < 8; ++i) moved.add(point(b.corner(i)));
  return moved;
}

}  // namespace lambert
