/// What holds for every shape.

#include "lambert/geometry/shape.h"

#include "lambert/geometry/shape_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <ostream>

namespace lambert {
namespace {

struct Example {
  const char* name;
  Shape shape;
};

void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

std::vector<Vec3> tilted_arrow() {
  std::vector<Vec3> corners;
  for (const Vec2 p : {Vec2(0, 0), Vec2(3, 0), Vec2(3, 2), Vec2(1.5f, 0.5f), Vec2(0, 2)})
    corners.emplace_back(p.x, p.y, 0.5f * p.x - 0.8f * p.y + 1);
  return corners;
}

ConvexPolyhedron cut_cube() {
  return ConvexPolyhedron({{{1, 0, 0}, 1},
                           {{-1, 0, 0}, 1},
                           {{0, 1, 0}, 1},
                           {{0, -1, 0}, 1},
                           {{0, 0, 1}, 1},
                           {{0, 0, -1}, 1},
                           {{1, 1, 1}, 1.5f}});
}

std::vector<Example> examples() {
  return {{"sphere", Sphere{}},
          {"sphere_part", Sphere{.radius = 2, .z_min = -1, .z_max = 1.8f, .phi_max = 4}},
          {"sphere_cap", Sphere{.radius = 3, .z_min = 2, .z_max = 3, .phi_max = 1}},
          {"disk", Disk{.height = 1, .radius = 2}},
          {"disk_part", Disk{.height = -1, .radius = 2, .inner_radius = 0.7f, .phi_max = 3.5f}},
          {"tube", Cylinder{}},
          {"tube_part", Cylinder{.radius = 1, .z_min = 0, .z_max = 3, .phi_max = 2}},
          {"closed_cylinder", Cylinder{.radius = 1.5f, .z_min = -1, .z_max = 0, .caps = true}},
          {"closed_cylinder_part", Cylinder{.radius = 1, .z_min = 1, .z_max = 2, .phi_max = 5, .caps = true}},
          {"polygon", Polygon(tilted_arrow())},
          {"convex_polyhedron", cut_cube()}};
}

class EveryShape : public testing::TestWithParam<Example> {
 protected:
  std::vector<ShapeHit> hits(const Ray& ray) const {
    return std::visit([&](const auto& s) { return all_hits(s, ray); }, GetParam().shape);
  }
  std::optional<ShapeHit> intersect(const Ray& ray) const {
    return std::visit([&](const auto& s) { return s.intersect(ray); }, GetParam().shape);
  }
  Bounds3 bounds() const {
    return std::visit([](const auto& s) { return s.bounds(); }, GetParam().shape);
  }
  float area() const {
    return std::visit([](const auto& s) { return s.area(); }, GetParam().shape);
  }
  ShapeSample sample(Vec2 u) const {
    return std::visit([&](const auto& s) { return s.sample(u); }, GetParam().shape);
  }
  Ray line(Random& random) const { return random_line(random, bounds().centre(), bounds().radius()); }
};

constexpr int cells = 5;

std::size_t cell_of(const Bounds3& box, Vec3 p) {
  const Vec3 size = glm::max(box.diagonal(), Vec3(1e-3f));
  const Vec3i c = glm::clamp(Vec3i((p - box.min) / size * static_cast<float>(cells)), Vec3i(0), Vec3i(cells - 1));
  return static_cast<std::size_t>((c.z * cells + c.y) * cells + c.x);
}

using Counts = std::array<double, cells * cells * cells>;

/// Two-sample chi-square statistic (Press et al., "Numerical Recipes", 14.3).
statistics::TestResult same_distribution(const Counts& a, const Counts& b, int tests) {
  double sum_a = 0, sum_b = 0, statistic = 0;
  int used = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum_a += a[i], sum_b += b[i];
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] + b[i] == 0) continue;
    const double difference = std::sqrt(sum_b / sum_a) * a[i] - std::sqrt(sum_a / sum_b) * b[i];
    statistic += difference * difference / (a[i] + b[i]);
    ++used;
  }
  const double p = statistics::chi_square_survival(statistic, used - 1);
  return {p, statistic, used - 1, p >= statistics::sidak(statistics::significance, tests), "p = " + std::to_string(p)};
}

/// Lines at random meet a surface evenly over its area: so intersect(), area() and sample() must tell the same.
TEST_P(EveryShape, AreaAndSamplesAgreeWithRandomLines) {
  constexpr int count = 60000;
  Random random(1);
  const Bounds3 box = bounds();
  Counts hit_counts{}, sample_counts{};
  double sum = 0, sum_of_squares = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<ShapeHit> found = hits(line(random));
    for (const ShapeHit& h : found) ++hit_counts[cell_of(box, h.position)];
    ++sample_counts[cell_of(box, sample(random.square()).position)];
    const auto n = static_cast<double>(found.size());
    sum += n, sum_of_squares += n * n;
  }
  const double mean = sum / count, variance = sum_of_squares / count - mean * mean;
  const double sphere_radius = static_cast<double>(box.radius());
  const double expected = static_cast<double>(area()) / (2 * std::numbers::pi * sphere_radius * sphere_radius);
  const int tests = static_cast<int>(2 * examples().size());
  const auto area_test = statistics::z_test(mean, std::sqrt(variance / count), expected, tests);
  EXPECT_TRUE(area_test) << area_test.message << ", mean hits " << mean << ", expected " << expected;
  const auto same = same_distribution(hit_counts, sample_counts, tests);
  EXPECT_TRUE(same) << same.message;
}

TEST_P(EveryShape, SamplesLieOnTheSurface) {
  Random random(2);
  int missed = 0;
  for (int i = 0; i < 2000; ++i) {
    const ShapeSample s = sample(random.square());
    EXPECT_NEAR(length(s.normal), 1, 1e-5);
    const auto hit = intersect({.origin = s.position + 1e-2f * s.normal, .direction = -s.normal, .t_max = 2e-2f});
    if (!hit) {
      ++missed;  // within rounding of an edge
      continue;
    }
    EXPECT_LT(length(hit->position - s.position), 1e-5f);
    EXPECT_LT(length(hit->normal - s.normal), 1e-3f);
    EXPECT_NEAR(hit->uv.y, s.uv.y, 1e-3);
  }
  EXPECT_LE(missed, 2);
}

TEST_P(EveryShape, BoundsHoldAllPointsClosely) {
  Random random(3);
  const Bounds3 box = bounds();
  Bounds3 seen;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = sample(random.square()).position;
    EXPECT_TRUE(box.contains(p));
    seen.add(p);
    for (const ShapeHit& h : hits(line(random))) EXPECT_TRUE(box.contains(h.position));
  }
  const Vec3 spare = glm::max(seen.min - box.min, box.max - seen.max);
  EXPECT_LT(std::max({spare.x, spare.y, spare.z}), 0.05f * length(box.diagonal()));
}

TEST_P(EveryShape, HitsLieOnTheRayWithUvInTheSquare) {
  Random random(4);
  for (int i = 0; i < 5000; ++i) {
    const Ray ray = line(random);
    for (const ShapeHit& h : hits(ray)) {
      EXPECT_LT(length(ray.at(h.t) - h.position), 1e-5f * (1 + h.t));
      EXPECT_NEAR(length(h.normal), 1, 1e-5);
      EXPECT_GE(std::min(h.uv.x, h.uv.y), 0);
      EXPECT_LE(std::max(h.uv.x, h.uv.y), 1);
    }
  }
}

TEST_P(EveryShape, RangeOfTheRayIsKept) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    Ray ray = line(random);
    const auto first = intersect(ray);
    if (!first) continue;
    ray.t_max = first->t;
    EXPECT_EQ(intersect(ray)->t, first->t);
    ray.t_max = std::nextafter(first->t, 0.0f);
    EXPECT_FALSE(intersect(ray));
  }
}

/// dpdu is the derivative of the position by u with v held.
TEST_P(EveryShape, DpduMovesU) {
  Random random(6);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    for (const ShapeHit& h : hits(line(random))) {
      constexpr float step = 1e-3f;
      EXPECT_NEAR(dot(normalize(h.dpdu), h.normal), 0, 1e-4);
      if (h.uv.x > 0.99f || length(h.dpdu) < 0.1f) continue;
      const Vec3 moved = h.position + step * h.dpdu;
      const auto there = intersect({.origin = moved + 1e-2f * h.normal, .direction = -h.normal, .t_max = 2e-2f});
      if (!there || dot(there->normal, h.normal) < 0.99f) continue;
      EXPECT_NEAR(there->uv.x - h.uv.x, step, 2e-5);
      EXPECT_NEAR(there->uv.y, h.uv.y, 1e-3);
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

/// From 10,000 radii away the hit is still on the surface, though t can only be given to a part in 10⁷.
TEST_P(EveryShape, FarRaysHitTheSamePlaces) {
  Random random(7);
  const float far = 1e4f * bounds().radius();
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const ShapeSample s = sample(random.square());
    if (std::min({s.uv.x, s.uv.y, 1 - s.uv.x, 1 - s.uv.y}) < 0.02f) continue;
    const Vec3 d = normalize(s.normal + 0.5f * random.direction());
    const auto hit = intersect({.origin = s.position + far * d, .direction = -d});
    if (!hit || dot(hit->normal, s.normal) < 0.99f) continue;
    const auto again = intersect({.origin = hit->position + hit->normal, .direction = -hit->normal});
    if (!again) continue;
    EXPECT_LT(std::abs(dot(again->position - hit->position, hit->normal)), 2e-6f * (1 + length(hit->position)));
    EXPECT_LT(length(hit->position - s.position), 1e-2f * bounds().radius());
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

TEST_P(EveryShape, NothingIsHitByRaysWithoutDirectionOrNumbers) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(intersect({.origin = {0.1f, 0.2f, 5}, .direction = Vec3(0)}));
  EXPECT_FALSE(intersect({.origin = Vec3(nan), .direction = {0, 0, 1}}));
  EXPECT_FALSE(intersect({.origin = Vec3(0), .direction = Vec3(nan)}));
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(examples()),
                         [](const auto& example) { return std::string(example.param.name); });

/// Closed shapes are entered against the normal and left along it, by turns.
TEST(ClosedShapes, NormalsPointOutward) {
  Random random(8);
  for (const Shape& shape : {Shape(Sphere{}), Shape(Cylinder{.caps = true}), Shape(cut_cube())}) {
    for (int i = 0; i < 5000; ++i) {
      const Ray ray = random_line(random, Vec3(0), 1.8f);
      const auto hits = std::visit([&](const auto& s) { return all_hits(s, ray); }, shape);
      ASSERT_TRUE(hits.empty() || hits.size() == 2);
      if (hits.empty()) continue;
      EXPECT_LE(dot(hits[0].normal, ray.direction), 0);
      EXPECT_GE(dot(hits[1].normal, ray.direction), 0);
    }
  }
}

TEST(ClosedShapes, RaysFromInsideHitOnceGoingOut) {
  Random random(9);
  for (const Shape& shape : {Shape(Sphere{}), Shape(Cylinder{.caps = true}), Shape(cut_cube())}) {
    for (int i = 0; i < 5000; ++i) {
      const Ray ray{.origin = random.cube(0.4f), .direction = random.direction()};
      const auto hits = std::visit([&](const auto& s) { return all_hits(s, ray); }, shape);
      ASSERT_EQ(hits.size(), 1u);
      EXPECT_GT(dot(hits[0].normal, ray.direction), 0);
    }
  }
}

}  // namespace
}  // namespace lambert
