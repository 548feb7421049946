#include "lambert/bsdf/microfacet.h"

#include <algorithm>
#include <cmath>

namespace lambert {

Ggx::Ggx(float alpha_x, float alpha_y) : alpha_x_(std::max(alpha_x, 1e-4f)), alpha_y_(std::max(alpha_y, 1e-4f)) {}

/// D(m) = 1 / (π αx αy ((mx/αx)² + (my/αy)² + mz²)²).
float Ggx::d(Vec3 m) const {
  if (m.z <= 0) return 0;
  const float x = m.x / alpha_x_, y = m.y / alpha_y_;
  const float s = x * x + y * y + m.z * m.z;
  return 1 / (pi * alpha_x_ * alpha_y_ * s * s);
}

/// Λ(w) = (-1 + sqrt(1 + αx² tan²θ cos²φ + αy² tan²θ sin²φ)) / 2.
float Ggx::lambda(Vec3 w) const {
  const float x = alpha_x_ * w.x, y = alpha_y_ * w.y, z2 = w.z * w.z;
  if (z2 == 0) return std::numeric_limits<float>::infinity();
  return 0.5f * (std::sqrt(1 + (x * x + y * y) / z2) - 1);
}

float Ggx::visible_d(Vec3 w, Vec3 m) const {
  const float cosine = dot(w, m);
  if (cosine <= 0 || w.z <= 0) return 0;
  return g1(w) * cosine * d(m) / w.z;
}

Vec3 Ggx::sample_visible(Vec3 w, Vec2 u) const {
  const Vec3 stretched = normalize(Vec3(alpha_x_ * w.x, alpha_y_ * w.y, w.z));
  const float phi = 2 * pi * u.x, z = 1 - u.y * (1 + stretched.z);
  const float ring = std::sqrt(std::clamp(1 - z * z, 0.0f, 1.0f));
  const Vec3 cap(ring * std::cos(phi), ring * std::sin(phi), z);
  const Vec3 half = cap + stretched;
  return normalize(Vec3(alpha_x_ * half.x, alpha_y_ * half.y, std::max(half.z, 1e-7f)));
}

}  // namespace lambert
