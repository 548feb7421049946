#pragma once
/// Meshes made by rule, with normals and texture coordinates, counter-clockwise seen from outside. Vertices along a
/// seam or at a pole have the same position to the last bit.

#include "lambert/geometry/mesh.h"

namespace lambert {

/// In the plane y = 0, centred, facing +y; `columns` by `rows` cells.
TriangleMesh grid(float width, float depth, int columns = 1, int rows = 1);
/// In the plane y = 0, facing +y; v from the rim to the centre.
TriangleMesh disk(float radius, int around);
/// Axis-aligned, 24 vertices, so that its edges are sharp.
TriangleMesh box(Vec3 min, Vec3 max);
/// Longitudes by latitudes, poles on the y axis; 2 * around * (along - 1) triangles.
TriangleMesh uv_sphere(float radius, int around, int along);
/// An icosahedron whose triangles are quartered `subdivisions` times: 20 * 4^subdivisions triangles of nearly equal
/// size. uv as on uv_sphere, with u above 1 beyond the seam.
TriangleMesh icosphere(float radius, int subdivisions);
/// About the y axis, from y = 0 (closed by a disk) to the apex at y = height.
TriangleMesh cone(float radius, float height, int around);
/// About the y axis.
TriangleMesh torus(float major_radius, float minor_radius, int around, int across);
/// The (p, q) torus knot on a torus of radii 2 and 1 about the z axis, its tube of radius 0.45; 2 * along * around
/// triangles.
TriangleMesh torus_knot(int p, int q, int along, int around);

}  // namespace lambert
