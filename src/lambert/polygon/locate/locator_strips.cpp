#include "lambert/polygon/locate/locator_strips.h"

#include <algorithm>
#include <cmath>

namespace lambert::polygon {
namespace {

using Places = std::pair<double, double>;

/// The mean direction of lines, which have no sign: angles are doubled, averaged and halved.
Vec2d mean_direction(const EdgeList& edges, std::span<const std::uint32_t> inside) {
  Vec2d doubled(0);
  for (const std::uint32_t e : inside) {
    const Vec2d d = edges.points[e + 1] - edges.points[e];
    const double size = length(d);
    if (size > 0) doubled += Vec2d(d.x * d.x - d.y * d.y, 2 * d.x * d.y) / size;
  }
  const double angle = 0.5 * std::atan2(doubled.y, doubled.x);
  return {std::cos(angle), std::sin(angle)};
}

/// The part of a line, a + t d, that lies in a box; reversed when none does.
std::pair<double, double> clip(Vec2d a, Vec2d d, const Box2& box, double t_low, double t_high) {
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0) continue;
    const double t0 = (box.min[axis] - a[axis]) / d[axis], t1 = (box.max[axis] - a[axis]) / d[axis];
    t_low = std::max(t_low, std::min(t0, t1)), t_high = std::min(t_high, std::max(t0, t1));
  }
  return {t_low, t_high};
}

}  // namespace

std::optional<std::uint32_t> LocatorStrips::divide(const EdgeList& edges, const Box2& cell, double slack,
                                                   std::span<const std::uint32_t> inside, Vec2d reference,
                                                   std::int32_t winding) {
  const Vec2d along = mean_direction(edges, inside), across(-along.y, along.x), centre = cell.centre();
  const double half = 0.5 * dot(glm::abs(across), cell.size());
  const Box2 wide{cell.min - slack, cell.max + slack};
  std::vector<Places> places;
  double spans = 0;
  for (const std::uint32_t e : inside) {
    const Vec2d a = edges.points[e], d = edges.points[e + 1] - a;
    const auto [t_low, t_high] = clip(a, d, wide, 0, 1);
    const auto [low, high] = std::minmax({dot(a + std::clamp(t_low, 0.0, 1.0) * d - centre, across),
                                          dot(a + std::clamp(t_high, 0.0, 1.0) * d - centre, across)});
    places.emplace_back(low - 4 * slack, high + 4 * slack);
    spans += (high - low) / (2 * half);
  }
  // As many strips as edges, but no more than make three entries of each.
  const auto n = static_cast<double>(inside.size());
  const double count = std::floor(std::min({n, 2 * n / spans, half / (64 * slack)}));
  if (!(count >= 4)) return std::nullopt;
  const double per_length = count / (2 * half);
  const Vec2d corner(std::copysign(0.5 * cell.size().x, across.x), std::copysign(0.5 * cell.size().y, across.y));
  const Division division{centre, across * per_length, corner / (0.5 * count), count,
                          static_cast<std::uint32_t>(strips_.size() - 1)};
  for (Places& p : places) p.first *= per_length, p.second *= per_length;
  list_edges(division, inside, places);
  find_windings(edges, division, reference, winding);
  divisions_.push_back(division);
  return static_cast<std::uint32_t>(divisions_.size() - 1);
}

void LocatorStrips::list_edges(const Division& division, std::span<const std::uint32_t> inside,
                               const std::vector<Places>& places) {
  const auto count = static_cast<std::size_t>(division.count);
  strips_.resize(division.first + count + 1);
  std::vector<std::uint32_t> sizes(count + 1, 0);
  const auto for_each = [&](auto&& use) {
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (std::uint32_t s = division.strip_at(places[i].first); s <= division.strip_at(places[i].second); ++s)
        use(s, inside[i]);
  };
  for_each([&](std::uint32_t s, std::uint32_t) { ++sizes[s]; });
  auto end = static_cast<std::uint32_t>(edges_.size());
  for (std::size_t s = 0; s <= count; ++s) end += sizes[s], strips_[division.first + s].first = end;
  edges_.resize(end);
  // Filled from the back of each strip, so that `first` ends where it should.
  for_each([&](std::uint32_t s, std::uint32_t edge) { edges_[--strips_[division.first + s].first] = edge; });
}

/// From the strip of the point that is known, to both sides.
void LocatorStrips::find_windings(const EdgeList& edges, const Division& division, Vec2d reference,
                                  std::int32_t winding) {
  const auto count = static_cast<std::uint32_t>(division.count);
  const std::uint32_t start = division.strip(reference);
  std::vector<std::uint32_t> near;
  for (const int step : {1, -1}) {
    Vec2d known = reference;
    std::int32_t known_winding = winding;
    std::uint32_t from = start;
    for (std::uint32_t s = start; s < count; s += static_cast<std::uint32_t>(step)) {
      const std::uint32_t low = division.first + std::min(s, from), high = division.first + std::max(s, from);
      near.assign(edges_.begin() + strips_[low].first, edges_.begin() + strips_[high + 1].first);
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      const Winding w = edges.winding_from(known, known_winding, division.reference(s), near);
      strips_[division.first + s].winding = w.on ? unknown : w.number;
      if (w.on) continue;
      known = division.reference(s), known_winding = w.number, from = s;
    }
  }
}

}  // namespace lambert::polygon
