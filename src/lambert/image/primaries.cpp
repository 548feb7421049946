#include "lambert/image/primaries.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// X, Y, Z in proportion; Y may be 0, as that of the primaries of XYZ.
Vec3d direction(Vec2d xy) { return {xy.x, xy.y, 1 - xy.x - xy.y}; }

Vec3d white_point(Vec2d xy) {
  if (!(std::abs(xy.y) > 1e-6)) throw Error("the white of its chromaticities has no luminance");
  return direction(xy) / xy.y;
}

glm::dmat3 adaptation(Vec3d from, Vec3d to) {
  const glm::dmat3 bradford =
      glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const Vec3d cones = bradford * from;
  if (std::min({std::abs(cones.x), std::abs(cones.y), std::abs(cones.z)}) < 1e-6)
    throw Error("the white of its chromaticities is no light to adapt from");
  const Vec3d scale = (bradford * to) / cones;
  return glm::inverse(bradford) * glm::dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z) * bradford;
}

}  // namespace

bool same_primaries(const Chromaticities& a, const Chromaticities& b) {
  const auto near = [](Vec2d p, Vec2d q) { return std::abs(p.x - q.x) < 1e-4 && std::abs(p.y - q.y) < 1e-4; };
  return near(a.red, b.red) && near(a.green, b.green) && near(a.blue, b.blue) && near(a.white, b.white);
}

glm::dmat3 rgb_to_xyz(const Chromaticities& c) {
  const glm::dmat3 primaries(direction(c.red), direction(c.green), direction(c.blue));
  const double volume = glm::determinant(primaries);
  if (!std::isfinite(volume) || std::abs(volume) < 1e-9) throw Error("its chromaticities lie on a line");
  const Vec3d scale = glm::inverse(primaries) * white_point(c.white);
  return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

glm::dmat3 to_rec709(const Chromaticities& from) {
  const glm::dmat3 out = glm::inverse(rgb_to_xyz(rec709)), in = rgb_to_xyz(from);
  return same_primaries(from, cie_xyz) ? out * in
                                       : out * adaptation(white_point(from.white), white_point(rec709.white)) * in;
}

std::string text_of(const Chromaticities& c) {
  std::string text;
  for (const Vec2d xy : {c.red, c.green, c.blue, c.white})
    for (const double v : {xy.x, xy.y}) {
      if (!text.empty()) text += ' ';
      append_number(text, static_cast<float>(v));
    }
  return text;
}

}  // namespace lambert
