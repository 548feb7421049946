#include "vectors.h"

#include "lambert/polygon/locate/point_locator.h"
#include "lambert/polygon/predicates/half_plane.h"
#include "lambert/polygon/queries/convex.h"
#include "lambert/polygon/queries/normal.h"
#include "lambert/polygon/queries/pick.h"
#include "lambert/polygon/queries/point_in_polygon.h"
#include "lambert/polygon/queries/segment.h"
#include "lambert/polygon/queries/simple.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambert::polygon {
namespace {

using Json = nlohmann::json;

Vec2d vec2d(const Json& v) { return {v.at(0).get<double>(), v.at(1).get<double>()}; }

Ring ring_of(const Json& list) {
  Ring ring;
  for (const Json& p : list) ring.push_back(vec2d(p));
  return ring;
}

std::vector<Vec3d> face_of(const Json& list) {
  std::vector<Vec3d> face;
  for (const Json& p : list) face.push_back(vec3d(p));
  return face;
}

void expect_near(const Vector& v, Vec2d actual, const Json& value) {
  v.expect_near(actual.x, value.at(0));
  v.expect_near(actual.y, value.at(1));
}

std::pair<Segment, Segment> two_segments(const Json& input) {
  return {{vec2d(input.at("V1")), vec2d(input.at("V2"))}, {vec2d(input.at("W1")), vec2d(input.at("W2"))}};
}

// rows: PG-09
const CheckOf steps("V-PG-01", [](const Vector& v) {
  const auto values = parameter_steps(v.input.at("start").get<double>(), v.input.at("end").get<double>(),
                                      v.input.at("n").get<std::size_t>());
  ASSERT_EQ(values.size(), v.expected.at("values").size());
  for (std::size_t i = 0; i < values.size(); ++i) v.expect_near(values[i], v.expected.at("values")[i]);
});

// rows: PG-10 PG-11
void check_crossing(const Vector& v) {
  const auto [a, b] = two_segments(v.input);
  const auto lines = meet_lines(a, b);
  ASSERT_TRUE(lines);
  v.expect_near(lines->t, v.expected.at("t"));
  v.expect_near(lines->p, v.expected.at("p"));
  const SegmentMeeting m = intersect(a, b);
  EXPECT_EQ(m.meet(), v.expected.at("closed_hit").get<bool>());
  EXPECT_EQ(intersect_half_open(a, b), v.expected.at("half_open_hit").get<bool>());
  v.expect_near(m.t, v.expected.at("t"));
  if (m.meet()) expect_near(v, m.from, v.expected.at("point"));
}
const CheckOf proper("V-PG-02", check_crossing);
const CheckOf outside("V-PG-04", check_crossing);
const CheckOf vertical("V-PG-06", check_crossing);

// rows: PG-12
void check_parallel(const Vector& v) {
  const auto [a, b] = two_segments(v.input);
  EXPECT_EQ(!meet_lines(a, b), v.expected.at("det") == 0);
  const SegmentMeeting m = intersect(a, b);
  EXPECT_EQ(name_of(m.kind), v.expected.at("classification").get<std::string>());
  if (!v.expected.contains("overlap_from")) return;
  expect_near(v, m.from, v.expected.at("overlap_from"));
  expect_near(v, m.to, v.expected.at("overlap_to"));
}
const CheckOf apart("V-PG-07", check_parallel);
const CheckOf overlapped("V-PG-09", check_parallel);

// rows: PG-05 PG-06 PG-07
const CheckOf simple("V-PG-11", [](const Vector& v) {
  using Kind = Simplicity::Kind;
  const std::map<std::string, Kind> kinds{{"square", Kind::simple},
                                          {"repeated_vertex", Kind::vertex_twice},
                                          {"bow_tie", Kind::edges_cross},
                                          {"coincident_edges", Kind::edges_coincide},
                                          {"spike", Kind::spike}};
  for (const auto& [name, list] : v.input.at("polygons").items()) {
    const Ring ring = ring_of(list);
    EXPECT_EQ(check_simple(ring).simple(), v.expected.at("simple").at(name).get<bool>()) << name;
    EXPECT_EQ(check_simple(ring).kind, kinds.at(name)) << name;
    EXPECT_EQ(check_simple_by_pairs(ring).kind, kinds.at(name)) << name;
  }
});

// rows: PG-15
const CheckOf convex("V-PG-12", [](const Vector& v) {
  for (const auto& [name, list] : v.input.at("polygons").items()) {
    const Ring ring = ring_of(list);
    EXPECT_EQ(turns_one_way(ring), v.expected.at("same_turn_sign").at(name).get<bool>()) << name;
    EXPECT_EQ(is_convex(ring), v.expected.at("convex_simple").at(name).get<bool>()) << name;
  }
});

// rows: PG-16
const CheckOf plane_equation("V-PG-13", [](const Vector& v) {
  const auto normal = plane_normal(v.input.at("A"), v.input.at("B"), v.input.at("C"));
  ASSERT_TRUE(normal);
  v.expect_near(*normal, v.expected.at("normal"));
});

// rows: PG-18
void check_newell(const Vector& v) {
  const std::vector<Vec3d> face = face_of(v.input.at("vertices"));
  v.expect_near(newell_sum(face), v.expected.at("sum"));
  v.expect_near(*newell_normal(face), v.expected.at("normal"));
  v.expect_near(0.5 * length(newell_sum(face)), v.expected.at("area"));
}
const CheckOf octant("V-PG-15", check_newell);
const CheckOf hexagon("V-PG-17", check_newell);

// rows: PG-19
const CheckOf planarity("V-PG-18", [](const Vector& v) {
  const std::vector<Vec3d> face = face_of(v.input.at("vertices"));
  const Vec3d normal = *newell_normal(face);
  double signed_max = -1;
  for (std::size_t i = 0; i < face.size(); ++i)
    signed_max = std::max(signed_max, dot(normalize(face[next_index(i, face.size())] - face[i]), normal));
  v.expect_near(signed_max, v.expected.at("signed_max"));  // what the notes compare would pass
  v.expect_near(out_of_plane_sine(face), v.expected.at("absolute_max"));
  EXPECT_EQ(is_planar(face, v.input.at("epsilon")), v.expected.at("planar").get<bool>());
});

// rows: PG-20
const CheckOf quad("V-PG-19", [](const Vector& v) {
  const Ring ring = ring_of(v.input.at("quad"));
  const auto reflex = reflex_vertices(ring);
  ASSERT_EQ(reflex.size(), 1u);
  EXPECT_EQ(reflex[0], v.expected.at("reflex_index").get<std::size_t>());
  const QuadSplit split = split_quad({ring[0], ring[1], ring[2], ring[3]});
  EXPECT_EQ(Json(split.triangles), v.expected.at("triangles"));
});

// rows: PG-41
const CheckOf gravity("V-PG-28", [](const Vector& v) {
  const GravityField field{2, 2};  // as the title says
  for (std::size_t i = 0; i < v.input.at("points").size(); ++i)
    EXPECT_EQ(is_picked(field, {0, 0}, {10, 0}, vec2d(v.input.at("points")[i])), v.expected.at("inside")[i].get<bool>())
        << i;
});

// rows: PG-42
void check_foot(const Vector& v) {
  const auto foot = foot_of_perpendicular(vec2d(v.input.at("A")), vec2d(v.input.at("B")), vec2d(v.input.at("P")));
  ASSERT_TRUE(foot);
  v.expect_near(foot->t, v.expected.at("t"));
  expect_near(v, foot->point, v.expected.at("foot"));
  v.expect_near(foot->distance, v.expected.at("distance_to_line"));
  EXPECT_EQ(foot->on_segment(), v.expected.at("foot_on_segment").get<bool>());
}
const CheckOf foot_inside("V-PG-30", check_foot);
const CheckOf foot_outside("V-PG-31", check_foot);

// rows: PG-43
const CheckOf half_plane("V-PG-32", [](const Vector& v) {
  const std::map<Side, std::string> names{{Side::left, "left"}, {Side::on, "on"}, {Side::right, "right"}};
  const Vec2d tail(0, 0), head(0, 1);
  for (std::size_t i = 0; i < v.input.at("points").size(); ++i) {
    const Vec2d p = vec2d(v.input.at("points")[i]);
    EXPECT_EQ(half_plane_cross(tail, head, p), v.expected.at("cross_z")[i].get<double>());
    EXPECT_EQ(names.at(side_of_line(tail, head, p)), v.expected.at("side")[i].get<std::string>());
  }
});

// rows: PG-44 PG-45 PG-47
const CheckOf point_in_polygon("V-PG-33", [](const Vector& v) {
  Ring ring = ring_of(v.input.at("polygon"));
  ASSERT_EQ(ring.front(), ring.back());
  ring.pop_back();
  const PointLocator locator(Rings{ring});
  for (std::size_t i = 0; i < v.input.at("points").size(); ++i) {
    const Vec2d p = vec2d(v.input.at("points")[i]);
    const bool inside = v.expected.at("inside")[i].get<bool>();
    EXPECT_EQ(shimrat(ring, p), inside);
    EXPECT_EQ(shimrat_with_cull(ring, box_of(ring), p), inside);
    EXPECT_EQ(locate(ring, p), inside ? Place::inside : Place::outside);
    EXPECT_EQ(locator.locate(p), inside ? Place::inside : Place::outside);
  }
});

// rows: PG-46
const CheckOf box("V-PG-34", [](const Vector& v) {
  const Box2 b = box_of(ring_of(v.input.at("vertices")));
  expect_near(v, b.min, v.expected.at("min"));
  expect_near(v, b.max, v.expected.at("max"));
});

}  // namespace
}  // namespace lambert::polygon
