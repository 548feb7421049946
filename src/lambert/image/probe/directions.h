#pragma once
#include "lambert/base/vec.h"

#include <cstddef>
#include <vector>

namespace lambert::probe {

/// Many directions, coordinate by coordinate, so that loops over them run eight at a time.
struct Directions {
  std::vector<float> x, y, z;

  std::size_t size() const { return x.size(); }
  void resize(std::size_t count) { x.resize(count), y.resize(count), z.resize(count); }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, Vec3 d) { x[i] = d.x, y[i] = d.y, z[i] = d.z; }
};

}  // namespace lambert::probe
