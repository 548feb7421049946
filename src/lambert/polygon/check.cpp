#include "lambert/polygon/check.h"

namespace lambert::polygon {
namespace {

using Fault = ChainCheck::Fault;

template <class Point>
ChainCheck check_list(std::span<const Point> list) {
  if (list.size() < 3 || (list.size() == 3 && list.front() == list.back())) return {Fault::too_few};
  if (list.front() != list.back()) return {Fault::not_closed, list.size() - 1};
  for (std::size_t i = 0; i + 1 < list.size(); ++i)
    if (list[i] == list[i + 1]) return {Fault::repeated_vertex, i};
  return {};
}

template <class Point>
ChainCheck check_cycle(std::span<const Point> ring) {
  const std::size_t n = ring.size();
  if (n < 3) return {Fault::too_few};
  for (std::size_t i = 0; i < n; ++i)
    if (ring[i] == ring[i + 1 == n ? 0 : i + 1]) return {Fault::repeated_vertex, i};
  return {};
}

}  // namespace

ChainCheck check_closed_list(std::span<const Vec2d> list) { return check_list(list); }
ChainCheck check_closed_list(std::span<const Vec3d> list) { return check_list(list); }
ChainCheck check_ring(std::span<const Vec2d> ring) { return check_cycle(ring); }
ChainCheck check_ring(std::span<const Vec3d> ring) { return check_cycle(ring); }

std::string message_of(const ChainCheck& check, std::size_t size) {
  switch (check.fault) {
    case Fault::none: return {};
    case Fault::too_few: return "too few vertices for a polygon, which needs three";
    case Fault::not_closed: return "not closed: vertex " + std::to_string(check.index) + ", the last, is not the first";
    case Fault::repeated_vertex: break;
  }
  const std::size_t next = check.index + 1 == size ? 0 : check.index + 1;
  return "vertices " + std::to_string(check.index) + " and " + std::to_string(next) + " coincide";
}

}  // namespace lambert::polygon
