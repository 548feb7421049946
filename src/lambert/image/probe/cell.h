#pragma once
#include "lambert/image/probe/projection.h"

namespace lambert::probe {

/// A rectangle of a chart, within [0,1]²; of a disk only what lies between two rings.
struct Cell {
  double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
  double theta0 = 0, theta1 = 4;  ///< angles of the rings from the axis, radians
};

struct CellIntegrals {
  double solid_angle = 0;  ///< ∫ dω, sr
  Vec3d moment{0};         ///< ∫ d dω
};

/// Where a cell of a disk lies: its nearest radius, and the angles from the axis between which it is, rings included.
struct DiskReach {
  double nearest, theta0, theta1;
};
DiskReach disk_reach(const AnyProjection& projection, const Cell& cell);

/// Over what the cell shows. Closed forms for lat-long maps, and of a cube's and an equal-area map's solid angles; what
/// is left by Gauss' rule with 2x2 points. At the rim of a disk, which cuts cells and where directions crowd without
/// bound, by rings about the disk's centre: the arc of a ring in a cell is known, and over the ring's angle θ from the
/// axis nothing is singular. Relative errors are below 1e-5 for cells that span less than 0.1 rad.
CellIntegrals integrals(const AnyProjection& projection, int chart, const Cell& cell);

/// The integrals over a cell of a lat-long map are products of what its rows give and what its columns give.
/// Of a row from one polar angle θ (from +y, radians) to another, per radian of longitude.
struct LatLongRow {
  double solid_angle;  ///< ∫ sin θ dθ
  double across;       ///< ∫ sin² θ dθ: what the row gives to the moment's x and z
  double along;        ///< ∫ sin θ cos θ dθ: to its y
};
/// Of a column from one longitude φ to another.
struct LatLongColumn {
  double width;  ///< ∫ dφ, radians
  double x, z;   ///< ∫ d_x dφ and ∫ d_z dφ of the unit directions d on the horizon
};
/// Of the cell's v0 to v1, and of its u0 to u1.
LatLongRow lat_long_row(const Cell& cell);
LatLongColumn lat_long_column(const LatLong& map, const Cell& cell);
inline CellIntegrals integrals(const LatLongRow& row, const LatLongColumn& column) {
  return {column.width * row.solid_angle, {column.x * row.across, column.width * row.along, column.z * row.across}};
}

}  // namespace lambert::probe
