#include "lambert/light/light_tree.h"

#include "lambert/light/light_test_tools.h"
#include "lambert/light/many_lights.h"

#include <gtest/gtest.h>

#include <numeric>

namespace lambert {
namespace {

struct Scene {
  explicit Scene(int count) : lights(many_lights(count)) {
    for (const Light& l : lights) bounds.push_back(light_bounds(l, {}));
    std::vector<std::uint32_t> all(lights.size());
    std::iota(all.begin(), all.end(), 0u);
    tree = LightTree(bounds, std::move(all));
  }
  std::vector<Light> lights;
  std::vector<LightBounds> bounds;
  LightTree tree;
};

struct Place {
  Vec3 point, normal;
};
std::vector<Place> places(int count) {
  TestNumbers r(11);
  std::vector<Place> list;
  for (int i = 0; i < count; ++i) {
    const Vec3 point = 12.0f * r.next_in_cube();
    list.push_back({point, r.next_direction()});
  }
  return list;
}

double sum_of_probabilities(const Scene& scene, const Place& place) {
  double sum = 0;
  for (std::uint32_t l = 0; l < scene.lights.size(); ++l) {
    sum += static_cast<double>(scene.tree.probability(place.point, place.normal, l));
  }
  return sum;
}

TEST(LightTree, ProbabilitiesOfPointLightsAddUpToOne) {
  TestNumbers r(17);
  std::vector<LightBounds> bounds;
  std::vector<std::uint32_t> all;
  for (std::uint32_t l = 0; l < 333; ++l) {
    bounds.push_back(PointLight{10.0f * r.next_in_cube(), Rgb(0.1f + r.next())}.bounds({}));
    all.push_back(l);
  }
  const LightTree tree(bounds, all);
  for (const Place& place : places(100)) {
    double sum = 0;
    for (const std::uint32_t l : all) sum += static_cast<double>(tree.probability(place.point, place.normal, l));
    EXPECT_NEAR(sum, 1, 1e-4);
  }
}

// A branch all of whose lights face away swallows its share, once it is small enough to tell: so the sum may fall short
// of 1 by the probability of choosing nothing, and nothing that contributes is missing.
TEST(LightTree, ProbabilitiesAddUpToOneWithThatOfChoosingNone) {
  for (const int count : {2, 3, 17, 400}) {
    const Scene scene(count);
    for (const Place& place : places(40)) {
      constexpr int draws = 2000;
      int none = 0;
      for (int i = 0; i < draws; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / draws;
        if (!(scene.tree.choose(place.point, place.normal, u).probability > 0)) ++none;
      }
      // Per light the midpoints miss at most one of the draws.
      const double tolerance = static_cast<double>(count + 1) / draws + 1e-4;
      EXPECT_NEAR(sum_of_probabilities(scene, place) + static_cast<double>(none) / draws, 1, tolerance);
    }
  }
}

TEST(LightTree, ReportsTheProbabilityWithWhichItChooses) {
  const Scene scene(300);
  for (const Place& place : places(50)) {
    for (int i = 0; i < 100; ++i) {
      const auto c = scene.tree.choose(place.point, place.normal, (static_cast<float>(i) + 0.5f) / 100);
      if (c.probability > 0) {
        EXPECT_EQ(c.probability, scene.tree.probability(place.point, place.normal, c.light));
      }
    }
  }
}

TEST(LightTree, ALightThatContributesHasAChance) {
  const Scene scene(200);
  for (const Place& place : places(300)) {
    for (std::uint32_t l = 0; l < scene.lights.size(); ++l) {
      const auto s = sample_light(scene.lights[l], {}, place.point, Vec2(0.4f, 0.6f));
      const float cos = s ? std::abs(dot(s->wi, place.normal)) : 0;
      if (cos > 1e-3f) {
        EXPECT_GT(scene.tree.probability(place.point, place.normal, l), 0) << l;
      }
    }
  }
}

TEST(LightTree, LeavesOutLightsThatEmitNothing) {
  std::vector<LightBounds> bounds{light_bounds(PointLight{{}, Rgb(0)}, {}), light_bounds(PointLight{{}, Rgb(1)}, {})};
  const LightTree tree(bounds, {0, 1});
  EXPECT_EQ(tree.probability({1, 0, 0}, Vec3(0), 0), 0);
  EXPECT_EQ(tree.probability({1, 0, 0}, Vec3(0), 1), 1);
  EXPECT_TRUE(LightTree({bounds.data(), 1}, {0}).empty());
}

TEST(LightTree, TakesManyLightsInOnePlace) {
  const std::vector<LightBounds> bounds(1000, light_bounds(PointLight{}, {}));
  std::vector<std::uint32_t> all(bounds.size());
  std::iota(all.begin(), all.end(), 0u);
  const LightTree tree(bounds, all);
  EXPECT_NEAR(tree.probability({1, 2, 3}, {0, 1, 0}, 999), 1e-3f, 5e-4f);
}

}  // namespace
}  // namespace lambert
