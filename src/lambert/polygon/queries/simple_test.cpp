#include "lambert/polygon/queries/simple.h"

#include "lambert/polygon/queries/segment.h"
#include "lambert/polygon/test_polygons.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

namespace lambert::polygon {
namespace {

using Kind = Simplicity::Kind;

/// The witness shows what the kind says.
void expect_proof(const Ring& ring, const Simplicity& s) {
  const auto edge = [&](std::size_t i) { return Segment{ring[i], ring[next_index(i, ring.size())]}; };
  if (s.kind == Kind::simple || s.kind == Kind::too_few) return;
  ASSERT_LT(s.first, s.second);
  ASSERT_LT(s.second, ring.size());
  if (s.kind == Kind::vertex_twice) {
    EXPECT_EQ(ring[s.first], ring[s.second]);
    EXPECT_EQ(ring[s.first], s.point);
    return;
  }
  const SegmentMeeting m = intersect(edge(s.first), edge(s.second));
  EXPECT_TRUE(m.meet());
  EXPECT_LT(length(m.from - s.point), 1e-9 * (1 + length(s.point)));
  const bool successive = s.second - s.first == 1 || s.second - s.first == ring.size() - 1;
  EXPECT_EQ(m.from != m.to, s.kind != Kind::edges_cross);
  EXPECT_EQ(s.kind == Kind::spike, m.from != m.to && successive);
}

// rows: PG-05 PG-06 PG-07
TEST(CheckSimple, AgreesWithPairsOnSmallGrids) {
  std::mt19937_64 random(1);
  std::array<int, 6> seen{};
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t side = 2 + random() % 30;
    Ring ring(random() % 9);
    for (Vec2d& p : ring) p = {static_cast<double>(random() % side), static_cast<double>(random() % side)};
    const Simplicity swept = check_simple(ring), tried = check_simple_by_pairs(ring);
    ASSERT_EQ(swept.kind, tried.kind) << message_of(swept) << " against " << message_of(tried);
    expect_proof(ring, swept);
    expect_proof(ring, tried);
    ++seen[static_cast<std::size_t>(swept.kind)];
  }
  for (const int n : seen) EXPECT_GT(n, 1000);
}

// rows: PG-05 PG-07
TEST(CheckSimple, FindsTheOneFaultOfALongRing) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i) {
    Ring ring = test::star(random, 500, 0.5);
    EXPECT_EQ(check_simple(ring).kind, Kind::simple);
    const std::size_t at = random() % 498;
    Ring crossed = ring, touched = ring;
    std::swap(crossed[at], crossed[at + 1]);
    EXPECT_EQ(check_simple(crossed).kind, check_simple_by_pairs(crossed).kind);
    // A vertex moved onto the midpoint of the opposite edge.
    const std::size_t other = (at + 250) % 500;
    touched[at] = 0.5 * (ring[other] + ring[next_index(other, 500)]);
    EXPECT_EQ(check_simple(touched).kind, check_simple_by_pairs(touched).kind);
    Ring twice = ring;
    twice[at] = ring[other];
    EXPECT_EQ(check_simple(twice).kind, check_simple_by_pairs(twice).kind);
  }
}

// rows: PG-05
TEST(CheckSimple, KnowsThePicturedCases) {
  EXPECT_EQ(check_simple({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}).kind, Kind::vertex_twice);
  EXPECT_EQ(check_simple({{0, 0}, {4, 4}, {4, 0}, {0, 4}}).kind, Kind::edges_cross);
  EXPECT_EQ(check_simple({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 0}, {1, 0}, {0, 4}}).kind, Kind::edges_coincide);
  EXPECT_EQ(check_simple({{0, 0}, {4, 0}, {2, 0}, {2, 3}}).kind, Kind::spike);
  EXPECT_EQ(check_simple({{0, 0}, {4, 0}, {4, 0}, {2, 3}}).kind, Kind::vertex_twice);
  EXPECT_EQ(check_simple({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}).kind, Kind::edges_cross) << "a vertex on an edge";
  EXPECT_EQ(check_simple({{0, 0}, {4, 0}}).kind, Kind::too_few);
  EXPECT_EQ(message_of(check_simple({{0, 0}, {4, 4}, {4, 0}, {0, 4}})), "edges 0 and 2 meet at (2, 2)");
  EXPECT_EQ(message_of(check_simple({{0, 0}, {4, 0}, {4, 4}})), "");
}

// rows: PG-07
TEST(CheckSimple, StaysFastWhenManyEdgesMeetInOneVertex) {
  Ring flower;
  for (int i = 0; i < 20000; ++i) {
    flower.emplace_back(0, 0);
    for (const double shift : {0.1, 0.6}) {
      const double angle = 2 * std::numbers::pi * (i + shift) / 20000;
      flower.emplace_back(std::cos(angle), std::sin(angle));
    }
  }
  EXPECT_EQ(check_simple(flower).kind, Kind::vertex_twice);
}

TEST(CheckSimple, ServesCoordinatesOfAnySize) {
  for (const double s : {1e-300, 1e-150, 1e150, 1e300}) {
    Ring bow_tie{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    for (Ring* ring : {&bow_tie, &square})
      for (Vec2d& p : *ring) p *= s;
    EXPECT_EQ(check_simple(bow_tie).kind, Kind::edges_cross);
    EXPECT_EQ(check_simple(square).kind, Kind::simple);
    EXPECT_EQ(check_simple_by_pairs(bow_tie).kind, Kind::edges_cross);
  }
}

// rows: PG-07
TEST(CheckSimple, TakesAFractionOfASecondForAHundredThousandVertices) {
  std::mt19937_64 random(3);
  const Ring ring = test::star(random, 100000, 0.5);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(check_simple(ring).simple());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("milliseconds", static_cast<int>(1000 * seconds));
  EXPECT_LT(seconds, 5) << "a quadratic algorithm would take minutes";
}

}  // namespace
}  // namespace lambert::polygon
