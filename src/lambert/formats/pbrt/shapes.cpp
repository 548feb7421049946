#include "lambert/formats/pbrt/shapes.h"

#include "lambert/formats/pbrt/mesh_shapes.h"

#include <algorithm>
#include <cmath>

namespace lambert::pbrt {
namespace {

float positive(const ParameterList& list, const char* name, float fallback) {
  const float value = list.number(name, fallback);
  if (!(value > 0)) list.fail(std::string("'") + name + "' must be above 0");
  return value;
}

/// "phimax", in degrees in the file.
float phi_max(const ParameterList& list) {
  const float phi = list.number("phimax", 360);
  if (!(phi > 0 && phi <= 360)) list.fail("'phimax' must lie in (0, 360] degrees");
  return degrees(phi).radians();
}

Sphere sphere(const ParameterList& list) {
  Sphere s;
  s.radius = positive(list, "radius", 1);
  const float z0 = list.number("zmin", -s.radius), z1 = list.number("zmax", s.radius);
  s.z_min = std::clamp(std::min(z0, z1), -s.radius, s.radius),
  s.z_max = std::clamp(std::max(z0, z1), -s.radius, s.radius);
  s.phi_max = phi_max(list);
  if (!(s.z_min < s.z_max)) list.fail("'zmin' and 'zmax' leave nothing of the sphere");
  return s;
}

Disk disk(const ParameterList& list) {
  Disk d;
  d.height = list.number("height", 0), d.radius = positive(list, "radius", 1);
  d.inner_radius = list.number("innerradius", 0);
  d.phi_max = phi_max(list);
  if (!(d.inner_radius >= 0 && d.inner_radius < d.radius)) list.fail("'innerradius' must lie in [0, radius)");
  return d;
}

Cylinder cylinder(const ParameterList& list) {
  Cylinder c;
  c.radius = positive(list, "radius", 1);
  const float z0 = list.number("zmin", -1), z1 = list.number("zmax", 1);
  c.z_min = std::min(z0, z1), c.z_max = std::max(z0, z1);
  c.phi_max = phi_max(list);
  c.caps = list.boolean("caps", false);
  if (!(c.z_min < c.z_max)) list.fail("'zmin' and 'zmax' leave nothing of the cylinder");
  return c;
}

Polygon polygon(const ParameterList& list) {
  return at_directive(list, [&] { return Polygon(list.vectors3("P", ParameterType::point3)); });
}

ConvexPolyhedron convex_polyhedron(const ParameterList& list) {
  const std::vector<float> numbers = list.numbers("planes");
  if (numbers.empty() || numbers.size() % 4 != 0) {
    list.fail("takes \"float planes\" with 4 numbers for each face: the outward normal and its offset");
  }
  std::vector<ConvexPolyhedron::Plane> planes(numbers.size() / 4);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Vec3 normal(numbers[4 * i], numbers[4 * i + 1], numbers[4 * i + 2]);
    const float norm = length(normal);
    if (!(norm > 0)) list.fail("the normal of plane " + std::to_string(i) + " is zero");
    planes[i] = {normal / norm, numbers[4 * i + 3] / norm};
  }
  return at_directive(list, [&] { return ConvexPolyhedron(std::move(planes)); });
}

std::optional<Shape> analytic_shape(const ParameterList& list, const std::string& type) {
  if (type == "sphere") return sphere(list);
  if (type == "disk") return disk(list);
  if (type == "cylinder") return cylinder(list);
  if (type == "polygon") return polygon(list);
  if (type == "convexpolyhedron") return convex_polyhedron(list);
  return std::nullopt;
}

}  // namespace

std::vector<std::string> shape_types() {
  return {"sphere",       "disk",       "cylinder", "trianglemesh",    "plymesh",
          "bilinearmesh", "loopsubdiv", "polygon",  "convexpolyhedron"};
}

GeometryId add_geometry(Context& context, const ParameterList& list, const std::string& type) {
  if (type == "plymesh") return add_ply_mesh(context, list);
  std::optional<Geometry> geometry;
  if (auto shape = analytic_shape(list, type)) {
    geometry = std::move(*shape);
  } else if (type == "trianglemesh") {
    geometry = triangle_mesh(list);
  } else if (type == "bilinearmesh") {
    geometry = bilinear_mesh(context, list);
  } else if (type == "loopsubdiv") {
    geometry = loop_subdivision_cage(context, list);
  } else {
    fail_unknown_type(list, "shape", type, shape_types());
  }
  return at_directive(list, [&] { return context.graph.add_geometry(std::move(*geometry)); });
}

float world_area(const Geometry& geometry, const Transform& to_world) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    float area = 0;
    for (const Triangle& t : mesh->triangles) {
      const Vec3 a = mesh->positions[t[0]], b = mesh->positions[t[1]], c = mesh->positions[t[2]];
      area += 0.5f * length(cross(to_world.vector(b - a), to_world.vector(c - a)));
    }
    return area;
  }
  const float volume = std::abs(glm::determinant(Mat3(to_world.matrix())));
  const float area = std::visit([](const auto& s) { return s.area(); }, std::get<Shape>(geometry));
  return area * std::cbrt(volume * volume);
}

}  // namespace lambert::pbrt
