#include "lambert/polygon/line_polygon.h"

#include "lambert/polygon/line_order.h"
#include "lambert/polygon/point_in_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lambert::polygon {
namespace {

using Boundary = LineEvent::Boundary;
using Kind = LineEvent::Kind;

Rings grid_rings(std::mt19937_64& random, std::uint64_t side) {
  Rings rings(1 + random() % 2);
  for (Ring& ring : rings) {
    ring.resize(random() % 9);
    for (Vec2d& p : ring) p = {static_cast<double>(random() % side), static_cast<double>(random() % side)};
  }
  return rings;
}

const LinePiece* piece_at(const std::vector<LinePiece>& pieces, double t) {
  const auto found =
      std::find_if(pieces.begin(), pieces.end(), [t](const LinePiece& p) { return p.t_from < t && t < p.t_to; });
  return found == pieces.end() ? nullptr : &*found;
}

// rows: PG-57 PG-58 PG-59 PG-60
TEST(LineThrough, HoldsThePointsThatLieInside) {
  std::mt19937_64 random(1);
  int inside = 0, on = 0, flipped = 0;
  for (int i = 0; i < 30000; ++i) {
    const Rings rings = grid_rings(random, 6);
    const auto coordinate = [&] { return static_cast<double>(random() % 11) / 2; };
    const Vec2d a(coordinate(), coordinate()), b(coordinate(), coordinate());
    if (a == b) continue;
    for (const FillRule rule : {FillRule::even_odd, FillRule::non_zero}) {
      const LineThrough through = line_through(rings, a, b, rule);
      for (int k = 0; k < 10; ++k) {
        const double t = std::ldexp(static_cast<double>(random() % (1 << 24)), -20) - 8;
        const Vec2d p = a + t * (b - a);  // exact: few bits
        const Place place = locate(rings, p, rule);
        const LinePiece *in = piece_at(through.interior, t), *edge = piece_at(through.on_edges, t);
        ASSERT_FALSE(in && edge);
        if (place != Place::on) {
          ASSERT_EQ(in != nullptr, place == Place::inside) << t;
          ASSERT_EQ(edge, nullptr);
        }
        if (edge) {
          ASSERT_EQ(place, Place::on);
          const Vec2d left = 1e-7 * Vec2d(a.y - b.y, b.x - a.x);
          ASSERT_EQ(edge->inside_left, locate(rings, p + left, rule) == Place::inside);
          ASSERT_EQ(edge->inside_right, locate(rings, p - left, rule) == Place::inside);
          ++on;
        }
        inside += place == Place::inside;
      }
      const bool no_edges = std::none_of(through.events.begin(), through.events.end(),
                                         [](const LineEvent& e) { return e.kind == Kind::edges; });
      if (no_edges && rule == FillRule::even_odd) {
        std::vector<double> ends, crossings;
        for (const LinePiece& p : through.interior) ends.insert(ends.end(), {p.t_from, p.t_to});
        for (const LineEvent& e : through.events)
          if (e.boundary == Boundary::crosses) crossings.push_back(e.t);
        // Each end of a piece is a crossing; two chains that cross in one point change nothing.
        ASSERT_LE(ends.size(), crossings.size());
        ASSERT_EQ(crossings.size() % 2, 0u);
        if (ends.size() == crossings.size()) {
          for (std::size_t k = 0; k < ends.size(); ++k) ASSERT_NEAR(ends[k], crossings[k], 1e-12);
          ++flipped;
        }
      }
      ASSERT_TRUE(std::is_sorted(through.events.begin(), through.events.end(),
                                 [](const auto& e, const auto& f) { return e.t < f.t - 1e-12; }));
    }
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(on, 1000);
  EXPECT_GT(flipped, 1000);
}

// rows: PG-60
TEST(LineThrough, TellsTouchingFromCrossing) {
  // A crown: notches down to y = 2 at x = 2 and 6, tips at y = 4.
  const Rings crown{{{0, 0}, {8, 0}, {8, 4}, {6, 2}, {4, 4}, {2, 2}, {0, 4}}};
  const LineThrough low = line_through(crown, {0, 2}, {1, 2});
  ASSERT_EQ(low.events.size(), 4u);
  EXPECT_EQ(low.events[0].kind, Kind::crossing);
  EXPECT_EQ(low.events[1].kind, Kind::vertex);
  EXPECT_EQ(low.events[1].boundary, Boundary::stays_left) << "a local minimum, seen with y up";
  EXPECT_EQ(low.events[1].index, 5u);
  EXPECT_EQ(low.events[3].boundary, Boundary::crosses);
  ASSERT_EQ(low.interior.size(), 1u);
  EXPECT_EQ(low.interior[0].to, Vec2d(8, 2));

  const LineThrough high = line_through(crown, {0, 4}, {1, 4});
  EXPECT_TRUE(high.interior.empty());
  for (const LineEvent& e : high.events) EXPECT_EQ(e.boundary, Boundary::stays_right);

  const LineThrough base = line_through(crown, {8, 0}, {0, 0});
  ASSERT_EQ(base.on_edges.size(), 1u);
  EXPECT_EQ(base.on_edges[0].from, Vec2d(8, 0));
  EXPECT_TRUE(base.on_edges[0].inside_right);
  EXPECT_FALSE(base.on_edges[0].inside_left);
  ASSERT_EQ(base.events.size(), 1u);
  EXPECT_EQ(base.events[0].kind, Kind::edges);
}

// rows: PG-60
TEST(LineThrough, KnowsStepsAlongTheLine) {
  // A step: the boundary comes from above, runs along y = 1 and goes on below.
  const Rings step{{{0, 0}, {6, 0}, {6, 1}, {3, 1}, {3, 3}, {0, 3}}};
  const LineThrough through = line_through(step, {0, 1}, {1, 1});
  ASSERT_EQ(through.interior.size(), 1u);
  EXPECT_EQ(through.interior[0].to, Vec2d(3, 1));
  ASSERT_EQ(through.on_edges.size(), 1u);
  EXPECT_TRUE(through.on_edges[0].inside_right && !through.on_edges[0].inside_left);
  ASSERT_EQ(through.events.size(), 2u);
  EXPECT_EQ(through.events[1].kind, Kind::edges);
  EXPECT_EQ(through.events[1].boundary, Boundary::crosses);
}

TEST(LineThrough, ServesWhatIsNoPolygon) {
  EXPECT_TRUE(line_through({}, {0, 0}, {1, 0}).events.empty());
  EXPECT_TRUE(line_through({{{0, 0}, {1, 1}, {2, 0}}}, {1, 1}, {1, 1}).events.empty());
  EXPECT_EQ(line_through({{{3, 0}}}, {0, 0}, {1, 0}).events.size(), 1u);
  const LineThrough folded = line_through({{{3, 0}, {5, 0}}}, {0, 0}, {1, 0});
  ASSERT_EQ(folded.on_edges.size(), 1u);
  EXPECT_FALSE(folded.on_edges[0].inside_left || folded.on_edges[0].inside_right);
  EXPECT_EQ(folded.events[0].boundary, Boundary::stays_on);
}

// rows: PG-59
TEST(LineOrder, SortsCrossingsThatDoublesCannotTellApart) {
  // Two edges cross each other beside the line; one unit in an end decides which comes first.
  const LineOrder order({0, 0}, {1, 0});
  const LinePlace rising{{2, -1}, {4, 1}};
  EXPECT_EQ(order.compare(rising, {{4, -1}, {2, 1}}), 0);
  EXPECT_EQ(order.compare(rising, {{4, -1}, {std::nextafter(2.0, 3.0), 1}}), -1);
  EXPECT_EQ(order.compare(rising, {{4, -1}, {std::nextafter(2.0, 1.0), 1}}), 1);
  EXPECT_EQ(order.compare({{4, -1}, {std::nextafter(2.0, 1.0), 1}}, rising), -1);
  EXPECT_EQ(order.compare({{3, 0}, {3, 0}}, rising), 0);
  EXPECT_EQ(order.compare({{std::nextafter(3.0, 4.0), 0}, {std::nextafter(3.0, 4.0), 0}}, rising), 1);
  EXPECT_EQ(order.parameter(rising), 3);
  EXPECT_EQ(order.point(rising), Vec2d(3, 0));
}

TEST(LineOrder, IsTheOrderOfRationalNumbers) {
  std::mt19937_64 random(4);
  const auto integer = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1)));
  };
  int equal = 0;
  for (int i = 0; i < 50000; ++i) {
    const auto place = [&] {
      if (random() % 4 == 0) {
        const Vec2d v(integer(-8, 8), 0);
        return LinePlace{v, v};
      }
      return LinePlace{{integer(-8, 8), integer(-4, -1)}, {integer(-8, 8), integer(1, 4)}};
    };
    const LinePlace p = place(), q = place();
    // On the line y = 0 an edge is at (x_r y_l - x_l y_r) / (y_l - y_r).
    const auto number = [](const LinePlace& l) {
      return l.is_vertex() ? std::pair(l.left.x, 1.0)
                           : std::pair(l.right.x * l.left.y - l.left.x * l.right.y, l.left.y - l.right.y);
    };
    const auto [pn, pm] = number(p);
    const auto [qn, qm] = number(q);
    const double difference = pn * qm - qn * pm;
    ASSERT_EQ(LineOrder({0, 0}, {3, 0}).compare(p, q), (difference > 0) - (difference < 0));
    equal += difference == 0;
  }
  EXPECT_GT(equal, 500);
}

}  // namespace
}  // namespace lambert::polygon
