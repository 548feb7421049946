#include "lambert/polygon/queries/line_through.h"

#include "lambert/polygon/clip/clip_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::polygon {
namespace {

using Intervals = std::vector<std::pair<double, double>>;

Intervals along_x(const std::vector<LinePiece>& pieces) {
  Intervals intervals;
  for (const LinePiece& piece : pieces) intervals.emplace_back(piece.from.x, piece.to.x);
  return intervals;
}

LineThrough at_height(const Rings& rings, double y, FillRule rule = FillRule::even_odd) {
  return line_through(rings, {0, y}, {1, y}, rule);
}

const Ring crown{{0, 0}, {8, 0}, {8, 4}, {6, 2}, {4, 4}, {2, 2}, {0, 4}};

// rows: PG-57 PG-60
TEST(LineThrough, EventsInContext) {
  const LineThrough notch = at_height({crown}, 2);
  EXPECT_EQ(along_x(notch.inside), (Intervals{{0, 8}}));
  ASSERT_EQ(notch.events.size(), 4u);
  EXPECT_EQ(notch.events[0].kind, LineEventKind::edge_crossing);
  EXPECT_EQ(notch.events[1].kind, LineEventKind::vertex);
  EXPECT_EQ(notch.events[1].context, LineContext::minimum);
  EXPECT_EQ(notch.events[1].vertex, 5u);
  ASSERT_EQ(notch.touches.size(), 2u);
  EXPECT_EQ(notch.touches[0].point, Vec2d(2, 2));
  EXPECT_EQ(notch.touches[0].state, LineState::inside);

  const LineThrough tips = at_height({crown}, 4);
  EXPECT_TRUE(tips.inside.empty() && tips.edges.empty());
  ASSERT_EQ(tips.touches.size(), 3u);
  EXPECT_EQ(tips.touches[1].state, LineState::outside);
  for (const LineEvent& event : tips.events) EXPECT_EQ(event.context, LineContext::maximum);

  const LineThrough floor = at_height({crown}, 0);
  EXPECT_TRUE(floor.inside.empty());
  EXPECT_EQ(along_x(floor.edges), (Intervals{{0, 8}}));
  EXPECT_EQ(floor.edges[0].state, LineState::edge_interior_left);
  ASSERT_EQ(floor.events.size(), 1u);
  EXPECT_EQ(floor.events[0].kind, LineEventKind::edge_on_line);
  EXPECT_EQ(line_through({crown}, {1, 0}, {0, 0}).edges[0].state, LineState::edge_interior_right);
}

// rows: PG-60
TEST(LineThrough, VertexWhereTheBoundaryCrosses) {
  const LineThrough through = at_height({{{0, -1}, {3, 0}, {0, 1}, {-3, 0}}}, 0);
  EXPECT_EQ(along_x(through.inside), (Intervals{{-3, 3}}));
  EXPECT_EQ(through.events[0].context, LineContext::crosses);
  EXPECT_TRUE(through.touches.empty());
}

// rows: PG-60
TEST(LineThrough, EdgesWhereTheBoundaryCrossesOrTurns) {
  const Ring steps{{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 5}, {2, 5}, {2, 3}, {0, 3}};
  const LineThrough through = at_height({steps}, 3);
  EXPECT_EQ(along_x(through.inside), (Intervals{{2, 4}}));
  EXPECT_EQ(along_x(through.edges), (Intervals{{0, 2}, {4, 6}}));
  for (const LinePiece& edge : through.edges) EXPECT_EQ(edge.state, LineState::edge_interior_right);
  // With its floor on the line a hole's upper side remains inside.
  const Ring hole{{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  const LineThrough below = at_height({steps, hole}, 1);
  EXPECT_EQ(along_x(below.inside), (Intervals{{0, 1}, {2, 6}}));
  EXPECT_EQ(along_x(below.edges), (Intervals{{1, 2}}));
  EXPECT_EQ(below.edges[0].state, LineState::edge_interior_right);
}

// rows: PG-59
TEST(LineThrough, PairsWhereNothingIsTouched) {
  const auto pairs = alternating_pairs({crown}, {0, 3}, {1, 3});
  ASSERT_TRUE(pairs.has_value());
  EXPECT_EQ(*pairs, (std::vector<std::pair<Vec2d, Vec2d>>{{{0, 3}, {1, 3}}, {{3, 3}, {5, 3}}, {{7, 3}, {8, 3}}}));
  EXPECT_FALSE(alternating_pairs({crown}, {0, 2}, {1, 2}).has_value());
  EXPECT_TRUE(alternating_pairs({crown}, {0, 9}, {1, 9})->empty());
}

// rows: PG-60
TEST(LineThrough, NothingIsNoTrouble) {
  EXPECT_TRUE(line_through({}, {0, 0}, {1, 0}).events.empty());
  EXPECT_TRUE(line_through({crown}, {1, 1}, {1, 1}).events.empty());
  EXPECT_TRUE(line_through({{}, {{1, 0}}, {{0, 1}, {2, -1}}}, {0, 0}, {1, 0}).inside.empty());
  const LineThrough flat = at_height({{{0, 0}, {1, 0}, {3, 0}}}, 0);
  EXPECT_TRUE(flat.inside.empty() && flat.edges.empty());
  EXPECT_EQ(flat.events[0].context, LineContext::within);
}

LineState state_at(const LineThrough& through, const ClipLine& line, Vec2d p) {
  for (const auto* pieces : {&through.inside, &through.edges})
    for (const LinePiece& piece : *pieces)
      if (line.compare_along(piece.from, p) <= 0 && line.compare_along(p, piece.to) <= 0) return piece.state;
  return LineState::outside;
}

// rows: PG-57 PG-59 PG-60
TEST(LineThrough, WildRingsAgreeWithPointsBesideTheLine) {
  Chance chance(31);
  std::size_t compared = 0, on_edges = 0;
  for (int run = 0; run < 20000; ++run) {
    Rings rings;
    for (int i = chance.whole(1, 3); i > 0; --i) rings.push_back(chance.wild(chance.whole(0, 10), 5));
    const ClipLine line{chance.on_grid(5), chance.on_grid(5)};
    if (line.tail == line.head) continue;
    const FillRule rule = run % 2 ? FillRule::even_odd : FillRule::non_zero;
    const LineThrough through = line_through(rings, line.tail, line.head, rule);
    const auto inside = [&](int w) { return rule == FillRule::even_odd ? w % 2 != 0 : w != 0; };
    for (int i = 0; i < 10; ++i) {
      const Vec2d d = line.head - line.tail, p = line.tail + chance.real(-5, 5) * d;
      // Events on this grid are more than 1e-3 apart from others.
      bool near_event = false;
      for (const LineEvent& e : through.events)
        near_event = near_event || glm::length(e.from - p) < 1e-3 || glm::length(e.to - p) < 1e-3;
      if (near_event) continue;
      const Vec2d n = 1e-6 * Vec2d(-d.y, d.x);
      const auto left = winding_number(rings, p + n), right = winding_number(rings, p - n);
      if (!left || !right) continue;
      const LineState expected = inside(*left) ? (inside(*right) ? LineState::inside : LineState::edge_interior_left)
                                               : (inside(*right) ? LineState::edge_interior_right : LineState::outside);
      ASSERT_EQ(state_at(through, line, p), expected) << run;
      compared += expected != LineState::outside;
      on_edges += expected == LineState::edge_interior_left;
    }
  }
  EXPECT_GT(compared, 5000u);
  EXPECT_GT(on_edges, 100u);
}

// rows: PG-59 PG-60
TEST(LineThrough, PairsAreTheInsidePieces) {
  Chance chance(32);
  int untouched = 0;
  for (int run = 0; run < 2000; ++run) {
    const Ring ring = chance.star(chance.whole(5, 60), {3, 3}, 0.3, 3);
    const Vec2d tail = chance.in_square(6), head = chance.in_square(6);
    const auto pairs = alternating_pairs({ring}, tail, head);
    if (!pairs) continue;
    ++untouched;
    std::vector<std::pair<Vec2d, Vec2d>> inside;
    for (const LinePiece& piece : line_through({ring}, tail, head).inside) inside.emplace_back(piece.from, piece.to);
    ASSERT_EQ(*pairs, inside);
  }
  EXPECT_GT(untouched, 1900);
}

// rows: PG-60
TEST(LineThrough, HugeAndTinyInputsEnd) {
  Chance chance(34);
  for (int run = 0; run < 5000; ++run) {
    const double scale = std::array{1e150, 1e-150, 4e307, 5e-324}[static_cast<std::size_t>(run % 4)];
    Ring ring = chance.wild(chance.whole(0, 12), 3);
    for (Vec2d& p : ring) p *= scale;
    const LineThrough through = line_through({ring}, scale * chance.on_grid(3), scale * chance.on_grid(3));
    ASSERT_LE(through.inside.size() + through.edges.size(), 24u);
  }
}

// rows: PG-60
TEST(LineThrough, FirstVertexAndDirectionsDoNotMatter) {
  Chance chance(33);
  const auto spans = [](const std::vector<LinePiece>& pieces) {
    std::vector<std::array<double, 4>> all;
    for (const LinePiece& p : pieces) all.push_back({p.from.x, p.from.y, p.to.x, p.to.y});
    return all;
  };
  for (int run = 0; run < 5000; ++run) {
    const Ring ring = chance.wild(chance.whole(3, 12), 5);
    const Vec2d tail = chance.on_grid(5), head = chance.on_grid(5);
    const LineThrough through = line_through({ring}, tail, head);
    for (const Ring& same : {rotated(ring, 3), reversed(ring)}) {
      const LineThrough other = line_through({same}, tail, head);
      ASSERT_EQ(spans(other.inside), spans(through.inside));
      ASSERT_EQ(spans(other.edges), spans(through.edges));
    }
    auto back = spans(line_through({ring}, head, tail).inside);
    std::reverse(back.begin(), back.end());
    for (auto& s : back) s = {s[2], s[3], s[0], s[1]};
    ASSERT_EQ(back, spans(through.inside));
  }
}

}  // namespace
}  // namespace lambert::polygon
