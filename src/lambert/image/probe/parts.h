#pragma once
#include "lambert/image/probe/cell.h"

#include <array>

namespace lambert::probe {

/// The half angle of what may be taken for one direction, radians: cells that are wider are cut, at most so often.
inline constexpr float widest_part = 0.025f;
inline constexpr int deepest_cut = 11;

bool has_disk(const AnyProjection& projection);  ///< mirror balls and fisheyes

/// Near the rim of a disk a cell is long along the radius, which no side of it need follow: there rings cut it.
bool at_rim(const AnyProjection& projection, const Cell& cell);

/// Four parts of a cell: between rings at a rim, else quarters of its rectangle.
std::array<Cell, 4> parts(const AnyProjection& projection, const Cell& cell);

/// The corners of a cell, or what of the disk is nearest to them.
std::array<MapPoint, 4> corners(const AnyProjection& projection, int chart, const Cell& cell);

/// Of unit vectors, radians; by the chord, since acos has no digits for small angles.
float angle_between(Vec3 a, Vec3 b);

/// Of the cone about the cell's mean direction that reaches its corners, a little wider at a rim; π when directions
/// undo each other. `sums` are the cell's integrals.
float half_angle(const AnyProjection& projection, int chart, const Cell& cell, const CellIntegrals& sums);

/// Cuts a cell until its parts are narrow, and calls f(part, its integrals) for each that shows anything.
template <class F>
void for_each_part(const AnyProjection& projection, int chart, const Cell& cell, const F& f, int cuts = 0) {
  const CellIntegrals sums = integrals(projection, chart, cell);
  if (!(sums.solid_angle > 0)) return;
  if (cuts == deepest_cut || half_angle(projection, chart, cell, sums) <= widest_part) return f(cell, sums);
  for (const Cell& part : parts(projection, cell)) for_each_part(projection, chart, part, f, cuts + 1);
}

}  // namespace lambert::probe
