#pragma once
#include "lambert/base/angle.h"
#include "lambert/base/bounds.h"
#include "lambert/base/ray.h"
#include "lambert/base/vec.h"

namespace lambert {

/// An affine map with its inverse, which knows points, vectors and normals apart.
class Transform {
 public:
  Transform() = default;
  /// Inverts `m`. A singular matrix, or one whose inverse overflows, gives an inverse of zeros; see is_singular().
  explicit Transform(const Mat4& m);
  Transform(const Mat4& m, const Mat4& inverse) : m_(m), inverse_(inverse) {}

  static Transform translate(Vec3 d);
  static Transform scale(Vec3 s);
  static Transform rotate(Angle a, Vec3 axis);
  /// The camera's place in the world: looks from `eye` to `target`, local -z forward, +y up, +x right.
  static Transform look_at(Vec3 eye, Vec3 target, Vec3 up);

  const Mat4& matrix() const { return m_; }
  const Mat4& inverse_matrix() const { return inverse_; }
  Transform inverse() const { return {inverse_, m_}; }
  friend Transform operator*(const Transform& a, const Transform& b) { return {a.m_ * b.m_, b.inverse_ * a.inverse_}; }
  bool operator==(const Transform&) const = default;

  Vec3 point(Vec3 p) const { return Vec3(m_ * Vec4(p, 1)); }
  Vec3 vector(Vec3 v) const { return Vec3(m_ * Vec4(v, 0)); }
  /// By the inverse transpose; not normalised.
  Vec3 normal(Vec3 n) const { return glm::transpose(Mat3(inverse_)) * n; }
  /// The direction is not renormalised, so t means the same on both sides.
  Ray ray(const Ray& r) const;
  Bounds3 bounds(const Bounds3& b) const;

  bool is_identity() const { return m_ == Mat4(1); }
  bool is_singular() const { return inverse_ == Mat4(0); }
  /// Mirrors: turns counter-clockwise triangles into clockwise ones.
  bool swaps_handedness() const { return glm::determinant(Mat3(m_)) < 0; }

 private:
  Mat4 m_{1}, inverse_{1};
};

}  // namespace lambert
