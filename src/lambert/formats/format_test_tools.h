#pragma once
/// What tests of the readers share.

#include "damage.h"
#include "lambert/base/error.h"
#include "lambert/formats/readers.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lambert {

inline bool has_note(const Notes& notes, std::string_view part) {
  for (const auto& [note, count] : notes.counts()) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

/// The surfaces of all nodes in order, with their nodes.
struct Shown {
  NodeId node;
  Surface surface;
};
inline std::vector<Shown> shown(const SceneGraph& graph) {
  std::vector<Shown> all;
  for (NodeId n = 0; n < graph.node_count(); ++n) {
    for (const Surface& s : graph.surfaces(n)) all.push_back({n, s});
  }
  return all;
}
template <class T>
const T& geometry_as(const SceneGraph& graph, const Surface& s) {
  return std::get<T>(graph.geometry(s.geometry));
}
template <class T>
const T& shape_as(const SceneGraph& graph, const Surface& s) {
  return std::get<T>(geometry_as<Shape>(graph, s));
}
/// The material of the first surface.
inline const Material& first_material(const SceneGraph& graph) {
  return graph.materials[shown(graph).at(0).surface.material];
}

inline void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-5f) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}
inline void expect_near(Rgb a, Rgb b, float tolerance = 1e-5f) {
  expect_near(Vec3(a.r, a.g, a.b), Vec3(b.r, b.g, b.b), tolerance);
}

}  // namespace lambert
