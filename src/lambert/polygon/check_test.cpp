#include "lambert/polygon/check.h"

#include <gtest/gtest.h>

#include <vector>

namespace lambert::polygon {
namespace {

using Fault = ChainCheck::Fault;
using List = std::vector<Vec2d>;

// rows: PG-04 PG-03
TEST(CheckClosedList, NamesTheVertexAtFault) {
  const auto check = [](const List& list) { return check_closed_list(list); };
  EXPECT_TRUE(check({{0, 0}, {1, 0}, {0, 1}, {0, 0}}));
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0, 1}, {1, 1}}), (ChainCheck{Fault::not_closed, 3}));
  EXPECT_EQ(check({{0, 0}, {0, 0}, {1, 0}, {0, 1}, {0, 0}}), (ChainCheck{Fault::repeated_vertex, 0}));
  EXPECT_EQ(check({{0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 0}}), (ChainCheck{Fault::repeated_vertex, 1}));
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 0}}), (ChainCheck{Fault::repeated_vertex, 3}));
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0, 0}}).fault, Fault::too_few) << "a triangle has four entries";
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0, 1}}), (ChainCheck{Fault::not_closed, 2}));
  EXPECT_EQ(check({{0, 0}, {1, 0}}).fault, Fault::too_few);
  EXPECT_EQ(check({}).fault, Fault::too_few);
}

// rows: PG-04 PG-03
TEST(CheckRing, CountsTheEdgeFromLastToFirst) {
  const auto check = [](const List& list) { return check_ring(list); };
  EXPECT_TRUE(check({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0, 1}, {0, 0}}), (ChainCheck{Fault::repeated_vertex, 3}));
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0, 1}, {0, 1}}), (ChainCheck{Fault::repeated_vertex, 2}));
  EXPECT_EQ(check({{0, 0}, {1, 0}}).fault, Fault::too_few);
  EXPECT_EQ(message_of(check({{0, 0}, {1, 0}, {0, 1}, {0, 0}}), 4), "vertices 3 and 0 coincide");
  EXPECT_EQ(message_of(check({{0, 0}, {1, 0}, {0, 1}}), 3), "");
}

// rows: PG-04
TEST(CheckRing, WorksInSpace) {
  const std::vector<Vec3d> ring{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, folded{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(check_ring(ring));
  EXPECT_EQ(check_ring(folded), (ChainCheck{Fault::repeated_vertex, 1}));
  EXPECT_EQ(check_closed_list(ring), (ChainCheck{Fault::not_closed, 2}));
}

}  // namespace
}  // namespace lambert::polygon
