#include "lambert/geometry/revolve.h"

#include "lambert/base/error.h"
#include "lambert/geometry/solid_test_tools.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace lambert {
namespace {

using polygon::Region;
using polygon::Ring;

constexpr double tau = 2 * std::numbers::pi;

const Region ring_section{{{2, -1}, {3, -1}, {3, 1}, {2, 1}}, {}};
/// With a hole, a concave side and a side on the axis.
const Region goblet{{{0, 0}, {3, 0}, {1, 2}, {3, 5}, {0, 5}}, {{{0.5, 1}, {0.5, 1.5}, {1, 1.25}}}};
/// A tip on the axis.
const Region cone{{{0, 0}, {2, 1}, {1, 3}}, {}};

/// Area times the way of the centre of mass, by triangles from the origin.
double pappus_volume(const Region& region, double angle) {
  double first_moment = 0;
  for (const Ring& ring : rings_of(region))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[polygon::next_index(i, ring.size())];
      first_moment += 0.5 * (a.x * b.y - a.y * b.x) * (a.x + b.x) / 3;
    }
  return angle * first_moment;
}

/// Length times the way of the centre of each edge, and the caps.
double pappus_area(const Region& region, double angle) {
  double sum = angle < tau ? 2 * area(region) : 0;
  for (const Ring& ring : rings_of(region))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[polygon::next_index(i, ring.size())];
      sum += glm::length(b - a) * angle * (a.x + b.x) / 2;
    }
  return sum;
}

// rows: PG-39
TEST(Revolve, SolidsAreClosedAndApproachPappus) {
  for (const Region& region : {ring_section, goblet, cone})
    for (const float sweep : {360.0f, 270.0f, 180.0f, 35.0f})
      for (const Vec3d axis : {Vec3d(0, 1, 0), Vec3d(0, 0, -2), Vec3d(1, 2, 3)}) {
        Revolution revolution{.origin = {1, -2, 0.5}, .axis = axis, .sweep = degrees(sweep), .steps = 12};
        const TriangleMesh coarse = revolve(region, revolution);
        expect_sound(coarse);
        expect_watertight(coarse);
        revolution.steps = 400;
        const TriangleMesh fine = revolve(region, revolution);
        const double angle = static_cast<double>(sweep) / 360 * tau;
        EXPECT_NEAR(fine.volume(), pappus_volume(region, angle), 2e-4 * pappus_volume(region, angle));
        EXPECT_NEAR(fine.area(), pappus_area(region, angle), 2e-4 * pappus_area(region, angle));
      }
}

// rows: PG-39
TEST(Revolve, VolumeOfFacetsIsPappusTimesTheChord) {
  // A polygon of n sides inscribed in a circle has n/2 sin(tau/n) / (tau/2) of its area, at every height.
  for (const int n : {3, 4, 16}) {
    const double part = n * std::sin(tau / n) / tau;
    const double volume = part * pappus_volume(goblet, tau);
    EXPECT_NEAR(revolve(goblet, {.steps = n}).volume(), volume, 1e-5 * volume);
  }
}

// rows: PG-39
TEST(Revolve, ACylinderOfSixteenSides) {
  const std::vector<Vec3d> profile{{1, 0, 0}, {1, 2, 0}};
  const TriangleMesh mesh = revolve(profile, {.steps = 16});
  expect_sound(mesh);
  EXPECT_EQ(mesh.triangles.size(), 32u);
  EXPECT_NEAR(mesh.area(), 16 * 2 * 2 * std::sin(tau / 32), 1e-5);
  // Outward, since the chain runs upward.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_NEAR(dot(mesh.normals[i], Vec3(mesh.positions[i].x, 0, mesh.positions[i].z)), 1, 1e-6f);
  EXPECT_EQ(revolution_counts(profile, {.steps = 16}), (SolidCounts{.vertices = 32, .quads = 16}));
}

// rows: PG-39
TEST(Revolve, PolesAreTrianglesAndSpheresAreSmooth) {
  std::vector<Vec3d> profile;
  constexpr int along = 12;
  for (int i = 0; i <= along; ++i) {
    const double theta = tau / 2 * (i - along / 2) / along;
    profile.emplace_back(i % along == 0 ? 0 : std::cos(theta), std::sin(theta), 0);
  }
  const TriangleMesh mesh = revolve(profile, {.steps = 20});
  expect_sound(mesh);
  expect_watertight(mesh);
  EXPECT_EQ(mesh.triangles.size(), 2u * 20 * (along - 1));
  EXPECT_EQ(revolution_counts(profile, {.steps = 20}),
            (SolidCounts{.vertices = 20 * 11 + 2, .quads = 20 * 10, .triangles = 40}));
  for (std::size_t i = 20 + 1; i < mesh.positions.size() - 21; ++i)
    EXPECT_GT(dot(mesh.normals[i], mesh.positions[i]), 0.999f);
}

// rows: PG-39
TEST(Revolve, PolesOfSlantedAxesAreFoundInSpiteOfRounding) {
  const Vec3d axis = normalize(Vec3d(1, 2, 3)), origin(0.1, 0.2, 0.7), out = normalize(cross(axis, Vec3d(0, 0, 1)));
  const std::vector<Vec3d> profile{origin + 0.3 * axis, origin + 1.1 * axis + out, origin + 2.7 * axis};
  const Revolution revolution{.origin = origin, .axis = axis, .steps = 8};
  const TriangleMesh mesh = revolve(profile, revolution);
  EXPECT_EQ(mesh.triangles.size(), 16u);
  expect_sound(mesh);
  expect_watertight(mesh);
  EXPECT_EQ(revolution_counts(profile, revolution).triangles, 16u);
}

// rows: PG-39
TEST(Revolve, StartAndReferenceTurnTheSolid) {
  const TriangleMesh mesh = revolve(ring_section, {.start = degrees(90), .sweep = degrees(90), .steps = 1});
  // From -z (a quarter about y from x) to -x.
  EXPECT_NEAR(mesh.bounds().min.x, -3, 1e-6f);
  EXPECT_NEAR(mesh.bounds().max.x, 0, 1e-6f);
  EXPECT_NEAR(mesh.bounds().min.z, -3, 1e-6f);
  EXPECT_NEAR(mesh.bounds().max.z, 0, 1e-6f);
  EXPECT_EQ(revolution_counts(ring_section, {.sweep = degrees(90), .steps = 1}),
            (SolidCounts{.vertices = 8, .quads = 4, .caps = 2}));
  // A reference along the axis is replaced.
  expect_watertight(revolve(ring_section, {.reference = {0, 5, 0}, .steps = 5}));
}

// rows: PG-39
TEST(Revolve, Hyperboloid) {
  // A line that does not meet the axis: the surface is that of x² + z² = 1 + y².
  const std::vector<Vec3d> profile{{1, -1, 1}, {1, 0, 0}, {1, 1, -1}};
  const TriangleMesh mesh = revolve(profile, {.steps = 200});
  validate(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 p = mesh.positions[i], n = mesh.normals[i];
    EXPECT_NEAR(p.x * p.x + p.z * p.z - p.y * p.y, 1, 1e-5f);
    EXPECT_NEAR(dot(n, normalize(Vec3(p.x, -p.y, p.z))), 1, 1e-5f);
  }
}

// rows: PG-39
TEST(Revolve, Errors) {
  const std::vector<Vec3d> profile{{1, 0, 0}, {1, 2, 0}};
  EXPECT_THROW(revolve(std::span(profile).first(1)), Error);
  EXPECT_THROW(revolve(profile, {.axis = {0, 0, 0}}), Error);
  EXPECT_THROW(revolve(profile, {.steps = 1 << 30}), Error);
  EXPECT_THROW(revolve(profile, {.steps = 2}), Error);
  EXPECT_THROW(revolve(profile, {.sweep = degrees(10), .steps = 0}), Error);
  EXPECT_THROW(revolve(profile, {.sweep = degrees(400)}), Error);
  EXPECT_THROW(revolve(profile, {.sweep = degrees(0)}), Error);
  EXPECT_THROW(revolve(Region{{{-1, 0}, {1, 0}, {1, 1}}, {}}), Error);
  EXPECT_THROW(revolve(Region{{{1, 0}, {1, 1}}, {}}), Error);
  EXPECT_THROW(revolve(std::vector<Vec3d>{{1, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 0}}), Error);
  // Segments on the axis and repeated points leave nothing.
  EXPECT_TRUE(revolve(std::vector<Vec3d>{{0, 0, 0}, {0, 1, 0}, {0, 1, 0}}).triangles.empty());
}

}  // namespace
}  // namespace lambert
