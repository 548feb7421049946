#include "lambert/geometry/extrude.h"

#include "lambert/base/error.h"
#include "lambert/geometry/solid_test_tools.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace lambert {
namespace {

using polygon::Region;
using polygon::Ring;

const Region square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};
const Region frame{{{0, 0}, {6, 0}, {6, 5}, {3, 4}, {0, 5}},
                   {{{1, 1}, {1, 3}, {2, 3}, {2, 1}}, {{4, 1}, {4, 2}, {5, 2}, {5, 1}}}};

Ring circle_of(int n, double radius) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    ring.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return ring;
}

double perimeter(const Region& region) {
  double sum = 0;
  for (const Ring& ring : rings_of(region))
    for (std::size_t i = 0; i < ring.size(); ++i)
      sum += glm::length(ring[polygon::next_index(i, ring.size())] - ring[i]);
  return sum;
}

TEST(Extrude, CoordinatesBeyondFloatAreRefusedInPlainWords) {
  for (const double size : {1e40, 1e-46, 1e-150}) {
    const Region sized{{{0, 0}, {size, 0}, {size, size}, {0, size}}, {}};
    try {
      extrude(sized, {.along = {0, 0, 1}});
      ADD_FAILURE() << size;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("float, in which meshes are kept"), std::string::npos) << e.what();
    }
  }
  EXPECT_FALSE(extrude(Region{{{0, 0}, {1e-30, 0}, {0, 1e-30}}, {}}).triangles.empty());
}

// rows: PG-38
TEST(Extrude, PrismsAreClosedWithTheirVolumeAndSurface) {
  for (const Region& region : {square, frame, Region{circle_of(40, 2), {}}})
    for (const Vec3d along : {Vec3d(0, 0, 3), Vec3d(0, 0, -2), Vec3d(1, -2, 1.5), Vec3d(1, 1, -0.5)}) {
      const TriangleMesh mesh = extrude(region, {.along = along});
      expect_sound(mesh);
      expect_watertight(mesh);
      const double volume = area(region) * std::abs(along.z);
      EXPECT_NEAR(mesh.volume(), volume, 1e-5 * volume);
      if (along.x == 0) {
        EXPECT_NEAR(mesh.area(), 2 * area(region) + perimeter(region) * std::abs(along.z), 1e-4);
      }
    }
}

// rows: PG-38
TEST(Extrude, Counts) {
  EXPECT_EQ(extrusion_counts(square), (SolidCounts{.vertices = 8, .quads = 4, .caps = 2}));
  EXPECT_EQ(extrusion_counts(frame), (SolidCounts{.vertices = 26, .quads = 13, .caps = 2}));
  EXPECT_EQ(extrude(square).triangles.size(), 4u * 2 + 2 * 2);
  // Two holes in 13 vertices: 13 - 2 + 2 * 2 triangles in each cap.
  EXPECT_EQ(extrude(frame).triangles.size(), 13u * 2 + 2 * 15);
}

// rows: PG-38
TEST(Extrude, SharpCornersAndSmoothCircles) {
  const TriangleMesh box = extrude(square), round = extrude(Region{circle_of(40, 2), {}});
  EXPECT_EQ(box.positions.size(), 4u * 4 + 2 * 4);
  // One column of two for each vertex, one more at the seam, and the caps.
  EXPECT_EQ(round.positions.size(), 2u * 41 + 2 * 40);
  for (std::size_t i = 0; i < 82; ++i) {
    const Vec3 p = round.positions[i];
    EXPECT_NEAR(dot(round.normals[i], normalize(Vec3(p.x, p.y, 0))), 1, 1e-6f);
  }
  EXPECT_EQ(extrude(Region{circle_of(40, 2), {}}, {.crease = degrees(5)}).positions.size(), 4u * 40 + 2 * 40);
}

// rows: PG-38
TEST(Extrude, OrientationOfTheRingsDoesNotMatter) {
  Region turned = frame;
  std::reverse(turned.outer.begin(), turned.outer.end());
  for (Ring& hole : turned.holes) std::reverse(hole.begin(), hole.end());
  const TriangleMesh mesh = extrude(turned);
  expect_watertight(mesh);
  EXPECT_NEAR(mesh.volume(), extrude(frame).volume(), 1e-5f);
}

// rows: PG-38
TEST(Extrude, RepeatedAndCollinearVertices) {
  const TriangleMesh mesh = extrude(Region{{{0, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 2}}, {}});
  expect_sound(mesh);
  expect_watertight(mesh);
  EXPECT_NEAR(mesh.volume(), 4, 1e-6f);
}

// rows: PG-38
TEST(Extrude, TouchingRingsStayClosed) {
  // Holes that touch the outer ring's edges and each other with a corner or along an edge.
  const Ring outer{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  for (const polygon::Rings& holes :
       {polygon::Rings{{{4, 0}, {2, 2}, {6, 2}}}, polygon::Rings{{{4, 0}, {2, 4}, {4, 8}, {6, 4}}},
        polygon::Rings{{{2, 0}, {2, 2}, {4, 2}, {4, 0}}},
        polygon::Rings{{{1, 1}, {1, 4}, {4, 4}}, {{2, 1}, {3, 3}, {5, 1}}},
        polygon::Rings{{{8, 1}, {7, 1}, {7, 3}, {8, 3}}, {{8, 3}, {7, 4}, {8, 5}}}}) {
    const Region region{outer, holes};
    double inside = 64;
    for (const Ring& hole : holes) inside -= std::abs(polygon::signed_area(hole));
    const TriangleMesh mesh = extrude(region);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(mesh.volume(), inside, 1e-5);
  }
}

// rows: PG-38
TEST(Extrude, SeveralRegionsAndErrors) {
  const Region apart{{{9, 0}, {10, 0}, {10, 1}, {9, 1}}, {}};
  const TriangleMesh both = extrude(polygon::Regions{square, apart}, {.along = {0, 0, 2}});
  expect_watertight(both);
  EXPECT_NEAR(both.volume(), 4, 1e-6f);
  EXPECT_THROW(extrude(square, {.along = {1, 1, 0}}), Error);
  EXPECT_THROW(extrude(square, {.along = {0, 0, std::numeric_limits<double>::infinity()}}), Error);
  EXPECT_THROW(extrude(Region{}), Error);
  EXPECT_THROW(extrude(Region{{{0, 0}, {1, 1}, {2, 2}}, {}}), Error);
  EXPECT_THROW(extrude(Region{{{0, 0}, {1e300, 1}, {2, 2}}, {}}), Error);
}

}  // namespace
}  // namespace lambert
