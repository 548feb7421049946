#include "lambert/polygon/arrangement/network.h"
#include "lambert/polygon/arrangement/subdivision.h"
#include "lambert/polygon/boolean/boolean.h"
#include "lambert/polygon/boolean/valid.h"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace lambert::polygon::arrangement {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Ring around(Vec2d centre, std::size_t size, double inner, double outer, Random& random) {
  Ring ring;
  for (std::size_t i = 0; i < size; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(size);
    ring.push_back(centre + uniform(random, inner, outer) * Vec2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

Rings random_rings(Random& random) {
  Rings rings;
  for (int count = std::uniform_int_distribution(1, 12)(random); count > 0; --count) {
    const Vec2d centre(uniform(random, -1, 1), uniform(random, -1, 1));
    const double size = uniform(random, 0.02, 0.5);
    rings.push_back(around(centre, std::uniform_int_distribution<std::size_t>(3, 120)(random),
                           size * uniform(random, 0.2, 1), size, random));
  }
  return rings;
}

/// The tree and the sweep find the same crossings and sort them out in different ways.
TEST(Paths, TreeAndSweepMakeTheSameRegions) {
  Random random(11);
  constexpr BooleanOp operations[]{BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract, BooleanOp::exclude};
  for (int i = 0; i < 300; ++i) {
    const Outline outline = outline_of(random_rings(random), random_rings(random));
    const BoxTree tree(outline);
    const std::optional<Marks> marks = find_marks(outline, tree, 1000);
    ASSERT_TRUE(marks.has_value());
    const Network network(outline, tree, *marks);
    const Subdivision subdivision = subdivide(outline);
    for (const BooleanOp op : operations) {
      const Selection selection{op, i % 2 == 0 ? FillRule::even_odd : FillRule::non_zero};
      const Regions regions = network.select(selection);
      ASSERT_EQ(regions, select(subdivision, selection)) << i;
      const auto invalid = check_valid(regions);
      ASSERT_FALSE(invalid) << invalid->message();
    }
  }
}

TEST(Paths, TheTreeGivesUpOnWhatItIsNoGoodFor) {
  Random random(12);
  const Outline outline = outline_of({around({0, 0}, 4000, 0.3, 1, random)}, {around({0.01, 0}, 4000, 0.3, 1, random)});
  EXPECT_FALSE(find_marks(outline, BoxTree(outline)).has_value());
}

/// Rounding bends the edges on both sides of a vertex so that parts of them cross beside it, and the crossing is
/// rounded to the vertex, which cuts neither.
TEST(Paths, PartsMayCrossBesideTheirVertex) {
  const Rings subject{{{0x1.17544f17fb84fp-3, 0x1.a2fe76a3f9477p-2},
                       {0x1.17544f17fb84fp-1, 0x1.17544f17fb84ep-2},
                       {0x1.17544f17fb84fp-3, 0x1.17544f17fb84fp-1},
                       {0x1.17544f17fb84fp-1, 0x1.a2fe76a3f9475p-2},
                       {0, 0x1.a2fe76a3f9478p-2}}};
  const Rings clip{{{0x1.17544f17fb84fp-1, 0x1.17544f17fb84ep-2},
                    {0x1.17544f17fb84fp-1, 0x1.17544f17fb85p-1},
                    {0x1.17544f17fb84fp-2, 0x1.17544f17fb85p-2},
                    {0x1.17544f17fb84ep-3, 0}},
                   {{0x1.a2fe76a3f9477p-2, 0x1.17544f17fb85p-1},
                    {0x1.a2fe76a3f9475p-2, 0x1.a2fe76a3f9475p-2},
                    {0x1.a2fe76a3f9475p-2, 0x1.17544f17fb85p-3},
                    {0x1.17544f17fb84ep-1, 0},
                    {0x1.a2fe76a3f9478p-2, 0},
                    {0x1.17544f17fb84fp-1, 0x1.17544f17fb85p-1},
                    {0, 0x1.17544f17fb84fp-1}}};
  const Outline outline = outline_of(subject, clip);
  EXPECT_FALSE(find_marks(outline, BoxTree(outline)).has_value()) << "the sweep sorts it out";
  for (const BooleanOp op : {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract, BooleanOp::exclude})
    for (const FillRule rule : {FillRule::even_odd, FillRule::non_zero}) {
      const auto invalid = check_valid(boolean(op, subject, clip, rule));
      EXPECT_FALSE(invalid) << invalid->message();
    }
}

/// All ways through one small cell, as rounding needs many rounds to sort out.
TEST(Paths, RoundsEndWhereEdgesNearlyCoincide) {
  Random random(13);
  int most = 0;
  for (int i = 0; i < 200; ++i) {
    Rings rings;
    for (int r = 0; r < 6; ++r) {
      Ring& ring = rings.emplace_back();
      for (int v = 0; v < 6; ++v)
        ring.emplace_back(std::floor(uniform(random, 0, 3)) + 0x1p-50 * uniform(random, -1, 1),
                          std::floor(uniform(random, 0, 3)) + 0x1p-50 * uniform(random, -1, 1));
    }
    const Subdivision subdivision = subdivide(outline_of(rings, {}));
    most = std::max(most, subdivision.rounds);
    const Regions regions = select(subdivision, {BooleanOp::unite, FillRule::non_zero});
    const auto invalid = check_valid(regions);
    ASSERT_FALSE(invalid) << invalid->message();
  }
  EXPECT_LE(most, 30);
}

}  // namespace
}  // namespace lambert::polygon::arrangement
