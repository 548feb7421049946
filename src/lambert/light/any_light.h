#pragma once
#include "lambert/light/environment.h"
#include "lambert/light/light.h"

#include <variant>

namespace lambert {

template <LightModel... Models>
using LightVariant = std::variant<Models...>;
/// The closed set of light sources.
using Light =
    LightVariant<PointLight, SpotLight, DirectionalLight, TriangleLight, QuadLight, ShapeLight, EnvironmentLight>;

inline std::optional<LightSample> sample_light(const Light& light, const LightContext& c, Vec3 p, Vec2 u) {
  return std::visit([&](const auto& l) { return l.sample(c, p, u); }, light);
}
inline LightBounds light_bounds(const Light& light, const LightContext& c) {
  return std::visit([&](const auto& l) { return l.bounds(c); }, light);
}

}  // namespace lambert
