#include "lambert/image/filter/pyramid.h"

#include "lambert/base/error.h"
#include "lambert/image/filter/separable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert {
namespace {

int half(int size) { return std::max(1, size / 2); }
Vec2i size_of(const Image& image) { return {image.width(), image.height()}; }

/// A pixel's pre-image by its half axes, in texels.
struct Ellipse {
  Vec2 along{0}, across{0};
  float thickness = 0;  // of the shorter one
};
/// The shorter axis grows to the longer one's length over `max_ratio`; then both shrink to a thickness of `most`.
Ellipse ellipse_of(Vec2 dx, Vec2 dy, float max_ratio, float most) {
  // The turn of the pixel that makes the images of its edges orthogonal.
  const float angle = 0.5f * std::atan2(2 * dot(dx, dy), dot(dx, dx) - dot(dy, dy));
  Vec2 a = std::cos(angle) * dx + std::sin(angle) * dy, b = std::cos(angle) * dy - std::sin(angle) * dx;
  if (dot(a, a) < dot(b, b)) std::swap(a, b);
  const float longer = length(a), shorter = length(b);
  if (!(longer > 0)) return {};
  const float thickness = std::max(shorter, longer / std::max(1.0f, max_ratio)),
              shrink = std::min(1.0f, most / thickness);
  const Vec2 across = shorter > 1e-6f * longer ? b * (thickness / shorter) : Vec2(-a.y, a.x) * (thickness / longer);
  return {a * shrink, across * shrink, thickness * shrink};
}

}  // namespace

LookupMethod lookup_method(std::string_view name) {
  const std::vector<std::string> names = lookup_method_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw Error("unknown lookup " + unknown_word(name, names));
  return static_cast<LookupMethod>(found - names.begin());
}

std::vector<std::string> lookup_method_names() { return {"nearest", "bilinear", "trilinear", "anisotropic"}; }

Image halved(const Image& image) {
  return separably_filtered(image, area_taps(image.width(), half(image.width())),
                            area_taps(image.height(), half(image.height())));
}

Pyramid::Pyramid(Image base) {
  levels_.push_back(std::move(base));
  while (levels_.back().width() > 1 || levels_.back().height() > 1) levels_.push_back(halved(levels_.back()));
  find_alpha();
}

Pyramid::Pyramid(std::vector<Image> levels) : levels_(std::move(levels)) {
  bool right = !levels_.empty() && !levels_[0].empty() && size_of(levels_.back()) == Vec2i(1);
  for (std::size_t i = 1; right && i < levels_.size(); ++i)
    right = size_of(levels_[i]) == Vec2i(half(levels_[i - 1].width()), half(levels_[i - 1].height())) &&
            levels_[i].channels() == levels_[0].channels();
  if (!right) throw Error("a pyramid's levels must halve in size down to one pixel, with the same channels");
  find_alpha();
}

void Pyramid::find_alpha() {
  if (const auto a = levels_[0].channel("A")) alpha_ = static_cast<int>(*a);
}

std::size_t Pyramid::value_count() const {
  std::size_t count = 0;
  for (const Image& level : levels_) count += level.pixels().size();
  return count;
}

Vec4 Pyramid::texel(const Image& level, int x, int y) const {
  const Rgb c = level.rgb(x, y);
  return {c.r, c.g, c.b, alpha_ < 0 ? 1 : level.at(x, y, static_cast<std::size_t>(alpha_))};
}

Vec4 Pyramid::lookup(Vec2 uv, const Footprint& footprint, const LookupSettings& settings) const {
  const auto fetch_from = [&](const Image& image) { return [&](int x, int y) { return texel(image, x, y); }; };
  const Image& base = levels_[0];
  if (settings.method == LookupMethod::nearest)
    return nearest_lookup(size_of(base), uv, settings.edges, fetch_from(base));
  const auto bilinear = [&](int i) {
    return bilinear_lookup(size_of(level(i)), uv, settings.edges, fetch_from(level(i)));
  };
  if (settings.method == LookupMethod::bilinear) return bilinear(0);

  const Vec2 size(size_of(base));
  const auto tame = [&](Vec2 v) { return Vec2(tame_coordinate(v.x), tame_coordinate(v.y)) * size; };
  const Vec2 dx = tame(footprint.dx), dy = tame(footprint.dy);
  const auto choose = [&](double texels) {
    const LevelChoice choice = level_for(texels, level_count());
    return static_cast<float>(choice.level + choice.fraction);
  };
  if (settings.method == LookupMethod::trilinear)
    return blended_levels(choose(largest_edge(Footprint{dx, dy})), bilinear);

  const Ellipse ellipse = ellipse_of(dx, dy, settings.max_anisotropy, std::exp2(static_cast<float>(level_count() - 1)));
  if (!(ellipse.thickness > 0)) return bilinear(0);
  return blended_levels(choose(static_cast<double>(ellipse.thickness)), [&](int i) {
    const Vec2 shrunk = Vec2(size_of(level(i))) / size;
    const Vec2 at(tame_coordinate(uv.x * static_cast<float>(level(i).width()) - 0.5f),
                  tame_coordinate(uv.y * static_cast<float>(level(i).height()) - 0.5f));
    return elliptical_lookup(size_of(level(i)), at, ellipse.along * shrunk, ellipse.across * shrunk, settings.edges,
                             fetch_from(level(i)));
  });
}

}  // namespace lambert
