// The same answers, to the bit but for the size, wherever the coordinates are.

#include "lambert/polygon/scale.h"

#include "lambert/polygon/boolean.h"
#include "lambert/polygon/clip_test_tools.h"
#include "lambert/polygon/components.h"
#include "lambert/polygon/convex.h"
#include "lambert/polygon/convex_pieces.h"
#include "lambert/polygon/delaunay.h"
#include "lambert/polygon/ear_clipping.h"
#include "lambert/polygon/line_through.h"
#include "lambert/polygon/normal.h"
#include "lambert/polygon/pick.h"
#include "lambert/polygon/point_locator.h"
#include "lambert/polygon/segment.h"
#include "lambert/polygon/simple.h"
#include "lambert/polygon/trapezoids.h"
#include "lambert/polygon/triangulate.h"
#include "lambert/polygon/window_clip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::polygon {
namespace {

constexpr double sizes[] = {0x1p500, 0x1p-500, 0x1p664, 0x1p-664, 0x1p1000, 0x1p-940};

class Scale : public testing::Test {
 protected:
  /// Of the grid, so that much is collinear, or anywhere.
  Rings rings(int i) {
    Rings all{chance_.star(9, {4, 4}, 1, 4), chance_.wild(7, 8)};
    if (i % 2 == 0) all[0] = chance_.wild(8, 8);
    return all;
  }
  Chance chance_{17};
};

TEST(SafeScale, KeepsOrdinarySizesAndAllBits) {
  const auto scale = [](double least, double most) { return safe_scale(Sizes{least, most}); };
  EXPECT_EQ(scale(1e-60, 1e60), 1);
  EXPECT_EQ(scale(1e150, 1e150) * 1e150, std::ldexp(1e150, 200 - std::ilogb(1e150)));
  EXPECT_EQ(scale(1e-150, 1e150), std::ldexp(1, 200 - std::ilogb(1e150)));
  EXPECT_EQ(scale(1e-300, 1e300), 1);
  EXPECT_EQ(safe_scale(sizes_of(Ring{})), 1);
  EXPECT_EQ(safe_scale(sizes_of(Ring{{0, 0}, {0, 0}})), 1);
}

// rows: PG-45 PG-43
TEST_F(Scale, PlacesOfPointsAreThose) {
  for (int i = 0; i < 60; ++i) {
    const Rings plain = rings(i);
    const Vec2d p = chance_.on_grid(8);
    for (const double size : sizes) {
      const Rings large = scaled(plain, size);
      EXPECT_EQ(locate(large, size * p), locate(plain, p));
      EXPECT_EQ(PointLocator(large).locate(size * p), locate(plain, p));
      EXPECT_EQ(strips_around(large[0], size * p), strips_around(plain[0], p));
    }
  }
}

// rows: PG-05 PG-15
TEST_F(Scale, ClassesAreThose) {
  for (int i = 0; i < 60; ++i) {
    const Ring plain = rings(i)[i % 3 == 0];
    for (const double size : sizes) {
      const Ring large = scaled(plain, size);
      const Simplicity a = check_simple(plain), b = check_simple(large);
      EXPECT_EQ(a.kind, b.kind);
      EXPECT_EQ(size * a.point, b.point);
      EXPECT_EQ(is_convex(plain), is_convex(large));
      EXPECT_EQ(ring_orientation(plain), ring_orientation(large));
      EXPECT_EQ(reflex_vertices(plain), reflex_vertices(large));
      EXPECT_NEAR(total_turning(plain), total_turning(large), 1e-12);
    }
  }
}

// rows: PG-54 PG-56 PG-60
TEST_F(Scale, ClippingIsThat) {
  for (int i = 0; i < 60; ++i) {
    const Rings plain = rings_of(normalised(rings(i)));
    const ClipLine line{chance_.in_square(8), chance_.in_square(8)};
    const Rings clipped = clip_to_half_plane(plain, line), windowed = clip_to_rectangle(plain, {2, 3}, {6, 5});
    const LineThrough through = line_through(plain, line.tail, line.head);
    for (const double size : sizes) {
      const Rings large = scaled(plain, size);
      const Vec2d tail = size * line.tail, head = size * line.head;
      EXPECT_EQ(clip_to_half_plane(large, {tail, head}), scaled(clipped, size));
      EXPECT_EQ(clip_to_rectangle(large, size * Vec2d(2, 3), size * Vec2d(6, 5)), scaled(windowed, size));
      EXPECT_EQ(rings_of(components(scaled(clipped, size))), scaled(rings_of(components(clipped)), size));
      const LineThrough same = line_through(large, tail, head);
      ASSERT_EQ(same.inside.size(), through.inside.size());
      for (std::size_t k = 0; k < same.inside.size(); ++k) {
        EXPECT_EQ(same.inside[k].from, size * through.inside[k].from);
        EXPECT_EQ(same.inside[k].to, size * through.inside[k].to);
      }
    }
  }
}

// rows: PG-21 PG-25
TEST_F(Scale, PiecesAreThose) {
  for (int i = 0; i < 40; ++i)
    for (const Region& plain : normalised(rings(i))) {
      const auto slabs = trapezoids(plain).pieces;
      for (const double size : sizes) {
        const Region large{scaled(plain.outer, size), scaled(plain.holes, size)};
        EXPECT_EQ(triangulate(large), triangulate(plain));
        EXPECT_EQ(delaunay(large), delaunay(plain));
        EXPECT_EQ(clip_ears(large.outer), clip_ears(plain.outer));
        EXPECT_EQ(convex_pieces(large), scaled(convex_pieces(plain), size));
        const auto same = trapezoids(large).pieces;
        ASSERT_EQ(same.size(), slabs.size());
        for (std::size_t k = 0; k < same.size(); ++k)
          for (std::size_t c = 0; c < same[k].size; ++c) EXPECT_EQ(same[k].corners[c], size * slabs[k].corners[c]);
      }
    }
}

// rows: PG-18 PG-41 PG-42
TEST_F(Scale, MeasuresAreThose) {
  for (int i = 0; i < 60; ++i) {
    const Ring plain = rings(i)[0];
    const Vec2d p = chance_.in_square(8), a = chance_.in_square(8), b = chance_.in_square(8);
    std::vector<Vec3d> face;
    for (const Vec2d v : plain) face.emplace_back(v, chance_.whole(0, 3));
    for (const double size : sizes) {
      const Ring large = scaled(plain, size);
      std::vector<Vec3d> large_face;
      for (const Vec3d v : face) large_face.push_back(size * v);
      EXPECT_EQ(wide_signed_area(large), static_cast<long double>(size) * wide_signed_area(plain) * size);
      EXPECT_EQ(perimeter({large}), size * perimeter({plain}));
      EXPECT_EQ(distance_to_segment(size * a, size * b, size * p), size * distance_to_segment(a, b, p));
      EXPECT_EQ(signed_coordinate(size * a, size * b, size * p), size * signed_coordinate(a, b, p));
      EXPECT_EQ(picked_edge({0.4 * size, 0.3 * size}, large, size * p), picked_edge({0.4, 0.3}, plain, p));
      const auto normal = newell_normal(face), same = newell_normal(large_face);
      ASSERT_EQ(normal.has_value(), same.has_value());
      if (normal) {
        EXPECT_LT(length(*normal - *same), 1e-15);
        EXPECT_NEAR(out_of_plane_sine(face), out_of_plane_sine(large_face), 1e-15);
      }
    }
  }
}

TEST(SignedArea, IsRightWhileItIsADouble) {
  const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto expect = [&](double size, double area) { EXPECT_DOUBLE_EQ(signed_area(scaled(square, size)), area); };
  expect(1e150, 1e300);
  expect(1e-150, 1e-300);
  EXPECT_EQ(signed_area(scaled(square, 1e200)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(signed_area(scaled(square, 1e-200)), 0);
  // Products of coordinates overflow or vanish, the area does not.
  EXPECT_DOUBLE_EQ(signed_area(Ring{{0, 0}, {1e300, 0}, {1e300, 1e-300}, {0, 1e-300}}), 1);
  EXPECT_DOUBLE_EQ(signed_area(Ring{{0, 0}, {1e150, 0}, {1e-150, 1e-150}}), 0.5);
  EXPECT_NEAR(static_cast<double>(wide_signed_area(scaled(square, 1e-200)) * 1e200L * 1e200L), 1, 1e-15);
  EXPECT_DOUBLE_EQ(perimeter({scaled(square, 1e200)}), 4e200);
  EXPECT_DOUBLE_EQ(perimeter({scaled(square, 1e-200)}), 4e-200);
}

// Sizes that no factor brings together.
TEST(Predicates, AreExactFromTheLeastToTheLargestDouble) {
  const double least = 0x1p-1074, most = 0x1.fffffffffffffp1023;
  EXPECT_EQ(orientation({0, 0}, {1e150, 0}, {1e-150, 1e-150}), 1);
  EXPECT_EQ(orientation({0, 0}, {most, 0}, {least, least}), 1);
  EXPECT_EQ(orientation({0, 0}, {most, least}, {0.5 * most, least}), 1);
  EXPECT_EQ(orientation({-most, -most}, {0, 0}, {most, most}), 0);
  EXPECT_EQ(orientation({-most, -most}, {0, least}, {most, most}), -1);
  EXPECT_EQ(orientation({-most, -most}, {least, 0}, {most, most}), 1);
  EXPECT_EQ(orientation({0, 0}, {least, least}, {2 * least, 2 * least}), 0);
  EXPECT_EQ(orientation({0, 0}, {3 * least, least}, {5 * least, 2 * least}), 1);
  EXPECT_EQ(in_circle({least, 0}, {0, least}, {-least, 0}, {0, -least}), 0);
  EXPECT_EQ(in_circle({most, 0}, {0, most}, {-most, 0}, {0, -most}), 0);
  EXPECT_EQ(in_circle({most, 0}, {0, most}, {-most, 0}, {least, -most}), -1);
  EXPECT_EQ(in_circle({most, 0}, {0, most}, {-most, 0}, {least, least}), 1);
  EXPECT_EQ(dot_sign({0, 0}, {most, least}, {0, 0}, {-least, most}), 0);
  EXPECT_EQ(turn_sign({0, 0}, {least, 0}, {0, 0}, {most, least}), 1);
}

}  // namespace
}  // namespace lambert::polygon
