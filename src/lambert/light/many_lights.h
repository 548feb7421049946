#pragma once
/// A scene of many lights of all kinds with a place, for the tests of how one of them is chosen.

#include "lambert/base/hash.h"
#include "lambert/light/any_light.h"

#include <vector>

namespace lambert {

/// Numbers in [0,1) by index, the same in every run.
class TestNumbers {
 public:
  explicit TestNumbers(std::uint64_t seed) : seed_(seed) {}
  float next() { return hash_to_float(hash_values(seed_, count_++)); }
  Vec3 next_in_cube() { return 2.0f * Vec3{next(), next(), next()} - 1.0f; }
  Vec3 next_direction() {
    const float z = 1 - 2 * next(), phi = 2 * pi * next(), r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::uint64_t seed_, count_ = 0;
};

/// `count` points, spots, triangles, quads and spheres in a cube of side 20, with powers over three decades.
inline std::vector<Light> many_lights(int count) {
  TestNumbers r(7);
  std::vector<Light> lights;
  for (int i = 0; i < count; ++i) {
    const Vec3 at = 10.0f * r.next_in_cube();
    const Rgb strength(std::pow(10.0f, 3 * r.next()));
    const Emission emission{{strength}, r.next() < 0.3f, true};
    switch (i % 5) {
      case 0: lights.push_back(PointLight{at, strength}); break;
      case 1: lights.push_back(SpotLight{at, r.next_direction(), strength, 0.9f, 0.5f}); break;
      case 2: {
        const Vec3 a = r.next_in_cube(), b = r.next_in_cube();
        lights.push_back(TriangleLight{{at, at + a, at + b}, {}, emission});
        break;
      }
      case 3: {
        const Vec3 a = r.next_in_cube(), b = cross(a, r.next_direction());
        lights.push_back(QuadLight(at, a, b, {}, emission));
        break;
      }
      default: {
        const auto sphere = std::make_shared<const Shape>(Sphere{0.3f, -0.3f, 0.3f});
        lights.push_back(ShapeLight{sphere, Transform::translate(at), false, emission});
      }
    }
  }
  return lights;
}

}  // namespace lambert
