#pragma once
/// Clipping of a closed chain of vertices by boundaries, each a machine of four states (Sutherland and Hodgman,
/// "Reentrant polygon clipping", CACM 17(1), 1974). It knows neither the dimension nor the attributes of a vertex:
/// points of the plane and vertices in homogeneous coordinates with colours go the same way.
///
/// The result is one chain; where it should be several they are joined by edges along the boundary (window_clip.h takes
/// them apart).

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace lambert::polygon {

/// What happened on the way to a vertex; `start` for the first, whose edge is the last to come.
enum class ClipState : std::uint8_t { start, stay_in, leave, stay_out, enter };

constexpr std::string_view name_of(ClipState state) {
  constexpr std::string_view names[] = {"start", "stay in", "leave", "stay out", "enter"};
  return names[static_cast<std::size_t>(state)];
}

/// side(v): positive inside, 0 on the boundary, which is kept, negative outside. crossing(a, b): where the edge between
/// two vertices on different sides meets the boundary; it must not depend on their order.
template <class Boundary, class Vertex>
concept ClipBoundary = requires(const Boundary& boundary, const Vertex& v) {
  { boundary.side(v) < 0 } -> std::convertible_to<bool>;
  { boundary.side(v) > 0 } -> std::convertible_to<bool>;
  { boundary.crossing(v, v) } -> std::convertible_to<Vertex>;
};

/// Keeps the vertices with distance(v) >= 0, for a distance that is linear in what mix(a, b, t) = a + t (b - a)
/// interpolates: all attributes and, in homogeneous coordinates, w. Mixes from the vertex inside, so that two polygons
/// with a common edge get the same crossing from the same boundary.
template <class Distance, class Mix>
struct PlaneBoundary {
  Distance distance;
  Mix mix;

  auto side(const auto& v) const { return distance(v); }
  auto crossing(const auto& a, const auto& b) const {
    const auto da = distance(a), db = distance(b);
    return da > db ? mix(a, b, da / (da - db)) : mix(b, a, db / (db - da));
  }
};
template <class Distance, class Mix>
PlaneBoundary(Distance, Mix) -> PlaneBoundary<Distance, Mix>;

/// One boundary, fed with a chain vertex by vertex.
template <class Vertex, ClipBoundary<Vertex> Boundary>
class ClipMachine {
 public:
  explicit ClipMachine(Boundary boundary) : boundary_(std::move(boundary)) {}

  /// Gives output(vertex) what the edge from the previous vertex to v adds to the result.
  template <class Output>
  ClipState next(const Vertex& v, Output&& output) {
    const Place place = place_of(v);
    if (!started_) {
      started_ = true;
      first_ = previous_ = v;
      first_place_ = previous_place_ = place;
      return ClipState::start;
    }
    return step(v, place, output);
  }

  /// The edge back to the first vertex; the machine is then as new. `start` when there was no vertex.
  template <class Output>
  ClipState close(Output&& output) {
    if (!started_) return ClipState::start;
    started_ = false;
    return step(first_, first_place_, output);
  }

 private:
  enum class Place : std::uint8_t { outside, on, inside };

  Place place_of(const Vertex& v) const {
    const auto side = boundary_.side(v);
    return side > 0 ? Place::inside : (side < 0 ? Place::outside : Place::on);
  }

  template <class Output>
  ClipState step(const Vertex& v, Place place, Output& output) {
    const bool was_out = previous_place_ == Place::outside, is_out = place == Place::outside;
    // A vertex on the boundary is its own crossing.
    if (was_out != is_out && previous_place_ != Place::on && place != Place::on)
      output(static_cast<Vertex>(boundary_.crossing(previous_, v)));
    if (!is_out) output(v);
    previous_ = v;
    previous_place_ = place;
    return was_out ? (is_out ? ClipState::stay_out : ClipState::enter)
                   : (is_out ? ClipState::leave : ClipState::stay_in);
  }

  Boundary boundary_;
  Vertex first_{}, previous_{};
  Place first_place_ = Place::outside, previous_place_ = Place::outside;
  bool started_ = false;
};

/// The chain, beginning after its first vertex, clipped by one boundary. O(n).
template <class Vertex, ClipBoundary<Vertex> Boundary>
std::vector<Vertex> clip_chain(std::span<const Vertex> chain, const Boundary& boundary) {
  std::vector<Vertex> kept;
  const auto keep = [&](const Vertex& v) { kept.push_back(v); };
  ClipMachine<Vertex, Boundary> machine(boundary);
  for (const Vertex& v : chain) machine.next(v, keep);
  machine.close(keep);
  return kept;
}

template <class Vertex>
struct ClippedChain {
  std::vector<Vertex> chain;
  std::size_t vertices_read = 0;  ///< from the given list and from lists between boundaries
};

/// One boundary after the other: each makes a list that the next one reads, with six planes of a view volume about six
/// times as many reads as vertices.
template <class Vertex, ClipBoundary<Vertex> Boundary>
ClippedChain<Vertex> clip_in_turn(std::span<const Vertex> chain, std::span<const Boundary> boundaries) {
  ClippedChain<Vertex> result{{chain.begin(), chain.end()}};
  for (const Boundary& boundary : boundaries) {
    result.vertices_read += result.chain.size();
    result.chain = clip_chain(std::span<const Vertex>(result.chain), boundary);
  }
  return result;
}

/// Machines in a row: what one puts out goes to the next at once. The given list is read once, there are no lists
/// between, and the result is that of clip_in_turn, in its order.
template <class Vertex, ClipBoundary<Vertex> Boundary>
class ClipPipeline {
 public:
  explicit ClipPipeline(std::span<const Boundary> boundaries) {
    for (const Boundary& boundary : boundaries) machines_.emplace_back(boundary);
  }

  template <class Output>
  void next(const Vertex& v, Output&& output) {
    feed(0, v, output);
  }
  template <class Output>
  void close(Output&& output) {
    for (std::size_t i = 0; i < machines_.size(); ++i)
      machines_[i].close([&](const Vertex& v) { feed(i + 1, v, output); });
  }

 private:
  template <class Output>
  void feed(std::size_t i, const Vertex& v, Output& output) {
    if (i == machines_.size())
      output(v);
    else
      machines_[i].next(v, [&](const Vertex& kept) { feed(i + 1, kept, output); });
  }

  std::vector<ClipMachine<Vertex, Boundary>> machines_;
};

template <class Vertex, ClipBoundary<Vertex> Boundary>
ClippedChain<Vertex> clip_at_once(std::span<const Vertex> chain, std::span<const Boundary> boundaries) {
  ClippedChain<Vertex> result;
  const auto keep = [&](const Vertex& v) { result.chain.push_back(v); };
  ClipPipeline<Vertex, Boundary> pipeline(boundaries);
  for (const Vertex& v : chain) {
    ++result.vertices_read;
    pipeline.next(v, keep);
  }
  pipeline.close(keep);
  return result;
}

}  // namespace lambert::polygon
