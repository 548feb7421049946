#include "vectors.h"

#include "lambert/polygon/decompose/strips.h"
#include "lambert/polygon/decompose/trapezoids.h"
#include "lambert/polygon/predicates/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace lambert {
namespace {

using namespace polygon;

Ring ring(const nlohmann::json& points) {
  Ring read;
  for (const auto& p : points) read.emplace_back(p[0].get<double>(), p[1].get<double>());
  return read;
}

Ring corners(const Trapezoid& t) {
  return Ring(t.corners.begin(), t.corners.begin() + static_cast<std::ptrdiff_t>(t.size));
}

/// The same corners in the same cyclic order, to the tolerance of the file.
bool same(const Vector& v, const Ring& a, Ring b) {
  for (std::size_t turn = 0; turn < b.size(); ++turn) {
    if (std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](Vec2d p, Vec2d q) {
          return std::abs(p.x - q.x) <= v.absolute && std::abs(p.y - q.y) <= v.absolute;
        }))
      return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

Trapezoids expect_totals(const Vector& v) {
  const Region region{ring(v.input.at("polygon")), {}};
  Trapezoids found = trapezoids(region);
  EXPECT_EQ(found.pieces.size(), v.expected.at("pieces").get<std::size_t>());
  v.expect_near(area(region), v.expected.at("area"));
  double sum = 0;
  for (const Trapezoid& t : found.pieces) {
    const auto& sizes = v.expected.at("piece_sizes_allowed");
    EXPECT_NE(std::find(sizes.begin(), sizes.end(), t.size), sizes.end());
    const Ring c = corners(t);
    for (std::size_t i = 0; i < c.size(); ++i) {
      EXPECT_EQ(orientation(c[i], c[(i + 1) % c.size()], c[(i + 2) % c.size()]) > 0,
                v.expected.at("all_ccw").get<bool>());
    }
    sum += signed_area(c);
  }
  v.expect_near(sum, v.expected.at("sum_of_piece_areas"));
  return found;
}

// rows: PG-25 PG-26 PG-27 PG-28 PG-29 PG-30
const CheckOf notched_pentagon("V-PG-20", [](const Vector& v) {
  const Trapezoids found = expect_totals(v);
  for (const auto& expected : v.expected.at("pieces_vertices")) {
    const Ring piece = ring(expected);
    const auto matches = std::count_if(found.pieces.begin(), found.pieces.end(),
                                       [&](const Trapezoid& t) { return same(v, piece, corners(t)); });
    EXPECT_EQ(matches, 1) << expected;
  }
});

// rows: PG-25 PG-31 PG-32
const CheckOf two_notches("V-PG-21", [](const Vector& v) {
  const Trapezoids found = expect_totals(v);
  // Case 1 shows at the left side between vertices.
  const std::set<SweepCase> cases(found.cases.begin(), found.cases.end());
  for (const SweepCase c : {SweepCase::right_edge, SweepCase::interior_minimum, SweepCase::exterior_minimum,
                            SweepCase::interior_maximum, SweepCase::exterior_maximum})
    EXPECT_TRUE(cases.count(c)) << static_cast<int>(c);
});

// rows: PG-36
const CheckOf strip_and_fan("V-PG-24", [](const Vector& v) {
  const auto indices = v.input.at("indices").get<Indices>();
  const auto in_strip = v.expected.at("strip").get<std::vector<Triangle>>();
  const auto in_fan = v.expected.at("fan").get<std::vector<Triangle>>();
  EXPECT_EQ(triangles_of_strip(indices), in_strip);
  EXPECT_EQ(triangles_of_fan(indices), in_fan);
  EXPECT_EQ(strip_of(in_strip), indices);
  EXPECT_EQ(fan_of(in_fan), indices);
  const auto& count = v.expected.at("vertex_count");
  EXPECT_EQ(list_of(in_strip).size(), count.at("separate_12").get<std::size_t>());
  EXPECT_EQ(indices.size(), count.at("strip_or_fan").get<std::size_t>());
});

// rows: PG-36 PG-37
const CheckOf counts("V-PG-25", [](const Vector& v) {
  const auto expected = [&](const char* what, std::size_t i) { return v.expected.at(what)[i].get<std::size_t>(); };
  const auto numbers = [](std::size_t count) {
    Indices all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  };
  for (std::size_t i = 0; i < v.input.at("n").size(); ++i) {
    const std::size_t n = v.input.at("n")[i];
    const auto triangles = triangles_of_strip(numbers(expected("strip", i)));
    EXPECT_EQ(triangles.size(), n);
    EXPECT_EQ(list_of(triangles).size(), expected("separate_triangles", i));
    EXPECT_EQ(cover_with_strips(triangles).vertex_count(), expected("strip", i));
    const auto quads = quads_of_strip(numbers(expected("quad_strip", i)));
    EXPECT_EQ(quads.size(), n);
    EXPECT_EQ(list_of(quads).size(), expected("separate_quads", i));
    EXPECT_EQ(strip_of(quads).value().size(), expected("quad_strip", i));
  }
});

}  // namespace
}  // namespace lambert
