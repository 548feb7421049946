#include "lambert/formats/pbrt/lights.h"

#include "lambert/formats/pbrt/image_textures.h"
#include "lambert/formats/pbrt/infinite_light.h"
#include "lambert/formats/pbrt/old_syntax.h"
#include "lambert/formats/pbrt/spectra.h"

#include <cmath>

namespace lambert::pbrt {
namespace {

Rgb emission_colour(const Context& c, const ParameterList& list, const char* name) {
  return rgb_value(c, list, name, Rgb(1.0f), SpectrumRole::illuminant);
}

/// "power" asks for that luminous power whatever the colour; `unit_power` is that of unit intensity or radiance.
float power_scale(const ParameterList& list, float unit_power) {
  const float power = list.number("power", -1);
  return list.number("scale", 1) * (power > 0 && unit_power > 0 ? power / unit_power : 1);
}

/// The world direction from "from" to "to".
Vec3 direction(const ParameterList& list, const GraphicsState& state) {
  const Vec3 d = state.ctm.vector(list.point("to", Vec3(0, 0, 1)) - list.point("from", Vec3(0)));
  if (!(length_squared(d) > 0)) list.fail("'from' and 'to' are the same point");
  return normalize(d);
}

PointLight point_light(const Context& c, const ParameterList& list, const GraphicsState& state) {
  PointLight light;
  light.position = state.ctm.point(list.point("from", Vec3(0)));
  light.intensity = emission_colour(c, list, "I") * power_scale(list, 4 * pi);
  return light;
}

SpotLight spot_light(const Context& c, const ParameterList& list, const GraphicsState& state) {
  SpotLight light;
  light.position = state.ctm.point(list.point("from", Vec3(0)));
  light.direction = direction(list, state);
  const float outer = list.number("coneangle", 30), delta = list.number("conedeltaangle", 5);
  if (!(outer > 0 && outer <= 180 && delta >= 0)) {
    list.fail("'coneangle' must lie in (0, 180] degrees and 'conedeltaangle' must not be negative");
  }
  light.cos_outer = cos(degrees(outer)), light.cos_inner = cos(degrees(std::max(outer - delta, 0.0f)));
  light.falloff = SpotLight::Falloff::smoothstep;
  const float unit_power = 2 * pi * ((1 - light.cos_inner) + (light.cos_inner - light.cos_outer) / 2);
  light.intensity = emission_colour(c, list, "I") * power_scale(list, unit_power);
  return light;
}

DirectionalLight distant_light(const Context& c, const ParameterList& list, const GraphicsState& state) {
  DirectionalLight light;
  light.direction = direction(list, state);
  const float illuminance = list.number("illuminance", -1);
  light.irradiance = emission_colour(c, list, "L") * (list.number("scale", 1) * (illuminance > 0 ? illuminance : 1));
  return light;
}

}  // namespace

std::vector<std::string> light_types() { return {"point", "spot", "distant", "infinite"}; }

void add_light(Context& context, const ParameterList& list, const std::string& type, const GraphicsState& state) {
  if (type == "point") {
    context.graph.add_light(point_light(context, list, state));
  } else if (type == "spot") {
    context.graph.add_light(spot_light(context, list, state));
  } else if (type == "distant") {
    context.graph.add_light(distant_light(context, list, state));
  } else if (type == "infinite") {
    context.graph.add_light(infinite_light(context, list, state));
  } else {
    fail_unknown_type(list, "light", type, light_types(), old_type_hint(type));
  }
}

Emission area_emission(Context& context, const ParameterList& list, float area) {
  Emission emission;
  emission.radiance.value = emission_colour(context, list, "L");
  emission.two_sided = list.boolean("twosided", false);
  if (const std::string file = list.string("filename", ""); !file.empty()) {
    emission.radiance.texture = add_plain_image(context, list, file);
  }
  // A diffuse emitter of unit radiance has the exitance π.
  emission.radiance.value *= power_scale(list, (emission.two_sided ? 2.0f : 1.0f) * pi * area);
  return emission;
}

}  // namespace lambert::pbrt
