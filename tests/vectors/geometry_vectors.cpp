#include "vectors.h"

#include "lambert/geometry/ray_tests.h"
#include "lambert/geometry/shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

/// Both ways along the line: all parameters of its hits, as a closed shape's boundary is met.
template <class S>
std::vector<double> all_parameters(const S& shape, Vec3 origin, Vec3 direction) {
  std::vector<double> found;
  Ray ray{origin, direction, -1e3f};
  while (const auto hit = shape.intersect(ray)) {
    found.push_back(static_cast<double>(hit->t));
    ray.t_min = hit->t + 1e-3f;
  }
  return found;
}

// rows: PG-62
const CheckOf plane("V-PG-42", [](const Vector& v) {
  const auto& p = v.input.at("plane");
  const Vec3d p1 = vec3d(v.input.at("P1")), p2 = vec3d(v.input.at("P2"));
  const PlaneMeeting meeting = line_plane(p1, p2, p[0], p[1], p[2], p[3]);
  ASSERT_TRUE(std::holds_alternative<double>(meeting));
  const double t = std::get<double>(meeting);
  v.expect_near(t, v.expected.at("t"));
  v.expect_near(p1 + t * (p2 - p1), v.expected.at("point"));
});

// rows: PG-65
const CheckOf barycentric("V-PG-44", [](const Vector& v) {
  const Vec3d o = vec3d(v.input.at("P0")), d = vec3d(v.input.at("V"));
  const auto& corners = v.input.at("tri");
  const Vec3d a = vec3d(corners[0]), b = vec3d(corners[1]), c = vec3d(corners[2]);
  const auto t = ray_triangle(o, d, a, b, c);
  ASSERT_EQ(t.has_value(), v.expected.at("inside").get<bool>());
  v.expect_near(*t, v.expected.at("t"));
  v.expect_near(o + *t * d, v.expected.at("point"));
  v.expect_near(barycentric_by_areas(o + *t * d, a, b, c), v.expected.at("s"));
  EXPECT_TRUE(inside_by_areas(o + *t * d, a, b, c));
});

// rows: PG-66
const CheckOf area("V-PG-46", [](const Vector& v) {
  const auto& corners = v.input.at("tri");
  const Vec3d a = vec3d(corners[0]), b = vec3d(corners[1]), c = vec3d(corners[2]);
  v.expect_near(triangle_area(a, b, c), v.expected.at("area"));
  // The projection along x alone is half its determinant (E-PG-23).
  const auto flat = [](Vec3d p) { return Vec3d(0, p.y, p.z); };
  v.expect_near(2 * triangle_area(flat(a), flat(b), flat(c)), std::abs(v.expected.at("det_yz").get<double>()));
});

// rows: PG-67
const CheckOf polygon("V-PG-47", [](const Vector& v) {
  std::vector<Vec3> corners;
  for (const auto& corner : v.input.at("polygon")) corners.push_back(vec3(corner));
  const Polygon p(corners);
  ASSERT_EQ(v.expected.at("normal_dominant"), "x");
  EXPECT_NEAR(std::abs(p.normal().x), 1, 1e-6f);
  const Vec3 o = vec3(v.input.at("P0")), d = vec3(v.input.at("V")), also_d = vec3(v.input.at("also_V"));
  const auto hit = p.intersect({o, d});
  ASSERT_EQ(hit.has_value(), v.expected.at("hit").get<bool>());
  v.expect_near(hit->t, v.expected.at("t"));

  EXPECT_EQ(p.intersect({o, also_d}).has_value(), v.expected.at("also_hit").get<bool>());
  const PlaneMeeting also = line_plane(Vec3d(o), Vec3d(o + also_d), Vec3d(corners[0]), Vec3d(p.normal()));
  ASSERT_TRUE(std::holds_alternative<double>(also));
  const double t = std::get<double>(also);
  const Vec3d point = Vec3d(o) + t * Vec3d(also_d);
  v.expect_near(t, v.expected.at("also_t"), Precision::in_float);
  v.expect_near(point, v.expected.at("also_point"), Precision::in_float);
  EXPECT_EQ(inside_projected_polygon(point, corners, 0), v.expected.at("also_hit").get<bool>());
});

// rows: PG-68
const CheckOf convex_polyhedron("V-PG-48", [](const Vector& v) {
  const ConvexPolyhedron cube(
      {{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, 1}, {{0, 0, -1}, 1}});
  const Vec3 d = vec3(v.input.at("V"));
  const auto through = all_parameters(cube, vec3(v.input.at("P0")), d);
  ASSERT_EQ(through.size(), 2u);
  v.expect_near(through[0], v.expected.at("t_enter"), Precision::in_float);
  v.expect_near(through[1], v.expected.at("t_exit"), Precision::in_float);
  EXPECT_EQ(cube.intersect({vec3(v.input.at("P0")), d}).has_value(), v.expected.at("hit").get<bool>());
  EXPECT_EQ(cube.intersect({vec3(v.input.at("miss_P0")), d}).has_value(), v.expected.at("miss_hit").get<bool>());

  const auto inside = all_parameters(cube, vec3(v.input.at("inside_P0")), d);
  ASSERT_EQ(inside.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) v.expect_near(inside[i], v.expected.at("inside_t")[i], Precision::in_float);
});

// rows: PG-69
const CheckOf sphere("V-PG-49", [](const Vector& v) {
  const auto r = v.input.at("r").get<float>();
  const Sphere s{.radius = r, .z_min = -r, .z_max = r};
  const auto& rays = v.input.at("rays");
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vec3 o = vec3(rays[i].at("P0")) - vec3(v.input.at("O")), d = vec3(rays[i].at("V"));
    const auto& expected = v.expected.at("t")[i];
    const auto found = all_parameters(s, o, d);
    ASSERT_EQ(found.size(), expected.size()) << "ray " << i;
    for (std::size_t k = 0; k < found.size(); ++k) v.expect_near(found[k], expected[k], Precision::in_float);

    const auto first = s.intersect({o, d});
    const auto& expected_first = v.expected.at("first_hit")[i];
    ASSERT_EQ(first.has_value(), !expected_first.is_null()) << "ray " << i;
    if (first) v.expect_near(first->t, expected_first);
  }
});

// rows: PG-70
const CheckOf cylinder("V-PG-50", [](const Vector& v) {
  const Cylinder c{.radius = 1, .z_min = 0, .z_max = 4, .caps = true};
  const auto& rays = v.input.at("rays");
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto hit = c.intersect({vec3(rays[i].at("P0")), vec3(rays[i].at("V"))});
    const std::string surface = v.expected.at("surface")[i];
    ASSERT_EQ(hit.has_value(), surface != "miss") << "ray " << i;
    if (!hit) continue;
    v.expect_near(hit->t, v.expected.at("t")[i]);
    EXPECT_EQ(std::abs(hit->normal.z) > 0.5f ? "cap" : "body", surface) << "ray " << i;
  }
});

}  // namespace
}  // namespace lambert
