#include "lambert/polygon/clip/window_clip.h"

#include "lambert/polygon/clip/clip_test_tools.h"
#include "lambert/polygon/clip/components.h"

#include <gtest/gtest.h>

namespace lambert::polygon {
namespace {

const Ring u_shape{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 1}, {2, 1}, {2, 4}, {0, 4}};

// rows: PG-56
TEST(WindowClip, AUComesApart) {
  const Rings arms = clip_to_half_plane({u_shape}, keep_y_from(2));
  EXPECT_EQ(canonical(arms), canonical({{{0, 2}, {2, 2}, {2, 4}, {0, 4}}, {{4, 2}, {6, 2}, {6, 4}, {4, 4}}}));
  EXPECT_EQ(canonical(clip_to_half_plane({reversed(u_shape)}, keep_y_from(2))),
            canonical({reversed(arms[0]), reversed(arms[1])}));
}

// rows: PG-56
TEST(WindowClip, EdgesOnTheLine) {
  // The floor of the notch lies on the line: from above two arms, from below a block with a straight roof.
  EXPECT_EQ(canonical(clip_to_half_plane({u_shape}, keep_y_from(1))),
            canonical({{{0, 1}, {2, 1}, {2, 4}, {0, 4}}, {{4, 1}, {6, 1}, {6, 4}, {4, 4}}}));
  EXPECT_EQ(canonical(clip_to_half_plane({u_shape}, keep_y_to(1))), canonical({{{0, 0}, {6, 0}, {6, 1}, {0, 1}}}));
  // Only touched, along an edge or in a corner: nothing is left.
  EXPECT_TRUE(clip_to_half_plane({u_shape}, keep_y_from(4)).empty());
  EXPECT_TRUE(clip_to_half_plane({{{0, 0}, {1, 0}, {0, 1}}}, ClipLine{{1, 0}, {2, 5}}.flipped()).empty());
  // Nothing cut off: the ring as it was.
  EXPECT_EQ(clip_to_half_plane({u_shape}, keep_y_from(0)), Rings{u_shape});
}

// rows: PG-56
TEST(WindowClip, PiecesThatMeetInAPointComeApart) {
  const Ring notched{{0, -1}, {4, -1}, {4, 2}, {2, 0}, {0, 2}};
  EXPECT_EQ(canonical(clip_to_half_plane({notched}, keep_y_from(0))),
            canonical({{{0, 0}, {2, 0}, {0, 2}}, {{2, 0}, {4, 0}, {4, 2}}}));
}

// rows: PG-56
TEST(WindowClip, HolesOpenAndStay) {
  const Rings rings{
      {{0, 0}, {9, 0}, {9, 6}, {0, 6}}, {{1, 1}, {1, 5}, {4, 5}, {4, 1}}, {{6, 4}, {6, 5}, {7, 5}, {7, 4}}};
  const Rings upper = clip_to_half_plane(rings, keep_y_from(3));
  ASSERT_EQ(upper.size(), 2u);
  EXPECT_DOUBLE_EQ(signed_area(upper), 9 * 3 - 3 * 2 - 1);
  const Regions pieces = components(upper);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].outer.size(), 8u);
  EXPECT_EQ(pieces[0].holes, Rings{rings[2]});
  // A hole with an edge on the line becomes a notch.
  EXPECT_EQ(canonical(clip_to_half_plane({rings[0], rings[1]}, keep_y_from(1))),
            canonical({{{0, 1}, {1, 1}, {1, 5}, {4, 5}, {4, 1}, {9, 1}, {9, 6}, {0, 6}}}));
}

// rows: PG-50
TEST(WindowClip, RectangleAndConvexWindow) {
  EXPECT_EQ(canonical(clip_to_rectangle({{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}}, {0, 0}, {2, 1})),
            canonical({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}));
  EXPECT_TRUE(clip_to_rectangle({u_shape}, {2, 2}, {1, 3}).empty());
  EXPECT_EQ(clip_to_rectangle({u_shape}, {5, 1}, {5, 3}).size(), 0u);
  const Ring diamond{{3, -1}, {7, 3}, {3, 7}, {3, 7}, {-1, 3}, {1, 1}};
  const Rings inside = clip_to_convex({{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}}, diamond);
  EXPECT_DOUBLE_EQ(signed_area(inside), 32);
  EXPECT_TRUE(clip_to_convex({u_shape}, {}).empty());
  EXPECT_TRUE(clip_to_convex({u_shape}, {{0, 0}, {4, 4}}).empty());
}

/// Two distinct edges along a line that cover each other in opposite directions, or a repeated vertex on it.
bool has_bridge(const Rings& rings, const ClipLine& line) {
  std::vector<std::pair<Vec2d, Vec2d>> ahead, back;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      if (line.side(a) != 0 || line.side(b) != 0) continue;
      if (a == b) return true;
      if (line.compare_along(a, b) < 0)
        ahead.emplace_back(a, b);
      else
        back.emplace_back(b, a);
    }
  for (const auto& [a, b] : ahead)
    for (const auto& [c, d] : back)
      if (line.compare_along(a, d) < 0 && line.compare_along(c, b) < 0) return true;
  return false;
}

// rows: PG-56
TEST(WindowClip, WildRingsKeepTheirWindingNumbers) {
  Chance chance(21);
  for (int run = 0; run < 20000; ++run) {
    Rings rings;
    for (int i = chance.whole(1, 3); i > 0; --i) rings.push_back(chance.wild(chance.whole(0, 12), 6));
    const bool slanted = run % 4 == 0;
    const int c = chance.whole(-1, 7);
    const ClipLine upright[] = {keep_x_from(c), keep_x_to(c), keep_y_from(c), keep_y_to(c)};
    const ClipLine line = slanted ? ClipLine{chance.on_grid(6), chance.on_grid(6)} : upright[run % 4];
    if (line.tail == line.head) continue;
    const Rings clipped = clip_to_half_plane(rings, line);
    const bool repeats = clipped == rings;
    if (!slanted && !repeats) {
      ASSERT_FALSE(has_bridge(clipped, line)) << run;
    }
    for (const Ring& ring : clipped)
      for (const Vec2d p : ring)
        if (!slanted) {
          ASSERT_GE(line.side(p), 0);
        }
    for (int i = 0; i < 20; ++i) {
      const Vec2d p = chance.in_square(6);
      const auto before = winding_number(rings, p), after = winding_number(clipped, p);
      if (!before || !after || line.side(p) == 0) continue;
      ASSERT_EQ(*after, line.side(p) > 0 ? *before : 0) << run;
    }
  }
}

// rows: PG-50 PG-53 PG-56
TEST(WindowClip, BothSidesTogetherHaveTheAreaOfTheWhole) {
  Chance chance(22);
  for (int run = 0; run < 5000; ++run) {
    const Ring ring = run % 2 ? chance.star(chance.whole(5, 60), {3, 3}, 0.3, 3) : chance.comb(8, 4);
    const ClipLine line =
        run % 3 ? ClipLine{chance.on_grid(6), chance.on_grid(6) + Vec2d(0.5, 7)} : keep_y_from(chance.whole(-4, 4));
    const Rings left = clip_to_half_plane({ring}, line), right = clip_to_half_plane({ring}, line.flipped());
    ASSERT_NEAR(signed_area(left) + signed_area(right), signed_area(ring), 1e-9 * signed_area(ring)) << run;
    for (const Rings& side : {left, right})
      for (const Ring& piece : side) ASSERT_GT(signed_area(piece), -1e-12) << run;
  }
}

// rows: PG-50 PG-56
TEST(WindowClip, NineWindowsTileTheRing) {
  Chance chance(23);
  for (int run = 0; run < 1000; ++run) {
    const Ring ring = chance.star(chance.whole(5, 80), {1.5, 1.5}, 0.2, 1.49);
    double sum = 0;
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y) {
        const Rings part = clip_to_rectangle({ring}, {x, y}, {x + 1, y + 1});
        for (const Ring& piece : part) {
          ASSERT_GT(signed_area(piece), -1e-12);
          for (const Vec2d p : piece) ASSERT_TRUE(p.x >= x && p.x <= x + 1 && p.y >= y && p.y <= y + 1);
        }
        sum += signed_area(part);
      }
    ASSERT_NEAR(sum, signed_area(ring), 1e-9 * signed_area(ring));
  }
}

// rows: PG-56
TEST(WindowClip, FirstVertexAndDirectionDoNotMatter) {
  Chance chance(24);
  for (int run = 0; run < 3000; ++run) {
    const Ring ring = run % 2 ? chance.star(chance.whole(5, 40), {3, 3}, 0.3, 3) : chance.comb(6, 3);
    const ClipLine line = run % 3 ? ClipLine{chance.on_grid(6), chance.on_grid(6) + Vec2d(0.5, 7)} : keep_y_from(1);
    const Rings clipped = canonical(clip_to_half_plane({ring}, line));
    for (const std::size_t by : {1u, 5u})
      ASSERT_EQ(canonical(clip_to_half_plane({rotated(ring, by)}, line)), clipped) << run;
    Rings turned = clip_to_half_plane({reversed(ring)}, line);
    for (Ring& piece : turned) piece = reversed(piece);
    ASSERT_EQ(canonical(turned), clipped) << run;
  }
}

// rows: PG-56
TEST(WindowClip, HugeTinyAndDegenerateInputsEnd) {
  Chance chance(25);
  for (int run = 0; run < 2000; ++run) {
    const double scale = std::array{1e150, 1e-150, 4e307, 5e-324, 1.0}[static_cast<std::size_t>(run % 5)];
    Ring ring = chance.wild(chance.whole(0, 10), 3);
    for (Vec2d& p : ring) p *= scale;
    const ClipLine line{chance.on_grid(3) * scale, chance.on_grid(3) * scale};
    for (const Ring& piece : clip_to_half_plane({ring}, line))
      for (const Vec2d p : piece) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
    clip_to_convex({ring}, chance.wild(4, 3));
    clip_to_rectangle({ring}, {0.5 * scale, 0.5 * scale}, {2 * scale, 2 * scale});
  }
}

// rows: PG-56
TEST(Components, IslandsHolesAndTouchingRings) {
  const auto square = [](double x, double y, double size) {
    return Ring{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  };
  const Rings rings{reversed(square(1, 1, 8)), square(0, 0, 10), square(2, 2, 6),
                    reversed(square(3, 3, 1)), square(20, 0, 5), reversed(square(40, 0, 5))};
  const Regions regions = components(rings);
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_EQ(regions[0], (Region{rings[1], {rings[0]}}));
  EXPECT_EQ(regions[1], (Region{rings[2], {rings[3]}}));
  EXPECT_EQ(regions[2], (Region{rings[4], {}}));

  // A hole whose corners all lie on the outer ring, beside a larger box that does not hold it.
  const Ring outer{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, diamond{{2, 0}, {0, 2}, {2, 4}, {4, 2}};
  const Ring around{{-1, -1}, {9, -1}, {9, 9}, {8, 9}, {8, 0}, {-1, 0}};
  const Regions touching = components({around, diamond, outer});
  ASSERT_EQ(touching.size(), 2u);
  EXPECT_TRUE(touching[0].holes.empty());
  EXPECT_EQ(touching[1].holes, Rings{diamond});
  EXPECT_TRUE(components({}).empty());
  EXPECT_TRUE(components({{}, {{1, 1}}, {{0, 0}, {1, 1}}}).empty());
}

}  // namespace
}  // namespace lambert::polygon
