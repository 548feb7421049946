#include "lambert/image/probe/fisheye.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/image/probe/disk.h"

#include <algorithm>
#include <cmath>

namespace lambert::probe {
namespace {

constexpr std::string_view names[] = {"equidistant", "equisolid", "stereographic", "orthographic"};

/// The lens' function of θ, its inverse and its derivative.
float forward(Lens lens, float theta) {
  switch (lens) {
    case Lens::equidistant: return theta;
    case Lens::equisolid: return std::sin(0.5f * theta);
    case Lens::stereographic: return std::tan(0.5f * theta);
    case Lens::orthographic: return std::sin(theta);
  }
  return 0;
}
float inverse(Lens lens, float r) {
  switch (lens) {
    case Lens::equidistant: return r;
    case Lens::equisolid: return 2 * std::asin(std::min(r, 1.0f));
    case Lens::stereographic: return 2 * std::atan(r);
    case Lens::orthographic: return std::asin(std::min(r, 1.0f));
  }
  return 0;
}
float slope(Lens lens, float theta) {
  switch (lens) {
    case Lens::equidistant: return 1;
    case Lens::equisolid: return 0.5f * std::cos(0.5f * theta);
    case Lens::stereographic: return 0.5f / sqr(std::cos(0.5f * theta));
    case Lens::orthographic: return std::cos(theta);
  }
  return 0;
}

}  // namespace

Lens lens(std::string_view name) {
  const auto found = std::find(std::begin(names), std::end(names), name);
  if (found == std::end(names)) throw Error("unknown lens " + unknown_word(name, lens_names()));
  return static_cast<Lens>(found - std::begin(names));
}

std::vector<std::string> lens_names() { return {std::begin(names), std::end(names)}; }

Fisheye fisheye(Lens lens, Angle field_of_view) {
  const float most = lens == Lens::stereographic ? 359 : lens == Lens::orthographic ? 180 : 360;
  if (!(field_of_view.degrees() > 0 && field_of_view.degrees() <= most + 1e-3f))
    throw Error("the field of view of an " + std::string(names[static_cast<std::size_t>(lens)]) +
                " lens must be above 0 and at most " + number_text(static_cast<double>(most)) + " degrees, not " +
                number_text(std::round(1e3 * static_cast<double>(field_of_view.degrees())) / 1e3));
  return {lens, field_of_view};
}

float Fisheye::angle(float r) const { return inverse(lens, r * forward(lens, 0.5f * field_of_view.radians())); }

float Fisheye::radius(float theta) const {
  const float half = 0.5f * field_of_view.radians();
  return theta > half ? 2 : forward(lens, theta) / forward(lens, half);
}

std::optional<Vec3> Fisheye::direction(MapPoint at) const {
  const Vec2 p = disk_point(at.uv);
  const float r = std::sqrt(dot(p, p));
  if (r > 1) return std::nullopt;
  const float theta = angle(r);
  return Vec3(r > 0 ? p * (std::sin(theta) / r) : Vec2(0), -std::cos(theta));
}

std::optional<MapPoint> Fisheye::point(Vec3 d) const {
  const float across = std::hypot(d.x, d.y), r = radius(std::atan2(across, -d.z));
  if (r > 1) return std::nullopt;
  return MapPoint{0, disk_uv(r * (across > 0 ? Vec2(d) / across : Vec2(1, 0)))};
}

/// dω / dA = sin θ / (r dr/dθ), with du dv = dA / 4.
float Fisheye::density(MapPoint at) const {
  const Vec2 p = disk_point(at.uv);
  const float r = std::sqrt(dot(p, p)), scale = forward(lens, 0.5f * field_of_view.radians());
  if (r > 1) return 0;
  if (r < 1e-6f) return 4 * sqr(scale / slope(lens, 0));
  const float theta = inverse(lens, r * scale);
  return 4 * std::max(std::sin(theta), 0.0f) * scale / (r * std::max(slope(lens, theta), 1e-3f));
}

}  // namespace lambert::probe
