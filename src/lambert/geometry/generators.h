#pragma once
/// Meshes made by rule, with normals and texture coordinates, counter-clockwise seen from outside.

#include "lambert/geometry/mesh.h"

namespace lambert {

/// In the plane y = 0, centred, facing +y; `columns` by `rows` cells.
TriangleMesh grid(float width, float depth, int columns = 1, int rows = 1);
/// Axis-aligned, 24 vertices, so that its edges are sharp.
TriangleMesh box(Vec3 min, Vec3 max);
/// Longitudes by latitudes, poles on the y axis.
TriangleMesh uv_sphere(float radius, int around, int along);
/// About the y axis.
TriangleMesh torus(float major_radius, float minor_radius, int around, int across);
/// The (p, q) torus knot on a torus of radii 2 and 1, its tube of radius 0.45; 2 * along * around triangles.
TriangleMesh torus_knot(int p, int q, int along, int around);

}  // namespace lambert
