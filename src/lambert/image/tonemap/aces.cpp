#include "lambert/image/tonemap/aces.h"

namespace lambert::tone {
namespace {

Vec3d luminance_weights(const Primaries& p) {
  const Matrix3d m = rgb_to_xyz(p);
  return {m[0].y, m[1].y, m[2].y};
}

}  // namespace

Matrix3d Aces::input_matrix() {
  return saturation_matrix(luminance_weights(aces_ap1), 0.96) * rgb_to_rgb(rec709, aces_ap1);
}

Matrix3d Aces::output_matrix() {
  return rgb_to_rgb(aces_ap1, rec709) * saturation_matrix(luminance_weights(aces_ap1), 0.93);
}

}  // namespace lambert::tone
