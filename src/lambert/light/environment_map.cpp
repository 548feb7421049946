#include "lambert/light/environment_map.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/octahedral.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

std::vector<Rgb> checked_texels(const Image& image) {
  std::vector<Rgb> texels;
  texels.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgb c = image.rgb(x, y);
      if (!is_finite(c)) {
        throw Error("environment image: the value at column " + std::to_string(x) + ", row " + std::to_string(y) +
                    " is not finite");
      }
      texels.push_back(max(c, Rgb()));
    }
  }
  return texels;
}

}  // namespace

EnvironmentMap::EnvironmentMap(const Image& image, EnvironmentMapping mapping)
    : mapping_(mapping), width_(image.width()), height_(image.height()) {
  if (image.empty()) throw Error("environment image: it has no pixels");
  if (mapping == EnvironmentMapping::equal_area && width_ != height_) {
    throw Error("environment image: an equal-area octahedral map must be square, not " + std::to_string(width_) +
                " by " + std::to_string(height_));
  }
  texels_ = checked_texels(image);

  std::vector<float> weights(texels_.size());
  Rgb sum;
  double solid_angle = 0;
  for (int y = 0; y < height_; ++y) {
    // Solid angle of a texel, up to a constant.
    const float sin_theta = mapping == EnvironmentMapping::equal_area
                                ? 1.0f
                                : std::sin(pi * (static_cast<float>(y) + 0.5f) / static_cast<float>(height_));
    Rgb row;
    for (int x = 0; x < width_; ++x) {
      const Rgb mean = cell_mean(x, y);
      weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] =
          luminance(mean) * sin_theta;
      row += mean;
    }
    sum += row * (sin_theta / static_cast<float>(width_));
    solid_angle += static_cast<double>(sin_theta);
  }
  mean_ = sum / static_cast<float>(solid_angle);
  if (luminance(mean_) > 0)
    distribution_.emplace(weights, static_cast<std::size_t>(width_), static_cast<std::size_t>(height_));
}

Vec2 EnvironmentMap::to_square(Vec3 d) const {
  if (mapping_ == EnvironmentMapping::equal_area) return probe::equal_area_sphere_to_square(d);
  return {0.5f + std::atan2(d.x, -d.z) / (2 * pi), std::acos(std::clamp(d.y, -1.0f, 1.0f)) * inv_pi};
}

Vec3 EnvironmentMap::to_direction(Vec2 uv) const {
  if (mapping_ == EnvironmentMapping::equal_area) return probe::equal_area_square_to_sphere(uv);
  const float theta = pi * uv.y, phi = 2 * pi * (uv.x - 0.5f), sin_theta = std::sin(theta);
  return {sin_theta * std::sin(phi), std::cos(theta), -sin_theta * std::cos(phi)};
}

/// dω = 2π² sin θ du dv, or 4π du dv where areas are kept.
float EnvironmentMap::square_to_omega(float pdf_uv, float v) const {
  if (mapping_ == EnvironmentMapping::equal_area) return pdf_uv / (4 * pi);
  const float sin_theta = std::sin(pi * v);
  return sin_theta > 0 ? pdf_uv / (2 * pi * pi * sin_theta) : 0;
}

/// Also one texel beyond each border, where the sphere goes on.
Rgb EnvironmentMap::texel(int x, int y) const {
  if (mapping_ == EnvironmentMapping::equal_area) {
    if (x < 0 || x >= width_) x = x < 0 ? 0 : width_ - 1, y = height_ - 1 - y;
    if (y < 0 || y >= height_) y = y < 0 ? 0 : height_ - 1, x = width_ - 1 - x;
  } else {
    if (y < 0 || y >= height_) y = y < 0 ? 0 : height_ - 1, x += width_ / 2;
    x = (x + width_) % width_;
  }
  return texels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
}

Rgb EnvironmentMap::lookup(Vec2 uv) const {
  const float x = uv.x * static_cast<float>(width_) - 0.5f, y = uv.y * static_cast<float>(height_) - 0.5f;
  const int x0 = std::clamp(static_cast<int>(std::floor(x)), -1, width_ - 1);
  const int y0 = std::clamp(static_cast<int>(std::floor(y)), -1, height_ - 1);
  const float s = x - static_cast<float>(x0), t = y - static_cast<float>(y0);
  return lerp(lerp(texel(x0, y0), texel(x0 + 1, y0), s), lerp(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), s), t);
}

/// The mean of the bilinear interpolant over a texel: ∫ of the hat functions gives weights 1/8, 6/8, 1/8 per axis.
Rgb EnvironmentMap::cell_mean(int x, int y) const {
  constexpr float weights[3] = {0.125f, 0.75f, 0.125f};
  Rgb sum;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) sum += weights[i + 1] * weights[j + 1] * texel(x + i, y + j);
  }
  return sum;
}

Rgb EnvironmentMap::radiance(Vec3 direction) const { return lookup(to_square(direction)); }

float EnvironmentMap::pdf_omega(Vec3 direction) const {
  if (!distribution_) return 0;
  const Vec2 uv = to_square(direction);
  return square_to_omega(distribution_->pdf(uv), uv.y);
}

std::optional<EnvironmentMap::Sample> EnvironmentMap::sample(Vec2 u) const {
  if (!distribution_) return std::nullopt;
  const auto [uv, pdf_uv] = distribution_->sample(u);
  const float pdf = square_to_omega(pdf_uv, uv.y);
  if (!(pdf > 0)) return std::nullopt;
  return Sample{to_direction(uv), lookup(uv), pdf};
}

}  // namespace lambert
