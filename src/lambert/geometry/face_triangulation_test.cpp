#include "lambert/geometry/mesh.h"
#include "lambert/geometry/shape_test_tools.h"
#include "lambert/polygon/queries/normal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace lambert {
namespace {

std::vector<std::uint32_t> whole(const std::vector<Vec3>& corners) {
  std::vector<std::uint32_t> face(corners.size());
  std::iota(face.begin(), face.end(), 0u);
  return face;
}

std::vector<Triangle> triangulate(const std::vector<Vec3>& corners) {
  std::vector<Triangle> out;
  triangulate_face(corners, whole(corners), out);
  return out;
}

/// The triangles cover the face once: all turn as it does, and their areas add up to its own.
void expect_covered(const std::vector<Vec3>& corners) {
  const std::vector<Triangle> triangles = triangulate(corners);
  ASSERT_EQ(triangles.size(), corners.size() - 2);
  const Vec3d face = polygon::newell_sum(corners.size(), [&](std::size_t i) { return Vec3d(corners[i]); });
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3d a(corners[t[0]]), n = glm::cross(Vec3d(corners[t[1]]) - a, Vec3d(corners[t[2]]) - a);
    EXPECT_GE(glm::dot(n, face), -1e-6 * glm::dot(face, face));
    sum += glm::length(n);
  }
  EXPECT_NEAR(sum, glm::length(face), 1e-5 * glm::length(face));
}

std::vector<Vec3> in_space(const std::vector<Vec2>& outline) {
  const Frame frame(normalize(Vec3(1, -2, 0.5f)));
  std::vector<Vec3> corners;
  for (const Vec2 p : outline) corners.push_back(p.x * frame.s + p.y * frame.t + 3.0f * frame.n);
  return corners;
}

std::vector<Vec2> star(int tips, const std::function<float()>& radius) {
  std::vector<Vec2> outline;
  for (int i = 0; i < 2 * tips; ++i) {
    const float phi = pi * static_cast<float>(i) / static_cast<float>(tips);
    outline.push_back(radius() * Vec2(std::cos(phi), std::sin(phi)));
  }
  return outline;
}

std::vector<Vec2> comb(int teeth) {
  std::vector<Vec2> outline = {{static_cast<float>(teeth), -1}};
  for (int i = teeth; i > 0; --i) {
    const auto x = static_cast<float>(i);
    outline.insert(outline.end(), {{x, 0}, {x - 0.5f, 5}});
  }
  outline.insert(outline.end(), {{0, 0}, {0, -1}});
  return outline;
}

std::vector<Vec2> spiral(int corners) {
  std::vector<Vec2> outline;
  for (int i = 0; i < corners; ++i) {
    const float phi = 0.1f * static_cast<float>(i);
    outline.push_back((2 + phi) * Vec2(std::cos(phi), std::sin(phi)));
  }
  for (int i = corners - 1; i >= 0; --i) {
    const float phi = 0.1f * static_cast<float>(i);
    outline.push_back((1 + phi) * Vec2(std::cos(phi), std::sin(phi)));
  }
  std::reverse(outline.begin(), outline.end());
  return outline;
}

TEST(TriangulateFace, TrianglesAndQuads) {
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (std::vector<Triangle>{{0, 1, 2}}));
  expect_covered({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  // A dart: only the diagonal through its notch lies inside, whichever corner comes first.
  const std::vector<Vec3> dart = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}};
  for (std::size_t first = 0; first < 4; ++first) {
    std::vector<Vec3> turned = dart;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    expect_covered(turned);
  }
}

TEST(TriangulateFace, ConvexFacesBecomeFans) {
  EXPECT_EQ(triangulate(in_space({{2, 0}, {3, 1}, {2, 3}, {0, 3}, {-1, 1}})),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(TriangulateFace, ConcaveFacesAreCovered) {
  Random random(1);
  for (int i = 0; i < 200; ++i) expect_covered(in_space(star(3 + i % 40, [&] { return random.between(0.1f, 1); })));
  for (const int size : {1, 2, 10, 200}) expect_covered(in_space(comb(size)));
  for (const int size : {10, 100, 300}) expect_covered(in_space(spiral(size)));
}

TEST(TriangulateFace, CornersOnEdgesAreAllowed) {
  expect_covered(in_space({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}));
}

TEST(TriangulateFace, BridgesToHolesAreAllowed) {
  // A square with a square hole, joined by a bridge that runs both ways.
  expect_covered(in_space({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}));
}

TEST(TriangulateFace, LargeConcaveFacesAreQuick) {
  Random random(2);
  for (const auto& outline : {star(50000, [&] { return random.between(0.5f, 1); }), comb(50000)}) {
    std::vector<Vec3> corners;
    for (const Vec2 p : outline) corners.emplace_back(3, p.x, p.y);
    expect_covered(corners);
  }
}

TEST(TriangulateFace, AnythingEndsWithItsNumberOfTriangles) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  Random random(3);
  std::vector<Vec3> tangle(20000), one_place(50, Vec3(1, 2, 3)), line(50), broken(50);
  for (Vec3& p : tangle) p = random.cube(1);
  for (std::size_t i = 0; i < 50; ++i) {
    line[i] = static_cast<float>(i * 7 % 50) * Vec3(1, 2, 3);
    broken[i] = i % 3 ? random.cube(1) : Vec3(nan, inf, 0);
  }
  for (const auto& corners : {tangle, one_place, line, broken})
    EXPECT_EQ(triangulate(corners).size(), corners.size() - 2);
  EXPECT_TRUE(triangulate({{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST(TriangulateFace, IndicesOutOfRangeAreKeptForValidate) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> face = {0, 1, 2, 99, 4000000000u};
  TriangleMesh mesh{.name = "m", .positions = positions};
  triangulate_face(positions, face, mesh.triangles);
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_ANY_THROW(validate(mesh));
}

}  // namespace
}  // namespace lambert
