#pragma once
#include "lambert/polygon/box.h"
#include "lambert/polygon/locate/edge_list.h"

#include <limits>
#include <optional>

namespace lambert::polygon {

/// The second level of PointLocator: cells that many edges pass, divided into strips along the edges' mean direction,
/// so that edges side by side, like needles, fall into few strips each.
class LocatorStrips {
 public:
  /// A winding number that could not be found: the point meant to have it lies on an edge.
  static constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::min();

  /// Divides the cell, `cell` with everything within `slack` of it, given all edges that come into it, each once, and a
  /// point of it that lies on none; none when that would not help. Computed coordinates must be good to a part of
  /// slack.
  std::optional<std::uint32_t> divide(const EdgeList& edges, const Box2& cell, double slack,
                                      std::span<const std::uint32_t> inside, Vec2d reference, std::int32_t winding);

  /// At a point of the cell that divide() returned the number of; the number may be `unknown`.
  Winding winding(const EdgeList& edges, std::uint32_t divided, Vec2d p) const {
    const Division& division = divisions_[divided];
    const std::uint32_t number = division.strip(p), s = division.first + number;
    const Strip strip = strips_[s];
    if (strip.winding == unknown) return {unknown, false};
    return edges.winding_from(division.reference(number), strip.winding, p,
                              {edges_.data() + strip.first, edges_.data() + strips_[s + 1].first});
  }

 private:
  struct Division {
    Vec2d centre, across;  ///< `across` times a way is its part across the strips, in strips
    Vec2d step;            ///< along the cell's diagonal from strip to strip
    double count;
    std::uint32_t first;  ///< strip

    std::uint32_t strip(Vec2d p) const { return strip_at(dot(p - centre, across)); }
    std::uint32_t strip_at(double place) const {
      const double number = place + 0.5 * count;
      return static_cast<std::uint32_t>(number > 0 ? (number < count - 1 ? number : count - 1) : 0.0);
    }
    /// Not in the middle, where an edge is likelier to be.
    Vec2d reference(std::uint32_t strip) const { return centre + (strip + 0.5137 - 0.5 * count) * step; }
  };
  struct Strip {
    std::uint32_t first;  ///< of its edges in edges_; they end where those of the next begin
    std::int32_t winding;
  };

  void list_edges(const Division& division, std::span<const std::uint32_t> inside,
                  const std::vector<std::pair<double, double>>& places);
  void find_windings(const EdgeList& edges, const Division& division, Vec2d reference, std::int32_t winding);

  std::vector<Division> divisions_;
  std::vector<Strip> strips_{Strip{0, 0}};  ///< and one more
  std::vector<std::uint32_t> edges_;
};

}  // namespace lambert::polygon
