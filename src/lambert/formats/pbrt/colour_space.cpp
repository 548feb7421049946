#include "lambert/formats/pbrt/colour_space.h"

#include "lambert/base/error.h"

#include <array>

namespace lambert::pbrt {
namespace {

using Mat3d = glm::dmat3;

/// Chromaticities (x, y) of the primaries and of white.
struct Primaries {
  const char* name;
  Vec2d red, green, blue, white;
};

// IEC 61966-2-1; SMPTE EG 432-1 (P3 with D65); ITU-R BT.2020; SMPTE ST 2065-1.
constexpr std::array<Primaries, 4> spaces{{
    {"srgb", {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}},
    {"dci-p3", {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}},
    {"rec2020", {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}},
    {"aces2065-1", {0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, {0.32168, 0.33767}},
}};

Vec3d xyz(Vec2d c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

// Columns are the primaries' XYZ, scaled so that their sum is the white point.
Mat3d rgb_to_xyz(const Primaries& p) {
  const auto column = [](Vec2d c) { return Vec3d(c.x, c.y, 1 - c.x - c.y); };
  const Mat3d m(column(p.red), column(p.green), column(p.blue));
  const Vec3d scale = glm::inverse(m) * xyz(p.white);
  return {m[0] * scale.x, m[1] * scale.y, m[2] * scale.z};
}

Mat3d adaptation(Vec2d from, Vec2d to) {
  // Bradford's cone responses (Lam 1985), by columns.
  const Mat3d bradford(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);
  const Vec3d gain = (bradford * xyz(to)) / (bradford * xyz(from));
  const Mat3d scale(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z);
  return glm::inverse(bradford) * scale * bradford;
}

}  // namespace

ColourSpace::ColourSpace(std::string_view name) {
  const Primaries& srgb = spaces[0];
  for (const Primaries& p : spaces) {
    if (name != p.name) continue;
    is_srgb_ = &p == &srgb;
    if (!is_srgb_) {
      to_rec709_ = Mat3(glm::inverse(rgb_to_xyz(srgb)) * adaptation(p.white, srgb.white) * rgb_to_xyz(p));
    }
    return;
  }
  throw Error("unknown colour space " + unknown_word(name, names()));
}

std::vector<std::string> ColourSpace::names() {
  std::vector<std::string> all;
  for (const Primaries& p : spaces) all.emplace_back(p.name);
  return all;
}

Rgb ColourSpace::to_rec709(Rgb c) const {
  const Vec3 v = to_rec709_ * Vec3(c.r, c.g, c.b);
  return {v.x, v.y, v.z};
}

}  // namespace lambert::pbrt
