#include "lambert/polygon/decompose/convex_pieces.h"
#include "lambert/polygon/decompose/delaunay.h"
#include "lambert/polygon/decompose/ear_clipping.h"
#include "lambert/polygon/decompose/strips.h"
#include "lambert/polygon/decompose/tiling_test_tools.h"
#include "lambert/polygon/decompose/trapezoids.h"
#include "lambert/polygon/decompose/triangulate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace lambert::polygon {
namespace {

const std::filesystem::path folder = std::filesystem::path(LAMBERT_SHARED_DATA) / "polygons/earcut/test";

/// Their edges cross, so that they must be normalised first.
const std::set<std::string> crossing = {"bad-hole", "issue142",   "simplified-us-border",
                                        "water",    "water-huge", "water-huge2"};
/// A ring on top of the other, or holes outside the outer ring: the even-odd rule sees other areas.
const std::set<std::string> not_a_difference = {"issue107", "infinite-loop-jhl"};

Rings read(const std::filesystem::path& path) {
  Rings rings;
  std::ifstream file(path);
  for (const auto& ring : nlohmann::json::parse(file)) {
    rings.emplace_back();
    for (const auto& p : ring) rings.back().push_back({p[0], p[1]});
  }
  return rings;
}

// The fixtures of mapbox/earcut: triangles cover the outer ring without the holes, to the error earcut allows itself.
TEST(EarcutFixtures, AreCovered) {
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  std::ifstream file(folder / "expected.json");
  const auto expected = nlohmann::json::parse(file);
  int covered = 0;
  for (const auto& [name, count] : expected.at("triangles").items()) {
    SCOPED_TRACE(name);
    const Rings rings = read(folder / "fixtures" / (name + ".json"));
    const FlatRings all = flat(rings);
    double area = 0;
    for (const Ring& ring : rings) area += (&ring == &rings[0] ? 1 : -1) * std::abs(test::total_area({ring}));

    const auto covered_area = [&](const std::vector<Triangle>& triangles) {
      const auto corners = test::corners_of(triangles, all.vertices);
      for (const Ring& t : corners) EXPECT_GT(orientation(t[0], t[1], t[2]), 0);
      return test::total_area(corners);
    };
    const auto triangles = triangulate(all);
    const double fast = covered_area(triangles), best = covered_area(delaunay(all));
    EXPECT_LE(cover_with_strips(triangles).vertex_count(), 3 * triangles.size());
    EXPECT_EQ(clip_ears(rings[0]).size(), std::max<std::size_t>(rings[0].size(), 2) - 2);
    Rings pieces;
    trapezoids(all, [&](const Trapezoid& t) {
      pieces.emplace_back(t.corners.begin(), t.corners.begin() + static_cast<std::ptrdiff_t>(t.size));
    });
    if (crossing.count(name) || not_a_difference.count(name)) continue;
    ++covered;
    const double tolerance = std::max(1e-12, expected.at("errors").value(name, 0.0)) * area;
    EXPECT_NEAR(fast, area, tolerance);
    EXPECT_NEAR(best, area, tolerance);
    EXPECT_NEAR(test::total_area(pieces), area, tolerance);
  }
  EXPECT_GE(covered, 50);
}

}  // namespace
}  // namespace lambert::polygon
