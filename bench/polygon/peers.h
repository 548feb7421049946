#pragma once
/// The libraries that the booleans are measured against, one compile unit each, behind one signature.

#include "lambert/polygon/boolean/boolean.h"

#include <memory>
#include <string>
#include <vector>

namespace lambert::bench {

/// What one run of an operation took and made.
struct Run {
  double seconds = 0;
  double area = 0;
  std::size_t vertices = 0;
};

/// A pair of operands in a library's own types, ready to be run as often as wanted: turning our rings into those types
/// is no part of the measured time, reading the library's result is none either.
class Operands {
 public:
  virtual ~Operands() = default;
  virtual Run run(polygon::BooleanOp op) = 0;
};

/// Of a library that takes any operands.
template <class LibraryOperands>
std::unique_ptr<Operands> prepared(const polygon::Rings& subject, const polygon::Rings& clip) {
  return std::make_unique<LibraryOperands>(subject, clip);
}

struct Peer {
  std::string name;
  /// Null when the library cannot take the operands.
  std::unique_ptr<Operands> (*prepare)(const polygon::Rings& subject, const polygon::Rings& clip);
};

Peer lambert_peer();
/// Those that were found when the bench was configured.
std::vector<Peer> other_peers();

Peer clipper_peer();
Peer boost_peer();
Peer cgal_peer();

}  // namespace lambert::bench
