#include "lambert/bsdf/fresnel.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace lambert {
namespace {

/// Parallel and perpendicular amplitudes for a complex index, in closed form without square roots of complex numbers
/// (Born and Wolf, "Principles of Optics", 14.2).
float conductor_channel(float c, float eta, float k) {
  const float c2 = c * c, s2 = 1 - c2, eta2 = eta * eta, k2 = k * k;
  const float t0 = eta2 - k2 - s2, a2_b2 = std::sqrt(t0 * t0 + 4 * eta2 * k2);
  const float t1 = a2_b2 + c2, a = std::sqrt(std::max(0.0f, 0.5f * (a2_b2 + t0))), t2 = 2 * c * a;
  const float perpendicular = (t1 - t2) / (t1 + t2);
  const float t3 = c2 * a2_b2 + s2 * s2, t4 = t2 * s2;
  const float parallel = perpendicular * (t3 - t4) / (t3 + t4);
  return 0.5f * (parallel + perpendicular);
}

}  // namespace

float fresnel_dielectric(float cos_i, float eta) {
  if (cos_i < 0) eta = 1 / eta, cos_i = -cos_i;
  cos_i = std::min(cos_i, 1.0f);
  const float sin2_t = (1 - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1) return 1;
  const float cos_t = std::sqrt(1 - sin2_t);
  const float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

Rgb fresnel_conductor(float cos_i, Rgb eta, Rgb k) {
  const float c = std::clamp(cos_i, 0.0f, 1.0f);
  return {conductor_channel(c, eta.r, k.r), conductor_channel(c, eta.g, k.g), conductor_channel(c, eta.b, k.b)};
}

/// R = k² / (4 + k²) for eta = 1.
Rgb conductor_k_of_reflectance(Rgb reflectance) {
  const auto channel = [](float r) {
    const float c = std::clamp(r, 0.0f, 0.9999f);
    return 2 * std::sqrt(c / (1 - c));
  };
  return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

/// ∫ F(cos) 2 cos d(cos), by midpoints: the integrand has a root at the critical angle, where the sum still errs by
/// less than 1e-4.
float diffuse_fresnel(float eta) {
  constexpr int steps = 256;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const float c = (static_cast<float>(i) + 0.5f) / steps;
    sum += static_cast<double>(fresnel_dielectric(c, eta) * 2 * c);
  }
  return static_cast<float>(sum / steps);
}

std::optional<Vec3> refract(Vec3 w, Vec3 n, float eta) {
  const float cos_i = dot(w, n);
  const float sin2_t = std::max(0.0f, 1 - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1) return std::nullopt;
  return -w / eta + (cos_i / eta - std::sqrt(1 - sin2_t)) * n;
}

}  // namespace lambert
