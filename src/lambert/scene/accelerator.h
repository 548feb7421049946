#pragma once
#include "lambert/scene/compiled.h"

namespace lambert {

/// Ray queries over all surfaces of a scene. The one place that knows Embree.
class Accelerator {
 public:
  /// Keeps references to `scene`, which must stay where it is.
  Accelerator(const Scene::State& scene, bool robust);
  ~Accelerator();
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  bool intersect(const Ray& ray, Hit& hit) const;
  bool occluded(const Ray& ray) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace lambert
