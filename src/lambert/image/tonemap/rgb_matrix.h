#pragma once
/// 3x3 matrices between colour spaces, from chromaticities; they act on columns.

#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

namespace lambert::tone {

using Matrix3d = glm::dmat3;

/// x and y of CIE 1931.
struct Primaries {
  Vec2d red, green, blue, white;
};
inline constexpr Primaries rec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
inline constexpr Primaries aces_ap1{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};

/// Linear RGB to XYZ such that (1, 1, 1) becomes the white with Y = 1.
Matrix3d rgb_to_xyz(const Primaries& primaries);
/// From one RGB to another; when their whites differ, by Bradford's chromatic adaptation.
Matrix3d rgb_to_rgb(const Primaries& from, const Primaries& to);
/// Mixes each channel with the luminance (weights that sum to 1): 1 leaves all, 0 leaves grey.
Matrix3d saturation_matrix(Vec3d luminance_weights, double amount);

/// A matrix as loops over pixels use it.
struct RgbMatrix {
  explicit RgbMatrix(const Matrix3d& m);
  Rgb operator()(Rgb c) const {
    return {m[0] * c.r + m[1] * c.g + m[2] * c.b, m[3] * c.r + m[4] * c.g + m[5] * c.b,
            m[6] * c.r + m[7] * c.g + m[8] * c.b};
  }
  float m[9];  ///< rows
};

}  // namespace lambert::tone
