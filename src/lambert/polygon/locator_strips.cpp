#include "lambert/polygon/locator_strips.h"

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
  const Division division{centre, across * per_length, 0.5 * count, count - 1,
                          static_cast<std::uint32_t>(strips_.size() - 1)};
  for (Places& p : places) p.first *= per_length, p.second *= per_length;
  list_edges(edges, division, inside, places, static_cast<std::uint32_t>(count));
  find_windings(edges, division, cell, reference, winding, static_cast<std::uint32_t>(count));
  divisions_.push_back(division);
  return static_cast<std::uint32_t>(divisions_.size() - 1);
}

void LocatorStrips::list_edges(const EdgeList&, const Division& division, std::span<const std::uint32_t> inside,
                               const std::vector<Places>& places, std::uint32_t count) {
  strips_.resize(division.first + count + 1);
  std::vector<std::uint32_t> sizes(count + 1, 0);
  const auto for_each = [&](auto&& use) {
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (std::uint32_t s = division.number_at(places[i].first); s <= division.number_at(places[i].second); ++s)
        use(s, inside[i]);
  };
  for_each([&](std::uint32_t s, std::uint32_t) { ++sizes[s]; });
  auto end = static_cast<std::uint32_t>(edges_.size());
  for (std::uint32_t s = 0; s <= count; ++s) end += sizes[s], strips_[division.first + s].first = end;
  edges_.resize(end);
  // Filled from the back of each strip, so that `first` ends where it should.
  for_each([&](std::uint32_t s, std::uint32_t edge) { edges_[--strips_[division.first + s].first] = edge; });
}

/// From the strip of the point that is known, to both sides.
void LocatorStrips::find_windings(const EdgeList& edges, const Division& division, const Box2& cell, Vec2d reference,
                                  std::int32_t winding, std::uint32_t count) {
  const Vec2d normal = normalize(division.across), along(normal.y, -normal.x);
  const double width = 1 / length(division.across);
  std::vector<std::uint32_t> near;
  // Finds a point of strip s on no edge, and its winding number by the one of strip `from`.
  const auto find = [&](std::uint32_t s, std::uint32_t from, Vec2d known, std::int32_t known_winding) {
    Strip& strip = strips_[division.first + s];
    const auto [low, high] = std::minmax(s, from);
    near.assign(edges_.begin() + strips_[division.first + low].first,
                edges_.begin() + strips_[division.first + high + 1].first);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    strip.winding = unknown;
    for (const double part : {0.5, 0.37, 0.68}) {
      const Vec2d middle = division.centre + (s + part - division.offset) * width * normal;
      const double far = length(cell.size());
      const auto [t_low, t_high] = clip(middle, along, cell, -far, far);
      const Vec2d p = middle + ((1 - part) * t_low + part * t_high) * along;
      const Winding w = edges.winding_from(known, known_winding, p, near);
      if (w.on) continue;
      strip.reference = p, strip.winding = w.number;
      return true;
    }
    return false;
  };
  const std::uint32_t start = division.strip(reference);
  for (const int step : {1, -1}) {
    Vec2d known = reference;
    std::int32_t known_winding = winding;
    std::uint32_t from = start;
    for (std::uint32_t s = start; s < count; s += static_cast<std::uint32_t>(step)) {
      if (!find(s, from, known, known_winding)) continue;
      known = strips_[division.first + s].reference, known_winding = strips_[division.first + s].winding;
      from = s;
    }
  }
}

}  // namespace lambert::polygon
