#pragma once
#include "lambert/image/probe/layout.h"

#include <array>
#include <vector>

namespace lambert::probe {

/// Irradiance from all around by full quadrature: E(n) = ∫ L(d) max(0, n·d) dω, per channel of colour (grey counts as
/// three equal ones). Moments ∫ L d dω of ever larger blocks of texels stand in a tree: blocks that a surface sees
/// wholly give n · moment, which is exact; blocks on its horizon are split. Of maps above 2^19 texels the leaves are
/// blocks. A constant environment is right to 1e-4 (3e-4 on disks), a cosine
/// lobe on lat-long maps and cubes of 128 rows too. Values must be finite.
class Irradiance {
 public:
  explicit Irradiance(const Probe& probe);
  Rgb operator()(Vec3 normal) const;  ///< W/m² for radiance in W/(m² sr); `normal` is unit

 private:
  struct Node {
    std::array<Vec3, 3> moment;  // of r, g, b
    Vec3 axis;                   // of a cone about all its directions
    float cos_radius, sin_radius;
    std::uint32_t children;  // the first of four, 0 for leaves
  };
  void add(std::uint32_t node, Vec3 normal, std::array<double, 3>& sum) const;
  std::vector<Node> nodes_;
  std::uint32_t roots_ = 0;
};

/// E / π over all directions, as a map of the same kind as `probe` but `rows` high (lat-long maps are twice as wide):
/// what a white diffuse surface of that normal radiates. A constant environment stays what it is.
Probe diffuse_map(const Probe& probe, int rows);

}  // namespace lambert::probe
