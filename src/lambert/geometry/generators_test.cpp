#include "lambert/geometry/generators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

namespace lambert {
namespace {

struct Example {
  const char* name;
  TriangleMesh mesh;
  double area;
  double tolerance;  // relative, of area
  bool closed;
};

void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

/// Of the (p, q) curve on a torus of radii 2 and 1. A tube about it has 2π r times as much area (Pappus).
double knot_length(double p, double q) {
  constexpr int steps = 1000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += std::hypot(p * (2 + std::cos(q * 2 * std::numbers::pi * i / steps)), q);
  return 2 * std::numbers::pi * sum / steps;
}

std::vector<Example> examples() {
  const double p = std::numbers::pi;
  return {{"grid", grid(2, 3, 4, 5), 6, 1e-6, false},
          {"disk", disk(2, 100), 4 * p, 1e-3, false},
          {"box", box({-1, -2, -3}, {1, 2, 3}), 2 * (8 + 12 + 24), 1e-6, true},
          {"uv_sphere", uv_sphere(2, 80, 40), 16 * p, 5e-3, true},
          {"icosphere", icosphere(2, 4), 16 * p, 5e-3, true},
          {"cone", cone(3, 4, 100), p * 3 * (3 + 5), 2e-3, true},
          {"torus", torus(2, 0.5f, 100, 50), 4 * p * p * 2 * 0.5, 5e-3, true},
          {"torus_knot", torus_knot(2, 3, 800, 60), 2 * p * 0.45 * knot_length(2, 3), 5e-3, true}};
}

class EveryGenerator : public testing::TestWithParam<Example> {};

Vec3 face_normal(const TriangleMesh& m, const Triangle& t) {
  return cross(m.positions[t[1]] - m.positions[t[0]], m.positions[t[2]] - m.positions[t[0]]);
}

TEST_P(EveryGenerator, ArraysAreCompleteAndValid) {
  const TriangleMesh& mesh = GetParam().mesh;
  validate(mesh);
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
  for (const Vec3 n : mesh.normals) EXPECT_NEAR(length(n), 1, 1e-5);
}

TEST_P(EveryGenerator, TrianglesRunCounterClockwiseAboutTheNormals) {
  const TriangleMesh& mesh = GetParam().mesh;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 n = face_normal(mesh, t);
    ASSERT_GT(length(n), 0);
    for (const std::uint32_t v : t) ASSERT_GT(dot(normalize(n), mesh.normals[v]), 0.5f);
  }
}

TEST_P(EveryGenerator, AreaIsThatOfTheSurface) {
  EXPECT_NEAR(static_cast<double>(GetParam().mesh.area()), GetParam().area, GetParam().tolerance * GetParam().area);
}

/// uv turn the same way round as the triangles: textures are not mirrored.
TEST_P(EveryGenerator, UvsRunCounterClockwise) {
  const TriangleMesh& mesh = GetParam().mesh;
  std::size_t mirrored = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec2 a = mesh.uvs[t[1]] - mesh.uvs[t[0]], b = mesh.uvs[t[2]] - mesh.uvs[t[0]];
    mirrored += a.x * b.y - a.y * b.x <= 0;
  }
  const bool base_mirrored = std::string(GetParam().name) == "cone";  // its base is a mirrored disk
  EXPECT_LE(mirrored, base_mirrored ? mesh.triangles.size() / 2 : mesh.triangles.size() / 100);
}

INSTANTIATE_TEST_SUITE_P(Generators, EveryGenerator, testing::ValuesIn(examples()),
                         [](const auto& example) { return std::string(example.param.name); });

TEST(Generators, ClosedSurfacesHaveNoCracks) {
  for (const Example& example : examples()) {
    if (!example.closed) continue;
    EXPECT_TRUE(is_closed(example.mesh)) << example.name;
    EXPECT_GT(example.mesh.volume(), 0) << example.name;
  }
}

TEST(Generators, TriangleCounts) {
  EXPECT_EQ(uv_sphere(1, 10, 6).triangles.size(), 2u * 10 * 5);
  EXPECT_EQ(icosphere(1, 3).triangles.size(), 20u * 64);
  EXPECT_EQ(torus_knot(2, 3, 2000, 125).triangles.size(), 500000u);
}

TEST(Generators, KnotTubeHasItsRadius) {
  const TriangleMesh knot = torus_knot(3, 5, 500, 16);
  for (std::size_t i = 0; i < knot.positions.size(); ++i) {
    const Vec3 centre = knot.positions[i] - 0.45f * knot.normals[i];
    const float across = std::hypot(centre.x, centre.y) - 2;
    EXPECT_NEAR(std::hypot(across, centre.z), 1, 1e-5);
  }
}

}  // namespace
}  // namespace lambert
