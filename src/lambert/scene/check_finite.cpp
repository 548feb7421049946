#include "lambert/scene/check_finite.h"

#include "lambert/base/error.h"

#include <cmath>

namespace lambert {
namespace {

bool finite(float x) { return std::isfinite(x); }
bool finite(Vec3 v) { return is_finite(v); }
bool finite(Rgb c) { return is_finite(c); }
bool finite(const RgbParameter& p) { return finite(p.value); }
bool finite(const FloatParameter& p) { return finite(p.value); }
bool finite(const Roughness& r) { return finite(r.u) && finite(r.v); }
bool finite(const Emission& e) { return finite(e.radiance); }

template <class... T>
bool all_finite(const T&... values) {
  return (finite(values) && ...);
}

struct LightIsFinite {
  bool operator()(const PointLight& l) const { return all_finite(l.position, l.intensity); }
  bool operator()(const SpotLight& l) const {
    return all_finite(l.position, l.direction, l.intensity, l.cos_inner, l.cos_outer);
  }
  bool operator()(const DirectionalLight& l) const { return all_finite(l.direction, l.irradiance); }
  bool operator()(const TriangleLight& l) const { return all_finite(l.p[0], l.p[1], l.p[2], l.emission); }
  bool operator()(const QuadLight& l) const { return all_finite(l.corner(), l.edge_u(), l.edge_v(), l.emission()); }
  bool operator()(const ShapeLight& l) const { return finite(l.emission); }
  bool operator()(const EnvironmentLight& l) const {
    return finite(l.radiance({0, 1, 0})) && finite(l.radiance({1, 0, 0})) && finite(l.radiance({0, -1, 0}));
  }
};

struct ModelIsFinite {
  bool operator()(const DiffuseMaterial& m) const { return finite(m.reflectance); }
  bool operator()(const DiffuseTransmissionMaterial& m) const { return all_finite(m.reflectance, m.transmittance); }
  bool operator()(const ConductorMaterial& m) const { return all_finite(m.eta, m.k, m.reflectance, m.roughness); }
  bool operator()(const DielectricMaterial& m) const { return all_finite(m.eta, m.abbe_number, m.roughness); }
  bool operator()(const CoatedDiffuseMaterial& m) const { return all_finite(m.reflectance, m.eta, m.roughness); }
  bool operator()(const CoatedConductorMaterial& m) const {
    return all_finite(m.interface_eta, m.interface_roughness) && (*this)(m.conductor);
  }
  bool operator()(const GltfMaterial& m) const {
    return all_finite(m.base_colour, m.metallic, m.roughness, m.ior, m.dispersion, m.specular, m.specular_colour,
                      m.clearcoat, m.clearcoat_roughness) &&
           all_finite(m.sheen_colour, m.sheen_roughness, m.anisotropy, m.anisotropy_rotation, m.iridescence,
                      m.iridescence_ior, m.iridescence_thickness_min, m.iridescence_thickness_max,
                      m.iridescence_thickness, m.transmission);
  }
  bool operator()(const MixMaterial& m) const { return finite(m.amount); }
};

struct ProjectionIsFinite {
  bool operator()(const Perspective& p) const { return plane_is_finite(p); }
  bool operator()(const Orthographic& p) const { return plane_is_finite(p); }
  bool operator()(const Panoramic&) const { return true; }

 private:
  template <class Plane>
  static bool plane_is_finite(const Plane& p) {
    return all_finite(p.half_width, p.half_height, p.centre.x, p.centre.y, p.lens_radius, p.focal_distance);
  }
};

bool finite(const Camera& c) {
  return is_finite(c.to_world.matrix()) && std::visit(ProjectionIsFinite{}, c.projection) &&
         all_finite(c.shutter_open, c.shutter_close);
}

[[noreturn]] void refuse(const std::string& what) { throw Error(what + " has a number that is not finite"); }

}  // namespace

void check_finite(const SceneGraph& graph) {
  for (std::size_t i = 0; i < graph.lights().size(); ++i)
    if (!std::visit(LightIsFinite{}, graph.lights()[i])) refuse("light " + std::to_string(i));
  for (MaterialId id = 0; id < graph.materials.size(); ++id) {
    const Material& m = graph.materials[id];
    if (!std::visit(ModelIsFinite{}, m.model) || !all_finite(m.normal_scale, m.alpha, m.alpha_cutoff, m.absorption))
      refuse("material '" + m.name + "'");
  }
  for (const Camera& c : graph.cameras())
    if (!finite(c)) refuse("camera '" + c.name + "'");
  for (NodeId n = 0; n < graph.node_count(); ++n)
    for (const Surface& s : graph.surfaces(n))
      if (s.emission && !finite(*s.emission)) refuse("the emission of node '" + graph.node_name(n) + "'");
}

}  // namespace lambert
