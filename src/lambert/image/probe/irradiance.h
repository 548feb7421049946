#pragma once
#include "lambert/base/progress.h"
#include "lambert/image/probe/layout.h"

#include <array>
#include <vector>

namespace lambert::probe {

/// Irradiance from all around by full quadrature: E(n) = ∫ L(d) max(0, n·d) dω, per channel of colour (grey counts as
/// three equal ones). Moments ∫ L d dω of ever larger blocks of texels stand in a tree: blocks that a surface sees
/// wholly give n · moment, which is exact; blocks on its horizon are split. Texels that are wide (coarse maps, the rim
/// of a ball) are cut, and radiance in them is linear (linear_radiance.h). Of maps above 2^19 texels the leaves are
/// blocks. A constant environment is right to 1e-4 in every layout and size, L = a + b·d and lobes up to cos³ in every
/// layout of 64 rows or more (balls: 128) too, where texels are means over what they show. Values must be finite.
class Irradiance {
 public:
  explicit Irradiance(const Probe& probe);
  Rgb operator()(Vec3 normal) const;  ///< W/m² for radiance in W/(m² sr); `normal` is unit

  struct Node {
    std::array<Vec3, 3> moment{};  // of r, g, b
    Vec3 axis{0};                  // of a cone about all its directions
    float sin_radius = 0;          // of the cone; 2 when it is no cone below a hemisphere
    std::uint32_t size = 1;        // of its subtree, which follows it; 1 for leaves
  };

 private:
  std::vector<Node> nodes_;
};

/// E / π over all directions, as a map of the same kind as `probe` but `rows` high (lat-long maps are twice as wide):
/// what a white diffuse surface of that normal radiates. A constant environment stays what it is.
Probe diffuse_map(const Probe& probe, int rows, const FractionSink& progress = {});

}  // namespace lambert::probe
