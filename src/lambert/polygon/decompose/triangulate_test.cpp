#include "lambert/polygon/decompose/triangulate.h"

#include "lambert/polygon/decompose/delaunay.h"
#include "lambert/polygon/decompose/ear_clipping.h"
#include "lambert/polygon/decompose/tiling_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace lambert::polygon {
namespace {

std::size_t expected_count(const Region& region) { return flat(region).vertices.size() - 2 + 2 * region.holes.size(); }

std::vector<Ring> pieces(const Rings& rings) { return test::corners_of(triangulate(rings), flat(rings).vertices); }

// rows: PG-14
TEST(Triangulate, TrianglesTileTheRegion) {
  test::Random random(1);
  test::for_each_valid_region(2, 60, [&](const Region& region) {
    const FlatRings rings = flat(region);
    const auto triangles = triangulate(rings);
    ASSERT_EQ(triangles.size(), expected_count(region));
    test::expect_tiled(rings_of(region), test::corners_of(triangles, rings.vertices), random);
  });
}

TEST(Triangulate, LargeRegionsAreTiled) {
  test::Random random(3);
  for (const Region& region : {Region{test::star(random, 100000), {}}, Region{test::comb(50000), {}},
                               Region{test::spiral(50000), {}}, test::star_with_holes(random, 20000, 50, 20)}) {
    const FlatRings rings = flat(region);
    for (const auto& triangles : {triangulate(rings), delaunay(rings)}) {
      EXPECT_EQ(triangles.size(), expected_count(region));
      test::expect_tiled(rings_of(region), test::corners_of(triangles, rings.vertices), random, 0);
    }
  }
}

// The rings do not say which is the outer one, nor where they begin.
TEST(Triangulate, OrderOrientationAndFirstVertexDoNotMatter) {
  test::Random random(4);
  test::for_each_valid_region(5, 20, [&](const Region& region) {
    Rings rings = rings_of(region);
    for (int i = 0; i < 4; ++i) {
      std::shuffle(rings.begin(), rings.end(), random);
      for (Ring& ring : rings) {
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(test::below(random, ring.size())),
                    ring.end());
        if (random() % 2) std::reverse(ring.begin(), ring.end());
      }
      ASSERT_EQ(triangulate(rings).size(), expected_count(region));
      ASSERT_EQ(delaunay(rings).size(), expected_count(region));
      test::expect_tiled(rings_of(region), pieces(rings), random, 10);
    }
  });
}

TEST(Triangulate, AQuarterTurnKeepsTheCount) {
  test::for_each_valid_region(6, 20, [&](const Region& region) {
    Region turned = region;
    const auto turn = [](Ring& ring) {
      for (Vec2d& p : ring) p = {-p.y, p.x};
    };
    turn(turned.outer);
    for (Ring& hole : turned.holes) turn(hole);
    ASSERT_EQ(triangulate(turned).size(), expected_count(region));
  });
}

TEST(Triangulate, ScaleDoesNotMatter) {
  test::for_each_valid_region(7, 10, [&](const Region& region) {
    const auto triangles = triangulate(region), best = delaunay(region);
    for (const double scale : {0x1p-900, 0x1p-200, 0x1p150, 0x1p1000}) {
      Region scaled = region;
      for (Vec2d& p : scaled.outer) p *= scale;
      for (Ring& hole : scaled.holes)
        for (Vec2d& p : hole) p *= scale;
      ASSERT_EQ(triangulate(scaled), triangles);
      ASSERT_EQ(delaunay(scaled), best);
    }
  });
}

Rings rectangle(Vec2d low, Vec2d high) { return {{low, {high.x, low.y}, high, {low.x, high.y}}}; }

TEST(Triangulate, IslandsInHolesAreInside) {
  Rings rings;
  for (int i = 0; i < 9; ++i) {
    const Vec2d corner(static_cast<double>(9 - i));
    rings.push_back(rectangle(-corner, corner)[0]);
  }
  test::Random random(8);
  // Clockwise wherever the exterior is inside.
  Rings oriented = rings;
  for (std::size_t i = 1; i < oriented.size(); i += 2) std::reverse(oriented[i].begin(), oriented[i].end());
  test::expect_tiled(oriented, pieces(rings), random, 500);
}

TEST(Triangulate, RingsMayTouch) {
  test::Random random(9);
  const Rings touching[] = {
      // holes that touch the outer ring in a vertex, an edge, and each other
      {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{0, 0}, {1, 4}, {4, 1}}},
      {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{4, 0}, {3, 2}, {5, 2}}},
      {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{8, 4}, {6, 3}, {6, 5}}, {{6, 3}, {4, 3}, {6, 1}}},
      {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}},
      // an outer ring that touches itself in a vertex, from inside and from outside, and in an edge
      {{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {6, 4}, {2, 4}, {4, 8}, {0, 8}}},
      {{{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}},
      {{{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}},
      // a bridge to a hole
      {{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}},
      // repeated vertices, a spike outwards and one inwards
      {{{0, 0}, {0, 0}, {8, 0}, {8, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 8}}},
      {{{0, 0}, {8, 0}, {12, 0}, {8, 0}, {8, 8}, {8, 12}, {8, 8}, {0, 8}}},
      {{{0, 0}, {8, 0}, {8, 4}, {4, 4}, {8, 4}, {8, 8}, {0, 8}}},
  };
  for (const Rings& rings : touching) {
    double area = 0;
    for (const Ring& ring : rings) area += (&ring == &rings[0] ? 1 : -1) * std::abs(signed_area(ring));
    for (int turn = 0; turn < 8; ++turn) {
      Rings turned = rings;
      for (Ring& ring : turned)
        for (Vec2d& p : ring) {
          for (int i = 0; i < turn % 4; ++i) p = {-p.y, p.x};
          if (turn >= 4) p = {p.x + 0.5 * p.y, p.y};
        }
      for (const auto& triangles : {triangulate(turned), delaunay(turned)}) {
        Rings oriented = turned;
        for (Ring& ring : oriented)
          if ((signed_area(ring) > 0) != (&ring == &oriented[0])) std::reverse(ring.begin(), ring.end());
        ASSERT_NEAR(test::total_area(oriented), area, 1e-12 * area);
        test::expect_tiled(oriented, test::corners_of(triangles, flat(turned).vertices), random, 200);
      }
    }
  }
}

// Any rings on a small grid whose edges meet in nothing but vertices of both: crossings there, edges on each other,
// repeated vertices. The even-odd rule at random points is the oracle.
TEST(Triangulate, RingsThatMeetInVerticesAreTiled) {
  test::Random random(18);
  int tried = 0;
  for (int i = 0; i < 20000; ++i) {
    Rings rings(1 + test::below(random, 2));
    for (Ring& ring : rings)
      for (std::size_t k = 3 + test::below(random, 6); k > 0; --k)
        ring.emplace_back(static_cast<double>(test::below(random, 4)), static_cast<double>(test::below(random, 4)));
    std::vector<std::pair<Vec2d, Vec2d>> edges;
    for (const Ring& ring : rings)
      for (std::size_t k = 0; k < ring.size(); ++k) edges.emplace_back(ring[k], ring[next_index(k, ring.size())]);
    const auto meets_another = [&](const auto& e) {
      return std::any_of(edges.begin(), edges.end(),
                         [&](const auto& f) { return test::segments_meet(e.first, e.second, f.first, f.second); });
    };
    if (std::any_of(edges.begin(), edges.end(), meets_another)) continue;
    ++tried;
    const FlatRings all = flat(rings);
    for (const auto& triangles : {triangulate(all), delaunay(all)}) {
      const auto corners = test::corners_of(triangles, all.vertices);
      for (int k = 0; k < 10; ++k) {
        const Vec2d p(test::between(random, 0, 3), test::between(random, 0, 3));
        int covering = 0, on_a_side = 0;
        for (const Ring& t : corners) {
          covering += test::locate({t}, p) > 0;
          on_a_side += test::locate({t}, p) == 0;
        }
        if (on_a_side == 0) {
          ASSERT_EQ(covering, test::locate(rings, p) > 0 ? 1 : 0);
        }
      }
    }
  }
  EXPECT_GT(tried, 3000);
}

TEST(Triangulate, EdgesThatCrossInAVertexAreTiled) {
  const Rings bow_tie = {{{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}}};
  EXPECT_EQ(test::total_area(pieces(bow_tie)), 8);
  const Rings star = {{{0, 3}, {3, 3}, {6, 3}, {3, 3}, {3, 6}, {3, 3}, {3, 0}, {3, 3}}};
  EXPECT_EQ(test::total_area(pieces(star)), 0);
}

TEST(Triangulate, TrianglesMeetEdgeToEdge) {
  test::for_each_valid_region(10, 20, [&](const Region& region) {
    const FlatRings rings = flat(region);
    const auto next = successors(rings);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Triangle& t : triangulate(rings))
      for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
    for (const auto& [side, count] : sides) {
      ASSERT_EQ(count, 1);
      const bool boundary = next[side.first] == side.second;
      ASSERT_EQ(sides.count({side.second, side.first}), boundary ? 0u : 1u);
    }
  });
}

// Every side but the boundary's: the corner beyond it is not inside the circle.
TEST(Delaunay, EverySideIsLocallyDelaunay) {
  test::Random random(11);
  test::for_each_valid_region(12, 60, [&](const Region& region) {
    const FlatRings rings = flat(region);
    const auto triangles = delaunay(rings);
    ASSERT_EQ(triangles.size(), expected_count(region));
    test::expect_tiled(rings_of(region), test::corners_of(triangles, rings.vertices), random, 10);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> corner_of;
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) corner_of[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
    const auto& p = rings.vertices;
    for (const auto& [side, corner] : corner_of) {
      const auto twin = corner_of.find({side.second, side.first});
      if (twin == corner_of.end()) continue;
      ASSERT_LE(in_circle(p[side.first], p[side.second], p[corner], p[twin->second]), 0);
    }
  });
}

// The definition itself, by brute force: what a circle has inside is hidden behind an edge.
TEST(Delaunay, CirclesHoldNoVertexThatCanBeSeen) {
  test::Random random(13);
  for (int i = 0; i < 40; ++i) {
    const Region region = test::star_with_holes(random, 5 + test::below(random, 10), 1, 4);
    const FlatRings rings = flat(region);
    const auto& p = rings.vertices;
    const auto next = successors(rings);
    for (const Triangle& t : delaunay(rings))
      for (std::uint32_t v = 0; v < p.size(); ++v) {
        if (in_circle(p[t[0]], p[t[1]], p[t[2]], p[v]) <= 0) continue;
        const Vec2d centre = (p[t[0]] + p[t[1]] + p[t[2]]) / 3.0;
        bool hidden = false;
        for (std::uint32_t e = 0; e < p.size(); ++e)
          hidden = hidden || (e != v && next[e] != v && test::segments_meet(centre, p[v], p[e], p[next[e]]));
        // Seen along its own edges, from outside their wedge, it is behind one of them all the same.
        const std::uint32_t before = static_cast<std::uint32_t>(std::find(next.begin(), next.end(), v) - next.begin());
        const Vec2d almost = p[v] + 1e-9 * (centre - p[v]);
        hidden = hidden || test::locate(rings_of(region), almost) < 0 || before == v;
        ASSERT_TRUE(hidden);
      }
  }
}

TEST(Delaunay, WidensTheSmallestAngle) {
  test::Random random(14);
  const auto smallest = [](const std::vector<Ring>& triangles) {
    double least = 4;
    for (const Ring& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec2d u = t[(i + 1) % 3] - t[i], v = t[(i + 2) % 3] - t[i];
        least = std::min(least, std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v)));
      }
    return least;
  };
  for (int i = 0; i < 100; ++i) {
    const FlatRings rings = flat(Region{test::star(random, 60, 0.8), {}});
    ASSERT_GE(smallest(test::corners_of(delaunay(rings), rings.vertices)) * (1 + 1e-9),
              smallest(test::corners_of(triangulate(rings), rings.vertices)));
  }
}

TEST(Triangulate, NothingComesOfNoArea) {
  const double huge = std::numeric_limits<double>::max();
  for (const Rings& rings : std::initializer_list<Rings>{{},
                                                         {{}},
                                                         {{}, {}},
                                                         {{{1, 2}}},
                                                         {{{1, 2}, {3, 4}}},
                                                         {{{1, 2}, {1, 2}, {1, 2}}},
                                                         {{{0, 0}, {1, 1}, {2, 2}}},
                                                         {{{0, 0}, {4, 0}, {2, 0}, {3, 0}}},
                                                         {{{0, 0}, {0, 5}, {0, 0}, {5, 0}}}}) {
    EXPECT_TRUE(triangulate(rings).empty());
    EXPECT_TRUE(delaunay(rings).empty());
  }
  triangulate(Rings{{{-huge, -huge}, {huge, -huge}, {huge, huge}}});  // ends
}

// What crosses itself has no promise but an end, and triangles that turn left.
TEST(Triangulate, AnythingEnds) {
  test::Random random(15);
  for (int i = 0; i < 20000; ++i) {
    Rings rings(1 + test::below(random, 3));
    const std::size_t grid = 2 + test::below(random, 6);
    const double scale = std::exp2(static_cast<double>(test::below(random, 2000)) - 1000);
    for (Ring& ring : rings)
      for (std::size_t k = test::below(random, 12); k > 0; --k)
        ring.push_back(scale * Vec2d(static_cast<double>(test::below(random, grid)),
                                     static_cast<double>(test::below(random, grid))));
    const FlatRings all = flat(rings);
    for (const auto& triangles : {triangulate(all), delaunay(all)}) {
      ASSERT_LE(triangles.size(), 3 * all.vertices.size());
      for (const Triangle& t : triangles)
        ASSERT_GT(orientation(all.vertices[t[0]] / scale, all.vertices[t[1]] / scale, all.vertices[t[2]] / scale), 0);
    }
  }
}

TEST(ClipEars, TrianglesTileWhatIsSimple) {
  test::Random random(16);
  test::for_each_valid_region(17, 30, [&](const Region& region) {
    if (!region.holes.empty()) return;
    const auto triangles = clip_ears(region.outer);
    ASSERT_EQ(triangles.size(), region.outer.size() - 2);
    // A collinear run may leave flat ears.
    std::vector<Ring> with_area;
    for (const Triangle& t : triangles)
      if (Ring corners = test::corners_of(t, region.outer); orientation(corners[0], corners[1], corners[2]) != 0)
        with_area.push_back(std::move(corners));
    test::expect_tiled({region.outer}, with_area, random, 20);
  });
  EXPECT_TRUE(clip_ears({}).empty());
}

}  // namespace
}  // namespace lambert::polygon
