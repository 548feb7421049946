#pragma once
/// Which light R, G, B and white are: primaries by their CIE 1931 chromaticities, and what changes them.

#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

#include <glm/ext/matrix_double3x3.hpp>

#include <string>

namespace lambert {

struct Chromaticities {
  Vec2d red, green, blue, white;  ///< x and y
};

/// ITU-R BT.709 with white D65: what R, G and B of an Image are.
inline constexpr Chromaticities rec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
/// CIE XYZ as if it were R, G and B.
inline constexpr Chromaticities cie_xyz{{1, 0}, {0, 1}, {0, 0}, {1.0 / 3, 1.0 / 3}};

/// All within 1e-4, four digits being what standards give.
bool same_primaries(const Chromaticities& a, const Chromaticities& b);

/// The matrix from linear RGB to XYZ whose Y of white is 1 (SMPTE RP 177-1993). Throws Error when the primaries lie on
/// a line or white has no luminance.
glm::dmat3 rgb_to_xyz(const Chromaticities& c);

/// From RGB with primaries `from` to Rec. 709: white becomes white, by Bradford's adaptation (Lam 1985, as in
/// ICC.1:2010 Annex E). XYZ has no white of its own: it is taken as measured, and D65 becomes white. Throws as
/// rgb_to_xyz() does.
glm::dmat3 to_rec709(const Chromaticities& from);

inline Rgb apply(const glm::dmat3& m, Rgb c) {
  const Vec3 v = glm::mat3(m) * Vec3(c.r, c.g, c.b);
  return {v.x, v.y, v.z};
}

/// "0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329", as the value of an Attribute.
std::string text_of(const Chromaticities& c);

}  // namespace lambert
