#include "lambert/polygon/ear_clipping.h"

#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>

namespace lambert::polygon {
namespace {

/// Some corners, sorted into square cells.
class CornerGrid {
 public:
  CornerGrid(std::span<const Vec2d> points, const std::vector<std::uint32_t>& members)
      : side_(std::clamp(static_cast<int>(std::sqrt(members.size())), 1, 1024)), min_(points[0]) {
    Vec2d max = points[0];
    for (const Vec2d p : points) min_ = glm::min(min_, p), max = glm::max(max, p);
    const Vec2d size = max - min_;
    const auto per_unit = [&](double length) { return length > 0x1p-1000 ? side_ / length : 0; };
    cells_per_unit_ = {per_unit(size.x), per_unit(size.y)};
    start_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    for (const std::uint32_t m : members) ++start_[cell(points[m]) + 1];
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    members_.resize(members.size());
    std::vector<std::uint32_t> next = start_;
    for (const std::uint32_t m : members) members_[next[cell(points[m])]++] = m;
  }

  /// Whether `test` holds for a member in one of the cells that touch the box.
  template <class Test>
  bool any(Vec2d lo, Vec2d hi, const Test& test) const {
    const Vec2i first = place(lo), last = place(hi);
    for (int y = first.y; y <= last.y; ++y)
      for (std::uint32_t i = start_[index({first.x, y})]; i < start_[index({last.x, y}) + 1]; ++i)
        if (test(members_[i])) return true;
    return false;
  }

 private:
  Vec2i place(Vec2d p) const { return glm::clamp(Vec2i((p - min_) * cells_per_unit_), Vec2i(0), Vec2i(side_ - 1)); }
  std::size_t index(Vec2i c) const { return static_cast<std::size_t>(c.y * side_ + c.x); }
  std::size_t cell(Vec2d p) const { return index(place(p)); }

  int side_;
  Vec2d min_, cells_per_unit_{0};
  std::vector<std::uint32_t> start_;  // of each cell among members_
  std::vector<std::uint32_t> members_;
};

class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec2d> corners)
      : corners_(corners), ring_(corners.size()), grid_(corners, link_ring()) {}

  std::vector<Triangle> run() {
    refill(0);
    std::uint32_t at = 0;
    while (left_ > 3) {
      if (queue_.empty() && clipped_since_refill_ && refills_left_-- > 0) refill(at);
      // Where no ear is left the polygon is not simple: then any corner does, so that this ends.
      const bool forced = queue_.empty();
      const std::uint32_t corner = forced ? at : queue_.front();
      if (!forced) queue_.pop_front();
      if (ring_[corner].removed || !(forced || is_ear(corner))) continue;
      at = cut(corner);
    }
    const Link& last = ring_[at];
    triangles_.push_back({last.before, at, last.after});
    return std::move(triangles_);
  }

 private:
  struct Link {
    std::uint32_t before = 0, after = 0;
    bool reflex = false, removed = false;
  };

  /// Returns the reflex corners.
  std::vector<std::uint32_t> link_ring() {
    const auto n = static_cast<std::uint32_t>(ring_.size());
    std::vector<std::uint32_t> reflex;
    for (std::uint32_t i = 0; i < n; ++i) {
      ring_[i].before = (i + n - 1) % n, ring_[i].after = (i + 1) % n;
      update(i);
      if (ring_[i].reflex) reflex.push_back(i);
    }
    return reflex;
  }
  void update(std::uint32_t i) {
    ring_[i].reflex = orientation(corners_[ring_[i].before], corners_[i], corners_[ring_[i].after]) <= 0;
  }

  void refill(std::uint32_t from) {
    clipped_since_refill_ = false;
    std::uint32_t i = from;
    do {
      queue_.push_back(i);
      i = ring_[i].after;
    } while (i != from);
  }

  bool is_ear(std::uint32_t i) {
    const Vec2d a = corners_[ring_[i].before], b = corners_[i], c = corners_[ring_[i].after];
    if (orientation(a, b, c) <= 0) return false;
    return !grid_.any(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), [&](std::uint32_t k) {
      if (tests_left_ == 0) return false;
      --tests_left_;
      // A chain that touches a or c cannot cut the triangle without a corner in it; one that touches b can.
      if (!ring_[k].reflex || ring_[k].removed || k == i || corners_[k] == a || corners_[k] == c) return false;
      const Vec2d p = corners_[k];
      return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
    });
  }

  /// Removes the corner; returns the one after it.
  std::uint32_t cut(std::uint32_t i) {
    const auto [before, after, reflex, removed] = ring_[i];
    triangles_.push_back({before, i, after});
    ring_[before].after = after, ring_[after].before = before;
    ring_[i].removed = true;
    --left_;
    update(before), update(after);
    queue_.push_back(before), queue_.push_back(after);
    clipped_since_refill_ = true;
    return after;
  }

  std::span<const Vec2d> corners_;
  std::vector<Link> ring_;
  CornerGrid grid_;
  std::deque<std::uint32_t> queue_;
  std::vector<Triangle> triangles_;
  std::size_t left_ = ring_.size();
  bool clipped_since_refill_ = false;
  int refills_left_ = 32;
  // Beyond this (a hostile face: honest ones need a few tests for each corner) every convex corner counts as an ear.
  std::size_t tests_left_ = 100'000'000;
};

}  // namespace

std::vector<Triangle> clip_ears(std::span<const Vec2d> corners) {
  if (corners.size() < 3) return {};
  const double scale = safe_scale(sizes_of(corners));
  if (scale == 1) return EarClipper(corners).run();
  return EarClipper(scaled(Ring(corners.begin(), corners.end()), scale)).run();
}

}  // namespace lambert::polygon
