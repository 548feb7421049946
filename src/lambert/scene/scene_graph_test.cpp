#include "lambert/scene/scene_graph.h"

#include "lambert/base/error.h"
#include "lambert/scene/scene_test_tools.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambert {
namespace {

/// A root with two arms; a unit box at the end of each.
struct Arms {
  SceneGraph graph;
  NodeId left, right, left_hand, right_hand;
  Arms() {
    const Surface box_surface{.geometry = graph.add_geometry(box(Vec3(-0.5f), Vec3(0.5f))),
                              .material = add_grey(graph)};
    left = graph.add_node(graph.root(), "left", Transform::translate({-10, 0, 0}));
    right = graph.add_node(graph.root(), "right", Transform::translate({10, 0, 0}));
    left_hand = graph.add_node(left, "left hand", Transform::translate({-1, 0, 0}));
    right_hand = graph.add_node(right, "right hand", Transform::translate({1, 0, 0}));
    graph.add_surface(left_hand, box_surface);
    graph.add_surface(right_hand, box_surface);
  }
  std::size_t recomputed_for(NodeId n) {
    const std::size_t before = graph.bounds_recomputed();
    graph.world_bounds(n);
    return graph.bounds_recomputed() - before;
  }
};

void expect_box(const Bounds3& box, Vec3 min, Vec3 max) {
  EXPECT_LT(length(box.min - min), 1e-5f);
  EXPECT_LT(length(box.max - max), 1e-5f);
}

// rows: PG-48
TEST(SceneGraph, BoxesHoldWhatIsBelow) {
  Arms a;
  expect_box(a.graph.world_bounds(a.graph.root()), {-11.5f, -0.5f, -0.5f}, {11.5f, 0.5f, 0.5f});
  expect_box(a.graph.world_bounds(a.left), {-11.5f, -0.5f, -0.5f}, {-10.5f, 0.5f, 0.5f});
  EXPECT_TRUE(SceneGraph().world_bounds(0).empty());
}

// rows: PG-48
TEST(SceneGraph, BoxesAreRecomputedOnlyWhereDirty) {
  Arms a;
  EXPECT_EQ(a.recomputed_for(a.graph.root()), 5u);
  EXPECT_EQ(a.recomputed_for(a.graph.root()), 0u);

  // A hand moves: its own box, its arm's and the root's; the other arm is left alone.
  a.graph.set_local_transform(a.left_hand, Transform::translate({-2, 0, 0}));
  EXPECT_EQ(a.recomputed_for(a.right), 0u);
  EXPECT_EQ(a.recomputed_for(a.graph.root()), 3u);
  expect_box(a.graph.world_bounds(a.graph.root()), {-12.5f, -0.5f, -0.5f}, {11.5f, 0.5f, 0.5f});

  // An arm moves with its hand. Asking below first leaves less to do above.
  a.graph.set_local_transform(a.right, Transform::translate({20, 0, 0}));
  EXPECT_EQ(a.recomputed_for(a.right_hand), 1u);
  EXPECT_EQ(a.recomputed_for(a.graph.root()), 2u);
  expect_box(a.graph.world_bounds(a.graph.root()), {-12.5f, -0.5f, -0.5f}, {21.5f, 0.5f, 0.5f});
}

// rows: PG-48
TEST(SceneGraph, ManyMovesBeforeAQuestionCostOneAnswer) {
  Arms a;
  a.graph.world_bounds(a.graph.root());
  for (int i = 0; i < 100; ++i)
    a.graph.set_local_transform(a.left, Transform::translate({-10, static_cast<float>(i), 0}));
  EXPECT_EQ(a.recomputed_for(a.graph.root()), 3u);
  EXPECT_FLOAT_EQ(a.graph.world_bounds(a.left).max.y, 99.5f);
}

// rows: PG-48
TEST(SceneGraph, NewNodesAndSurfacesMarkTheBoxesAbove) {
  Arms a;
  a.graph.world_bounds(a.graph.root());
  const NodeId finger = a.graph.add_node(a.left_hand, "finger", Transform::translate({0, 5, 0}));
  a.graph.add_surface(finger, a.graph.surfaces(a.left_hand)[0]);
  EXPECT_EQ(a.recomputed_for(a.graph.root()), 4u);
  expect_box(a.graph.world_bounds(a.graph.root()), {-11.5f, -0.5f, -0.5f}, {11.5f, 5.5f, 0.5f});
}

// Random moves and questions, against boxes made from scratch.
// rows: PG-48
TEST(SceneGraph, LazyBoxesAreThoseMadeFromScratch) {
  Random random(1);
  SceneGraph graph;
  const Surface ball{.geometry = graph.add_geometry(Shape(Sphere{})), .material = add_grey(graph)};
  for (int i = 0; i < 40; ++i) {
    const auto parent = static_cast<NodeId>(random.number() * static_cast<float>(graph.node_count()));
    const NodeId n = graph.add_node(parent, "n" + std::to_string(i), random_placement(random, i % 2 == 0));
    if (i % 3 == 0) graph.add_surface(n, ball);
  }
  const auto some_node = [&] { return static_cast<NodeId>(random.number() * static_cast<float>(graph.node_count())); };
  for (int step = 0; step < 500; ++step) {
    graph.set_local_transform(some_node(), random_placement(random, false));
    const NodeId asked = some_node();
    Bounds3 expected;
    for (NodeId n = 0; n < graph.node_count(); ++n) {
      Transform world;
      bool below = false;
      for (NodeId at = n; at != no_node; at = graph.parent(at)) {
        world = graph.local_transform(at) * world;
        below |= at == asked;
      }
      if (below && !graph.surfaces(n).empty()) expected.add(world.bounds(Sphere{}.bounds()));
    }
    const Bounds3 lazy = graph.world_bounds(asked);
    ASSERT_EQ(lazy.empty(), expected.empty());
    if (expected.empty()) continue;
    const float tolerance = 1e-4f * (1 + expected.radius() + length(expected.centre()));
    ASSERT_LT(length(lazy.min - expected.min), tolerance);
    ASSERT_LT(length(lazy.max - expected.max), tolerance);
  }
}

TEST(SceneGraph, WorldTransformsGoFromTheRootDown) {
  SceneGraph graph;
  const NodeId a = graph.add_node(graph.root(), "a", Transform::rotate(degrees(90), {0, 0, 1}));
  const NodeId b = graph.add_node(a, "b", Transform::translate({1, 0, 0}));
  EXPECT_LT(length(graph.world_transform(b).point(Vec3(0)) - Vec3(0, 1, 0)), 1e-6f);
  graph.set_local_transform(a, Transform::scale(Vec3(3)));
  EXPECT_LT(length(graph.world_transform(b).point(Vec3(0)) - Vec3(3, 0, 0)), 1e-6f);
  EXPECT_EQ(graph.node_name(b), "b");
  EXPECT_EQ(graph.parent(b), a);
}

TEST(SceneGraph, RefusesTransformsThatAreNotFinite) {
  SceneGraph graph;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  try {
    graph.add_node(graph.root(), "broken", Transform::translate({0, nan, 0}));
    FAIL() << "a transform with a NaN was taken";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("'broken'"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace lambert
