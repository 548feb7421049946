#pragma once
/// Degenerate operands for the booleans out of any bytes, and what must hold of their results. Shared by the fuzz
/// target and the stress program.

#include "lambert/polygon/boolean/boolean.h"

#include <cstdint>
#include <span>
#include <string>

namespace lambert::polygon {

struct BooleanCase {
  Rings subject, clip;
  FillRule rule = FillRule::even_odd;
};

/// Few small rings: on tiny integer grids, next to such grids by some units in the last place, on lines, or anywhere;
/// with repeated points and edges run back and forth; of scale 1, 1e-150, 1e150, 1e-300, or of a scale that changes
/// from point to point.
BooleanCase decode_case(std::span<const std::uint8_t> bytes);

/// What is wrong with the four operations on it, empty if nothing: every result is valid and comes back from
/// normalised() unchanged, symmetric operations are symmetric, areas agree with each other.
std::string find_fault(const BooleanCase& input);

/// As C++ that builds it, coordinates in hexadecimal.
std::string to_code(const BooleanCase& input);

}  // namespace lambert::polygon
