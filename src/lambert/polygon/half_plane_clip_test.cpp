#include "lambert/polygon/half_plane_clip.h"

#include "lambert/polygon/clip_test_tools.h"

#include <gtest/gtest.h>

#include <array>

namespace lambert::polygon {
namespace {

const Ring seven{{0, 4}, {6, 4}, {6, -1}, {4, -1}, {3, 2}, {2, -1}, {0, -2}};

// rows: PG-51
TEST(HalfPlaneClip, EnterStayLeave) {
  const Ring triangle{{0, -1}, {4, -1}, {2, 1}};
  EXPECT_EQ(sutherland_hodgman(triangle, keep_y_from(0)), (Ring{{3, 0}, {2, 1}, {1, 0}}));
  EXPECT_EQ(sutherland_hodgman(triangle, keep_y_to(0)), (Ring{{4, -1}, {3, 0}, {1, 0}, {0, -1}}));
  EXPECT_EQ(sutherland_hodgman(triangle, keep_y_from(-1)), rotated(triangle, 1));
  EXPECT_TRUE(sutherland_hodgman(triangle, keep_y_from(2)).empty());
}

// rows: PG-51
TEST(HalfPlaneClip, VerticesOnTheLineAreNotRepeated) {
  const Ring square{{0, 0}, {2, -2}, {4, 0}, {2, 2}};
  EXPECT_EQ(sutherland_hodgman(square, keep_y_from(0)), (Ring{{4, 0}, {2, 2}, {0, 0}}));
}

// rows: PG-51
TEST(HalfPlaneClip, FewVerticesAreNoTrouble) {
  EXPECT_TRUE(sutherland_hodgman({}, keep_x_from(0)).empty());
  EXPECT_EQ(sutherland_hodgman({{1, 1}}, keep_x_from(0)), (Ring{{1, 1}}));
  EXPECT_TRUE(sutherland_hodgman({{-1, 1}}, keep_x_from(0)).empty());
  EXPECT_EQ(sutherland_hodgman({{-1, 1}, {1, 1}}, keep_x_from(0)), (Ring{{0, 1}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(trace_clip({}, keep_x_from(0)).steps.empty());
}

// rows: PG-52
TEST(HalfPlaneClip, TraceNamesNewVerticesInTheirOrder) {
  std::vector<LabelledVertex> labelled;
  for (std::size_t i = 0; i < seven.size(); ++i) labelled.push_back({seven[i], std::to_string(i + 1)});
  const ClipTrace trace = trace_clip(labelled, keep_y_from(0), "AB");
  std::string order;
  for (const LabelledVertex& v : trace.ring) order += v.label + " ";
  EXPECT_EQ(order, "2 A B 5 A1 B1 1 ");
  ASSERT_EQ(trace.steps.size(), 8u);
  EXPECT_EQ(trace.steps[4].output, (std::vector<std::string>{"B", "5"}));
}

// rows: PG-53 PG-55
TEST(HalfPlaneClip, PipelineEqualsLinesInTurnAndReadsTheInputOnce) {
  Chance chance(11);
  for (int run = 0; run < 3000; ++run) {
    const Ring ring = run % 2 ? chance.wild(chance.whole(0, 40), 8) : chance.star(60, {4, 4}, 1, 5);
    std::vector<ClipLine> lines;
    for (int i = chance.whole(0, 6); i > 0; --i) lines.push_back({chance.on_grid(8), chance.on_grid(8)});
    const std::span<const Vec2d> chain(ring);
    const auto in_turn = clip_in_turn(chain, std::span<const ClipLine>(lines));
    const auto at_once = clip_at_once(chain, std::span<const ClipLine>(lines));
    ASSERT_EQ(in_turn.chain, at_once.chain);
    ASSERT_EQ(at_once.vertices_read, ring.size());
    if (lines.empty()) {
      ASSERT_EQ(in_turn.vertices_read, 0u);
    }
  }
}

/// A vertex on its way to the screen.
struct ClipSpaceVertex {
  Vec4 position{0};
  Vec3 colour{0};
  bool operator==(const ClipSpaceVertex&) const = default;
};

/// One of the six planes of the view volume: -w <= x, y, z <= w.
struct VolumeDistance {
  int axis;
  float sign;
  float operator()(const ClipSpaceVertex& v) const { return v.position.w + sign * v.position[axis]; }
};
ClipSpaceVertex mix_vertices(const ClipSpaceVertex& a, const ClipSpaceVertex& b, float t) {
  return {a.position + t * (b.position - a.position), a.colour + t * (b.colour - a.colour)};
}

using VolumePlane = PlaneBoundary<VolumeDistance, decltype(&mix_vertices)>;

std::vector<VolumePlane> view_volume() {
  std::vector<VolumePlane> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {1.0f, -1.0f}) planes.push_back({VolumeDistance{axis, sign}, &mix_vertices});
  return planes;
}

// rows: PG-55
TEST(PlaneClip, SixPlanesReadAboutSixTimesAsMuchInTurn) {
  std::vector<ClipSpaceVertex> polygon;
  constexpr int n = 100;
  for (int i = 0; i < n; ++i) {
    const float angle = 2 * pi * static_cast<float>(i) / n;
    polygon.push_back({{0.9f * std::cos(angle), 0.9f * std::sin(angle), 0, 1}, {1, 0, 0}});
  }
  const auto planes = view_volume();
  const std::span<const ClipSpaceVertex> chain(polygon);
  EXPECT_EQ(clip_in_turn(chain, std::span<const VolumePlane>(planes)).vertices_read, 6u * n);
  EXPECT_EQ(clip_at_once(chain, std::span<const VolumePlane>(planes)).vertices_read, 1u * n);
}

// rows: PG-55
TEST(PlaneClip, AttributesStayLinearAndResultsInside) {
  Chance chance(5);
  const auto planes = view_volume();
  std::size_t kept = 0;
  for (int run = 0; run < 2000; ++run) {
    std::vector<ClipSpaceVertex> triangle;
    for (int i = 0; i < 3; ++i) {
      Vec4 p;
      for (int k = 0; k < 4; ++k) p[k] = static_cast<float>(chance.real(-2, 2));
      // The colour is a linear function of the position, before and after.
      triangle.push_back({p, Vec3(p) + Vec3(p.w)});
    }
    const std::span<const ClipSpaceVertex> chain(triangle);
    const auto clipped = clip_at_once(chain, std::span<const VolumePlane>(planes)).chain;
    ASSERT_EQ(clipped, clip_in_turn(chain, std::span<const VolumePlane>(planes)).chain);
    kept += clipped.size();
    for (const ClipSpaceVertex& v : clipped) {
      for (const VolumePlane& plane : planes) ASSERT_GE(plane.distance(v), -1e-5f);
      ASSERT_LT(length(v.colour - (Vec3(v.position) + Vec3(v.position.w))), 1e-5f);
    }
  }
  EXPECT_GT(kept, 1000u);
}

// rows: PG-55
TEST(PlaneClip, ACommonEdgeGetsOneCrossing) {
  Chance chance(6);
  const auto planes = view_volume();
  for (int run = 0; run < 2000; ++run) {
    const auto some = [&] {
      return ClipSpaceVertex{{chance.real(-2, 2), chance.real(-2, 2), chance.real(-2, 2), 1}, {1, 2, 3}};
    };
    const ClipSpaceVertex a = some(), b = some();
    for (const VolumePlane& plane : planes)
      if (plane.side(a) * plane.side(b) < 0) {
        ASSERT_EQ(plane.crossing(a, b), plane.crossing(b, a));
      }
  }
}

// rows: PG-51
TEST(ClipLine, CrossingsDependNeitherOnDirectionNorOnSide) {
  Chance chance(7);
  int crossings = 0;
  for (int run = 0; run < 20000; ++run) {
    const double size = std::exp(chance.real(-20, 20));
    const ClipLine lines[] = {{chance.in_square(size), chance.in_square(size)},
                              keep_x_to(chance.real(0, size)),
                              keep_y_from(chance.real(0, size))};
    const Vec2d a = chance.in_square(size), b = chance.in_square(size);
    for (const ClipLine& line : lines) {
      ASSERT_EQ(line.side(a), -line.flipped().side(a));
      if (line.side(a) * line.side(b) >= 0) continue;
      ++crossings;
      const Vec2d p = line.crossing(a, b);
      ASSERT_EQ(p, line.crossing(b, a));
      ASSERT_EQ(p, line.flipped().crossing(a, b));
      ASSERT_TRUE(p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x));
      ASSERT_TRUE(p.y >= std::min(a.y, b.y) && p.y <= std::max(a.y, b.y));
      if (line.is_vertical()) {
        ASSERT_EQ(p.x, line.tail.x);
      }
      if (line.is_horizontal()) {
        ASSERT_EQ(p.y, line.tail.y);
      }
      // In long double, so that the oracle's own rounding does not show.
      using Long = long double;
      const Long tx = Long(line.tail.x), ty = Long(line.tail.y), hx = Long(line.head.x), hy = Long(line.head.y);
      const auto distance = [&](Long x, Long y) { return (hx - tx) * (y - ty) - (hy - ty) * (x - tx); };
      const Long ax = Long(a.x), ay = Long(a.y), bx = Long(b.x), by = Long(b.y), px = Long(p.x), py = Long(p.y);
      const Long t = distance(ax, ay) / (distance(ax, ay) - distance(bx, by)), largest = std::max({ax, ay, bx, by}),
                 most = 4 * 0x1p-52L * largest;
      ASSERT_LE(std::abs(px - (ax + t * (bx - ax))), most);
      ASSERT_LE(std::abs(py - (ay + t * (by - ay))), most);
    }
  }
  EXPECT_GT(crossings, 10000);
}

// rows: PG-51
TEST(ClipLine, NearlyParallelEdgesStayWithinTheirBox) {
  const ClipLine line{{0, 0}, {1, 1}};
  const Vec2d a{0.5, 0.5 + 0x1p-53}, b{0.75, 0.75 - 0x1p-53};
  ASSERT_EQ(line.side(a) * line.side(b), -1);
  const Vec2d p = line.crossing(a, b);
  EXPECT_NEAR(p.x, 0.625, 0.01);
  for (const double size : {1e150, 1e-150, 1e300}) {
    const Vec2d q = ClipLine{{0, 0}, {size, size}}.crossing({0, size}, {size, 0});
    EXPECT_TRUE(q.x >= 0 && q.x <= size && q.y >= 0 && q.y <= size);
  }
}

}  // namespace
}  // namespace lambert::polygon
