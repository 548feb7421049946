#include "lambert/polygon/boolean/boolean.h"
#include "lambert/polygon/boolean/valid.h"
#include "lambert/polygon/predicates/predicates.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace lambert::polygon {
namespace {

/// Before RapidCheck reads it: the same cases every time.
const bool seeded = setenv("RC_PARAMS", "seed=20 max_success=400", 0) == 0;

Ring square(double x, double y, double size) { return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}; }

Ring reversed(Ring ring) { return {ring.rbegin(), ring.rend()}; }

std::string defect(const Regions& regions) {
  const auto invalid = check_valid(regions);
  return invalid ? invalid->message() : "";
}

// rows: PG-02
TEST(Boolean, OverlappingSquares) {
  const Rings a{square(0, 0, 2)}, b{square(1, 1, 2)};
  EXPECT_EQ(intersect(a, b), (Regions{{square(1, 1, 1), {}}}));
  EXPECT_EQ(unite(a, b), (Regions{{{{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}, {0, 2}}, {}}}));
  EXPECT_EQ(subtract(a, b), (Regions{{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}}}));
  // Two pieces that touch in two points, and no ring through a point twice.
  EXPECT_EQ(exclude(a, b), (Regions{{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}},
                                    {{{1, 2}, {2, 2}, {2, 1}, {3, 1}, {3, 3}, {1, 3}}, {}}}));
}

TEST(Boolean, TouchingAtAVertexStaysTwoRegions) {
  EXPECT_EQ(unite({square(0, 0, 1)}, {square(1, 1, 1)}), (Regions{{square(0, 0, 1), {}}, {square(1, 1, 1), {}}}));
  EXPECT_EQ(intersect({square(0, 0, 1)}, {square(1, 1, 1)}), Regions{});
}

TEST(Boolean, SharedEdgesVanish) {
  EXPECT_EQ(unite({square(0, 0, 1)}, {square(1, 0, 1)}), (Regions{{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {}}}));
  EXPECT_EQ(intersect({square(0, 0, 1)}, {square(1, 0, 1)}), Regions{});
  // Of different lengths.
  EXPECT_EQ(unite({square(0, 0, 3)}, {square(3, 1, 1)}),
            (Regions{{{{0, 0}, {3, 0}, {3, 1}, {4, 1}, {4, 2}, {3, 2}, {3, 3}, {0, 3}}, {}}}));
}

TEST(Boolean, IdenticalOperands) {
  const Rings a{square(0, 0, 1)}, turned{reversed({{1, 1}, {0, 1}, {0, 0}, {1, 0}})};
  EXPECT_EQ(unite(a, turned), (Regions{{a.front(), {}}}));
  EXPECT_EQ(intersect(a, turned), (Regions{{a.front(), {}}}));
  EXPECT_EQ(subtract(a, turned), Regions{});
  EXPECT_EQ(exclude(a, turned), Regions{});
}

TEST(Boolean, HolesAndIslands) {
  const Regions ring{{square(0, 0, 6), {reversed({{2, 1}, {5, 1}, {5, 4}, {2, 4}})}}};
  const Ring hole{{2, 1}, {2, 4}, {5, 4}, {5, 1}};
  EXPECT_EQ(subtract({square(0, 0, 6)}, {square(2, 1, 3)}), (Regions{{square(0, 0, 6), {hole}}}));
  // An island in the hole is a region of its own.
  EXPECT_EQ(unite(rings_of(ring), {square(3, 2, 1)}), (Regions{{square(0, 0, 6), {hole}}, {square(3, 2, 1), {}}}));
  EXPECT_EQ(normalised({square(0, 0, 6), square(1, 1, 4), square(2, 2, 2)}),
            (Regions{{square(0, 0, 6), {{{1, 1}, {1, 5}, {5, 5}, {5, 1}}}}, {square(2, 2, 2), {}}}));
}

TEST(Boolean, HoleThatTouchesTheOuterRingIsItsOwnRing) {
  const Ring triangle{{0, 2}, {2, 1}, {2, 3}};
  EXPECT_EQ(subtract({square(0, 0, 4)}, {triangle}), (Regions{{square(0, 0, 4), {{{0, 2}, {2, 3}, {2, 1}}}}}));
  // Twice: the region falls into two.
  const Ring strip{{0, 2}, {2, 1}, {4, 2}, {2, 3}};
  EXPECT_EQ(subtract({square(0, 0, 4)}, {strip}),
            (Regions{{{{0, 0}, {4, 0}, {4, 2}, {2, 1}, {0, 2}}, {}}, {{{0, 2}, {2, 3}, {4, 2}, {4, 4}, {0, 4}}, {}}}));
}

TEST(Boolean, HolesThatTouchEachOtherStaySeparate) {
  const Rings holes{{{1, 1}, {2, 1}, {2, 2}}, {{2, 2}, {3, 2}, {3, 3}}};
  const Regions result = subtract({square(0, 0, 4)}, holes);
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(result[0].holes, (Rings{{{1, 1}, {2, 2}, {2, 1}}, {{2, 2}, {3, 3}, {3, 2}}}));
  EXPECT_EQ(defect(result), "");
}

TEST(Boolean, BowTie) {
  const Rings bow{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}};
  const Regions both{{{{0, 0}, {1, 1}, {0, 2}}, {}}, {{{1, 1}, {2, 0}, {2, 2}}, {}}};
  EXPECT_EQ(normalised(bow), both);
  EXPECT_EQ(normalised(bow, FillRule::non_zero), both);
  EXPECT_EQ(normalised(bow, FillRule::positive), (Regions{both[0]}));
  EXPECT_EQ(normalised(bow, FillRule::negative), (Regions{both[1]}));
}

TEST(Boolean, FillRulesOfAPentagram) {
  const Rings star{{{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}}};
  const Regions odd = normalised(star), any = normalised(star, FillRule::non_zero);
  EXPECT_EQ(odd.size(), 5U);
  ASSERT_EQ(any.size(), 1U);
  EXPECT_EQ(any[0].outer.size(), 10U);
  EXPECT_EQ(normalised(star, FillRule::positive), any);
  EXPECT_EQ(normalised(star, FillRule::negative), Regions{});
}

TEST(Boolean, StraightVerticesAndSpikesVanish) {
  EXPECT_EQ(normalised({{{0, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 1}}}),
            (Regions{{square(0, 0, 2), {}}}));
  EXPECT_EQ(normalised({{{0, 0}, {2, 0}, {5, 0}, {2, 0}, {2, 2}, {0, 2}}}), (Regions{{square(0, 0, 2), {}}}));
}

TEST(Boolean, DegenerateRingsEncloseNothing) {
  EXPECT_EQ(normalised({{}, {{1, 1}}, {{0, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 0}}, {{0, 0}, {1, 1}, {3, 3}}}),
            Regions{});
  EXPECT_EQ(unite({}, {}), Regions{});
  EXPECT_EQ(subtract({square(0, 0, 1)}, {}), (Regions{{square(0, 0, 1), {}}}));
}

TEST(Boolean, RefusesWhatIsNotFinite) {
  EXPECT_THROW(normalised({{{0, 0}, {1, 0}, {0, std::numeric_limits<double>::quiet_NaN()}}}), std::invalid_argument);
  EXPECT_THROW(unite({}, {{{0, 0}, {std::numeric_limits<double>::infinity(), 0}, {0, 1}}}), std::invalid_argument);
}

TEST(Boolean, ExtremeScalesKeepTheirShape) {
  for (const double scale : {0x1p-1060, 0x1p-500, 0x1p-200, 0x1p300, 0x1p1000}) {
    const Rings a{{{0, 0}, {scale * 2, 0}, {0, scale * 2}}}, b{{{0, scale}, {scale * 2, scale}, {scale, scale * 4}}};
    const Regions result = intersect(a, b);
    ASSERT_EQ(result.size(), 1U) << scale;
    EXPECT_EQ(defect(result), "") << scale;
  }
  // Side by side.
  const Regions mixed = unite({square(0, 0, 1e120), square(-1, -1, 1)}, {square(-1.5, -1.5, 0.5)});
  EXPECT_EQ(mixed.size(), 3U);
  EXPECT_EQ(defect(mixed), "");
}

TEST(Boolean, SharedLongBoundariesOfOppositeRoundings) {
  // Rotated by a third of a radian no edge is shared exactly, so that all nearly overlap.
  const double c = std::cos(1.0 / 3), s = std::sin(1.0 / 3);
  Rings columns;
  for (int i = 0; i < 30; ++i) {
    Ring ring = square(i, 0, 1);
    for (Vec2d& p : ring) p = Vec2d(c * p.x - s * p.y, s * p.x + c * p.y);
    columns.push_back(ring);
  }
  const Regions result = normalised(columns, FillRule::non_zero);
  EXPECT_EQ(defect(result), "");
  EXPECT_NEAR(area(result), 30, 1e-12);
}

TEST(CheckValid, FindsEachDefect) {
  const auto found = [](const Regions& regions) { return check_valid(regions).value().defect; };
  EXPECT_EQ(found({{{{0, 0}, {1, 0}}, {}}}), Defect::too_few_points);
  EXPECT_EQ(found({{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {}}}), Defect::too_few_points);
  EXPECT_EQ(found({{{{0, 0}, {1, 0}, {0, std::nan("")}}, {}}}), Defect::not_finite);
  EXPECT_EQ(found({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}), Defect::ring_meets_itself);
  EXPECT_EQ(found({{{{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 3}}, {}}}), Defect::ring_meets_itself);
  EXPECT_EQ(found({{{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}, {}}}), Defect::ring_meets_itself);
  EXPECT_EQ(found({{square(0, 0, 2), {}}, {square(1, 1, 2), {}}}), Defect::rings_cross);
  // Through each other in vertices only.
  EXPECT_EQ(found({{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}}, {{{1, 1}, {2, 0}, {4, 1}, {2, 2}}, {}}}),
            Defect::rings_cross);
  EXPECT_EQ(found({{square(0, 0, 2), {}}, {square(2, 1, 2), {}}}), Defect::edges_overlap);
  EXPECT_EQ(found({{reversed(square(0, 0, 2)), {}}}), Defect::orientation);
  EXPECT_EQ(found({{square(0, 0, 4), {square(1, 1, 1)}}}), Defect::orientation);
  EXPECT_EQ(found({{square(0, 0, 4), {reversed(square(5, 1, 1))}}}), Defect::nesting);
  EXPECT_EQ(found({{square(0, 0, 4), {}}, {square(1, 1, 1), {}}}), Defect::nesting);
  EXPECT_EQ(found({{square(0, 0, 9), {reversed(square(1, 1, 4)), reversed(square(2, 2, 1))}}}), Defect::nesting);
  EXPECT_EQ(found({{square(0, 0, 4), {{{0, 2}, {2, 3}, {4, 2}, {2, 1}}}}}), Defect::disconnected);
  // A hole that belongs to another region.
  EXPECT_EQ(found({{square(0, 0, 4), {}}, {square(5, 0, 4), {reversed(square(1, 1, 1))}}}), Defect::nesting);
}

TEST(CheckValid, AcceptsTouchingAndNesting) {
  EXPECT_EQ(defect({{square(0, 0, 9), {reversed(square(1, 1, 6))}}, {square(2, 2, 2), {}}, {square(4, 4, 2), {}}}), "");
  EXPECT_EQ(defect({{square(0, 0, 4), {{{0, 2}, {2, 3}, {2, 1}}}}, {{{-1, 1}, {0, 1}, {-1, 2}}, {}}}), "");
}

int winding(const Rings& rings, Vec2d p) {
  int sum = 0;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const int side = orientation(a, b, p);
      if (a.y < b.y && side > 0) ++sum;
      if (a.y > b.y && side < 0) --sum;
    }
  }
  return sum;
}

bool near_edge(const Rings& rings, Vec2d p) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      if (std::abs(cross(a, b, p)) <= 1e-9 * (length(b - a) + 1)) return true;
    }
  }
  return false;
}

bool covers(FillRule rule, int winding) {
  switch (rule) {
    case FillRule::even_odd: return winding % 2 != 0;
    case FillRule::non_zero: return winding != 0;
    case FillRule::positive: return winding > 0;
    case FillRule::negative: break;
  }
  return winding < 0;
}

bool combine(BooleanOp op, bool a, bool b) {
  switch (op) {
    case BooleanOp::unite: return a || b;
    case BooleanOp::intersect: return a && b;
    case BooleanOp::subtract: return a && !b;
    case BooleanOp::exclude: break;
  }
  return a != b;
}

constexpr std::array operations{BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract, BooleanOp::exclude};
constexpr std::array fill_rules{FillRule::even_odd, FillRule::non_zero, FillRule::positive, FillRule::negative};

/// On a grid so small that points, edges and lines coincide all the time.
rc::Gen<Rings> small_rings() {
  const auto point = rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 6), rc::gen::inRange(0, 6)),
                                  [](std::pair<int, int> p) { return Vec2d(p.first, p.second); });
  return rc::gen::resize(9, rc::gen::container<Rings>(rc::gen::container<Ring>(point)));
}

void agrees_with_windings(const Rings& a, const Rings& b, FillRule rule) {
  for (const BooleanOp op : operations) {
    const Regions result = boolean(op, a, b, rule);
    RC_ASSERT(defect(result) == "");
    const Rings rings = rings_of(result);
    for (double x = -0.47; x < 6; x += 0.53) {
      for (double y = -0.41; y < 6; y += 0.59) {
        const Vec2d p(x, y);
        if (near_edge(a, p) || near_edge(b, p)) continue;
        const bool inside = combine(op, covers(rule, winding(a, p)), covers(rule, winding(b, p)));
        RC_ASSERT(winding(rings, p) == (inside ? 1 : 0));
      }
    }
  }
}

// rows: PG-02
RC_GTEST_PROP(BooleanProperty, AgreesWithWindingNumbersOnAGrid, ()) {
  const Rings a = *small_rings(), b = *small_rings();
  agrees_with_windings(a, b, *rc::gen::elementOf(fill_rules));
}

RC_GTEST_PROP(BooleanProperty, ManyRingsAgreeToo, ()) {
  // More edges, so that trees have levels and runs have lengths.
  const auto point = rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 25), rc::gen::inRange(0, 25)),
                                  [](std::pair<int, int> p) { return 0.25 * Vec2d(p.first, p.second); });
  const auto ring = rc::gen::map(rc::gen::pair(point, rc::gen::inRange(1, 4)), [](std::pair<Vec2d, int> s) {
    const double size = 0.25 * s.second;
    return Ring{s.first, s.first + Vec2d(size, 0), s.first + Vec2d(1.5 * size, size), s.first + Vec2d(0, size)};
  });
  const auto rings = rc::gen::container<Rings>(20, ring);
  const Rings a = *rings, b = *rings;
  agrees_with_windings(a, b, *rc::gen::elementOf(fill_rules));
}

RC_GTEST_PROP(BooleanProperty, ResultsAreNormalAndSymmetric, ()) {
  const Rings a = *small_rings(), b = *small_rings();
  const FillRule rule = *rc::gen::elementOf(fill_rules);
  for (const BooleanOp op : operations) {
    const Regions result = boolean(op, a, b, rule);
    RC_ASSERT(normalised(rings_of(result)) == result);
    if (op != BooleanOp::subtract) RC_ASSERT(boolean(op, b, a, rule) == result);
  }
}

RC_GTEST_PROP(BooleanProperty, AreasObeyTheIdentities, ()) {
  const Rings a = *small_rings(), b = *small_rings();
  const double both = area(intersect(a, b)), any = area(unite(a, b)), sum = area(normalised(a)) + area(normalised(b));
  RC_ASSERT(std::abs(both + any - sum) <= 1e-9 * sum);
  RC_ASSERT(std::abs(area(exclude(a, b)) - (any - both)) <= 1e-9 * sum);
  RC_ASSERT(std::abs(area(subtract(a, b)) + both - area(normalised(a))) <= 1e-9 * sum);
}

RC_GTEST_PROP(BooleanProperty, DeMorgan, ()) {
  const Rings a = *small_rings(), b = *small_rings(), all{square(-1, -1, 9)};
  const Rings not_a = rings_of(subtract(all, a)), not_b = rings_of(subtract(all, b));
  const Regions left = subtract(all, rings_of(unite(a, b))), right = intersect(not_a, not_b);
  RC_ASSERT(area(exclude(rings_of(left), rings_of(right))) <= 1e-9);
}

RC_GTEST_PROP(BooleanProperty, OrderAndOrientationOfVerticesDoNotMatter, ()) {
  Rings a = *small_rings();
  const Regions expected = normalised(a);
  for (Ring& ring : a) {
    if (ring.empty()) continue;
    std::rotate(ring.begin(),
                ring.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(ring.size())),
                ring.end());
    if (*rc::gen::arbitrary<bool>()) std::reverse(ring.begin(), ring.end());
  }
  std::reverse(a.begin(), a.end());
  RC_ASSERT(area(exclude(rings_of(normalised(a)), rings_of(expected))) <= 1e-9);
}

}  // namespace
}  // namespace lambert::polygon
