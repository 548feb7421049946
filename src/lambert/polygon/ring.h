#pragma once
/// Polygons as values: what every algorithm of the plane takes and returns. Coordinates are doubles with y up.

#include "lambert/base/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambert::polygon {

/// A closed chain of vertices: edge i joins vertex i to vertex i + 1, and the last vertex to the first, which is not
/// repeated at the end (PG-03).
using Ring = std::vector<Vec2d>;

/// Rings in no order and of any orientation, which may cross themselves and each other; a FillRule says what they
/// enclose.
using Rings = std::vector<Ring>;

/// What lies inside when rings wind around a point.
enum class FillRule : std::uint8_t {
  even_odd,  ///< an odd number of times
  non_zero,  ///< a number of times other than 0, clockwise counted as -1
  positive,  ///< counter-clockwise on the whole: more than 0 times
  negative,  ///< clockwise on the whole: fewer than 0 times
};

/// One connected piece of the plane: a counter-clockwise outer ring and clockwise holes inside it.
struct Region {
  Ring outer;
  Rings holes;
  bool operator==(const Region&) const = default;
};

/// Pieces whose interiors are disjoint.
using Regions = std::vector<Region>;

inline std::size_t next_index(std::size_t i, std::size_t size) { return i + 1 == size ? 0 : i + 1; }
inline std::size_t previous_index(std::size_t i, std::size_t size) { return (i == 0 ? size : i) - 1; }

/// The rings of a region or of several, outer rings first in each.
Rings rings_of(const Region& region);
Rings rings_of(const Regions& regions);

/// Half the sum of cross products: positive when counter-clockwise; of a ring that crosses itself, the sum of area
/// times winding number. Relative to the first vertex, so that rings far from the origin lose no digits.
/// Infinite or 0 only where the area itself is too large or too small for a double.
double signed_area(const Ring& ring);
double signed_area(const Rings& rings);
double area(const Region& region);
double area(const Regions& regions);

/// signed_area() in numbers that hold the square of every double.
long double wide_signed_area(const Ring& ring);

/// The sum of the lengths of all edges, of any size.
double perimeter(const Rings& rings);

}  // namespace lambert::polygon
