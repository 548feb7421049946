#include "lambert/polygon/decompose/strips.h"

#include "lambert/polygon/decompose/delaunay.h"
#include "lambert/polygon/test_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace lambert::polygon {
namespace {

Indices first_numbers(std::size_t count) {
  Indices numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

/// Each begins at the corner that makes it least, and they are sorted: equal for meshes that differ in nothing else.
std::vector<Triangle> canonical(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) t = std::min({t, Triangle{t[1], t[2], t[0]}, Triangle{t[2], t[0], t[1]}});
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Triangle> decoded(const Strips& strips) {
  std::vector<Triangle> all;
  for (const Indices& strip : strips.strips) {
    const auto triangles = triangles_of_strip(strip);
    all.insert(all.end(), triangles.begin(), triangles.end());
  }
  return all;
}

// rows: PG-36 PG-37
TEST(Strips, CodesGiveBackWhatTheyEncode) {
  for (std::size_t n = 1; n < 40; ++n) {
    const auto in_strip = triangles_of_strip(first_numbers(n + 2));
    EXPECT_EQ(strip_of(in_strip), first_numbers(n + 2));
    const auto in_fan = triangles_of_fan(first_numbers(n + 2));
    EXPECT_EQ(fan_of(in_fan), first_numbers(n + 2));
    const auto quads = quads_of_strip(first_numbers(2 * n + 2));
    EXPECT_EQ(strip_of(quads), first_numbers(2 * n + 2));
    EXPECT_EQ(triangles_of_list(list_of(in_strip)), in_strip);
    EXPECT_EQ(quads_of_list(list_of(quads)), quads);
    EXPECT_EQ(list_of(in_strip).size(), 3 * n);
    EXPECT_EQ(list_of(quads).size(), 4 * n);
  }
}

TEST(Strips, TheFirstCornerOfAPieceDoesNotMatter) {
  auto strip = triangles_of_strip(first_numbers(9));
  auto quads = quads_of_strip(first_numbers(12));
  test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    for (Triangle& t : strip) std::rotate(t.begin(), t.begin() + static_cast<int>(random() % 3), t.end());
    for (Quad& q : quads) std::rotate(q.begin(), q.begin() + static_cast<int>(random() % 4), q.end());
    EXPECT_EQ(strip_of(strip), first_numbers(9));
    EXPECT_EQ(strip_of(quads), first_numbers(12));
  }
}

TEST(Strips, WhatIsNoStripIsRefused) {
  const std::vector<Triangle> apart = {{0, 1, 2}, {3, 4, 5}}, folded = {{0, 1, 2}, {1, 2, 3}};
  EXPECT_EQ(strip_of(apart), std::nullopt);
  EXPECT_EQ(fan_of(apart), std::nullopt);
  EXPECT_EQ(strip_of(folded), std::nullopt);  // the side 1 2 runs the same way twice
  const auto fan = triangles_of_fan(first_numbers(8));
  EXPECT_EQ(strip_of(fan), std::nullopt);
  const std::vector<Quad> twisted = {{0, 1, 3, 2}, {3, 2, 4, 5}};
  EXPECT_EQ(strip_of(twisted), std::nullopt);
  EXPECT_EQ(strip_of(std::vector<Triangle>{}), Indices{});
}

TEST(Strips, IncompletePiecesAreLeftOut) {
  EXPECT_TRUE(triangles_of_strip(first_numbers(2)).empty());
  EXPECT_TRUE(triangles_of_fan({}).empty());
  EXPECT_EQ(triangles_of_list(first_numbers(8)).size(), 2u);
  EXPECT_EQ(quads_of_list(first_numbers(8)).size(), 2u);
  EXPECT_EQ(quads_of_strip(first_numbers(7)).size(), 2u);
}

TEST(Strips, CoverEveryTriangleOnceWithItsOrientation) {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Region region =
        test::star_with_holes(random, 3 + static_cast<std::size_t>(i), static_cast<std::size_t>(i % 4), 7);
    const auto triangles = delaunay(region);
    const Strips strips = cover_with_strips(triangles);
    EXPECT_EQ(canonical(decoded(strips)), canonical(triangles));
    EXPECT_EQ(strips.vertex_count(), triangles.size() + 2 * strips.strips.size());
    EXPECT_LE(strips.vertex_count(), 3 * triangles.size());
  }
}

TEST(Strips, AGridTakesFewNumbers) {
  const std::uint32_t size = 32;
  std::vector<Triangle> triangles;
  for (std::uint32_t y = 0; y < size; ++y)
    for (std::uint32_t x = 0; x < size; ++x) {
      const std::uint32_t a = y * (size + 1) + x, b = a + 1, c = a + size + 1, d = c + 1;
      triangles.push_back({a, b, c});
      triangles.push_back({b, d, c});
    }
  const Strips strips = cover_with_strips(triangles);
  EXPECT_EQ(canonical(decoded(strips)), canonical(triangles));
  EXPECT_LT(strips.vertex_count(), triangles.size() * 5 / 4);
}

TEST(Strips, AnyTrianglesAreCovered) {
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Triangle> triangles(random() % 30);
    for (Triangle& t : triangles)
      for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(random() % 8);
    EXPECT_EQ(canonical(decoded(cover_with_strips(triangles))), canonical(triangles));
  }
  EXPECT_TRUE(cover_with_strips({}).strips.empty());
}

}  // namespace
}  // namespace lambert::polygon
