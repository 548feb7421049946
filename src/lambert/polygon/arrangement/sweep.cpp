#include "lambert/polygon/arrangement/sweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lambert::polygon::arrangement {
namespace {

bool before(Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// On which side of its piece a point is that lies between its ends lexicographically: 1 above.
int side(const Piece& piece, Vec2d p) { return orientation(piece.a, piece.b, p); }

/// The largest coordinate.
double size_of(Vec2d a, Vec2d b, Vec2d c) {
  const auto of = [](Vec2d p) { return std::max(std::abs(p.x), std::abs(p.y)); };
  return std::max(of(a), std::max(of(b), of(c)));
}

constexpr auto later = [](const auto& a, const auto& b) { return before(b.point, a.point); };

}  // namespace

void Sweep::push(std::vector<Event>& heap, Vec2d point, std::uint32_t piece) {
  heap.push_back({point, piece});
  std::push_heap(heap.begin(), heap.end(), later);
}

Sweep::Event Sweep::pop(std::vector<Event>& heap) {
  std::pop_heap(heap.begin(), heap.end(), later);
  const Event event = heap.back();
  heap.pop_back();
  return event;
}

bool Sweep::run() {
  order_.resize(pieces_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(),
            [&](std::uint32_t i, std::uint32_t j) { return before(pieces_[i].a, pieces_[j].a); });
  place_.assign(pieces_.size(), none);
  while (next_point()) handle_point();
  finish();
  return !moved_;
}

bool Sweep::next_point() {
  bool any = false;
  const auto consider = [&](Vec2d p) {
    if (!any || before(p, point_)) point_ = p;
    any = true;
  };
  if (next_in_order_ < order_.size()) consider(pieces_[order_[next_in_order_]].a);
  if (!starts_.empty()) consider(starts_.front().point);
  if (!ends_.empty()) consider(ends_.front().point);
  return any;
}

void Sweep::handle_point() {
  collect_ending();
  collect_starting();
  if (ending_.empty() && starting_.empty()) return;  // all were cut shorter meanwhile
  find_neighbours();
  absorb_touching();
  for (const std::uint32_t piece : ending_) {
    pieces_[piece].to = nodes_;
    status_.erase(place_[piece]);
    place_[piece] = none;
  }
  order_starting();
  insert_starting();
  ++nodes_;
}

void Sweep::collect_ending() {
  ending_.clear();
  while (!ends_.empty() && ends_.front().point == point_) {
    const std::uint32_t piece = pop(ends_).piece;
    if (place_[piece] != none && pieces_[piece].b == point_) ending_.push_back(piece);
  }
}

void Sweep::collect_starting() {
  starting_.clear();
  for (; next_in_order_ < order_.size() && pieces_[order_[next_in_order_]].a == point_; ++next_in_order_)
    starting_.push_back(order_[next_in_order_]);
  while (!starts_.empty() && starts_.front().point == point_) starting_.push_back(pop(starts_).piece);
}

/// The places around those that end here; they are contiguous unless rounding has spoilt the order in this pass.
void Sweep::find_neighbours() {
  if (ending_.empty()) {
    below_ = status_.last_below([&](std::uint32_t piece) { return side(pieces_[piece], point_) > 0; });
    above_ = below_ == none ? status_.lowest() : status_.above(below_);
    return;
  }
  const auto ends_here = [&](std::uint32_t place) { return pieces_[status_.item(place)].b == point_; };
  below_ = above_ = place_[ending_.front()];
  std::size_t count = 1;
  while ((below_ = status_.below(below_)) != none && ends_here(below_)) ++count;
  while ((above_ = status_.above(above_)) != none && ends_here(above_)) ++count;
  if (count != ending_.size()) moved_ = true;
}

bool Sweep::touches_point(const Piece& piece) {
  if (side(piece, point_) == 0) return true;
  if (tolerance_ == 0) return false;
  const double twice_area = cross(piece.a, piece.b, point_), reach = tolerance_ * size_of(piece.a, piece.b, point_);
  const bool near = std::abs(twice_area) <= reach * length(piece.b - piece.a);
  moved_ |= near;
  return near;
}

/// Pieces through the point end there and go on as new ones; this moves nothing without a tolerance.
void Sweep::absorb_touching() {
  while (below_ != none) {
    const std::uint32_t piece = status_.item(below_), next = status_.below(below_);
    if (!touches_point(pieces_[piece])) break;
    cut_at_point(piece);
    below_ = next;
  }
  while (above_ != none) {
    const std::uint32_t piece = status_.item(above_), next = status_.above(above_);
    if (!touches_point(pieces_[piece])) break;
    cut_at_point(piece);
    above_ = next;
  }
  // A place that ends here, but was met out of order.
  while (below_ != none && pieces_[status_.item(below_)].b == point_) below_ = status_.below(below_);
  while (above_ != none && pieces_[status_.item(above_)].b == point_) above_ = status_.above(above_);
}

void Sweep::cut_at_point(std::uint32_t piece) {
  const Piece old = pieces_[piece];
  if (old.b == point_ || old.a == point_) return;
  pieces_[piece].b = point_;
  ending_.push_back(piece);
  const auto rest = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({point_, old.b, old.line, old.delta, {}});
  place_.push_back(none);
  starting_.push_back(rest);
}

/// By slope; what starts in the same direction is merged as far as the shorter one goes.
void Sweep::order_starting() {
  const auto lower = [&](std::uint32_t i, std::uint32_t j) {
    const int turn = orientation(point_, pieces_[i].b, pieces_[j].b);
    return turn != 0 ? turn > 0 : before(pieces_[i].b, pieces_[j].b);
  };
  if (starting_.size() > 1) std::sort(starting_.begin(), starting_.end(), lower);
  std::size_t kept = 0;
  for (const std::uint32_t piece : starting_) {
    if (kept > 0 && orientation(point_, pieces_[starting_[kept - 1]].b, pieces_[piece].b) == 0) {
      Piece& shorter = pieces_[starting_[kept - 1]];
      const Piece longer = pieces_[piece];
      shorter.delta = shorter.delta + longer.delta;
      shorter.line = std::min(shorter.line, longer.line);
      pieces_[piece].delta = {};
      if (shorter.b != longer.b) add_later(shorter.b, longer.b, longer.line, longer.delta);
    } else {
      starting_[kept++] = piece;
    }
  }
  starting_.resize(kept);
  std::erase_if(starting_, [&](std::uint32_t piece) { return pieces_[piece].delta == Winding{}; });
}

void Sweep::insert_starting() {
  std::uint32_t at = below_;
  for (const std::uint32_t piece : starting_) {
    Piece& p = pieces_[piece];
    if (at != none) {
      p.support = status_.item(at);
      p.below = pieces_[p.support].below + pieces_[p.support].delta;
    } else {
      p.support = none;
      p.below = {};
    }
    p.from = nodes_;
    at = place_[piece] = status_.insert_above(at, piece);
    push(ends_, p.b, piece);
  }
  const std::uint32_t low = below_ == none ? none : status_.item(below_);
  const std::uint32_t high = above_ == none ? none : status_.item(above_);
  if (starting_.empty()) {
    check(low, high);
  } else {
    check(low, starting_.front());
    check(starting_.back(), high);
  }
}

/// Whether two neighbours cross right of the point at hand: the one that ends first must do so on its side of the
/// other.
void Sweep::check(std::uint32_t low, std::uint32_t high) {
  if (low == none || high == none) return;
  const Piece &l = pieces_[low], &h = pieces_[high];
  if (l.b == h.b) return;
  if (before(l.b, h.b) ? side(h, l.b) > 0 : side(l, h.b) < 0) cut_crossing(low, high);
}

void Sweep::cut_crossing(std::uint32_t low, std::uint32_t high) {
  const Piece l = pieces_[low], h = pieces_[high];
  moved_ = true;
  // A late cut leaves the order wrong for the rest of the pass; then they need not cross at all.
  if (!segments_cross({l.a, l.b}, {h.a, h.b})) return;
  const Vec2d* const p = outline_.points.data();
  Vec2d q = crossing_of_parts({l.a, l.b}, {h.a, h.b}, {p[l.line], p[l.line + 1]}, {p[h.line], p[h.line + 1]});
  q = outline_.grid(q);
  if (tolerance_ > 0) {
    // Of the four ends these two lie between the ends of the other piece, so that cutting there leaves an order in
    // which cuts cannot go on for ever.
    const Vec2d a = before(l.a, h.a) ? h.a : l.a, b = before(l.b, h.b) ? l.b : h.b;
    const double to_a = length(q - a), to_b = length(q - b), reach = tolerance_ * size_of(a, b, q);
    if (std::min(to_a, to_b) <= reach) q = to_a <= to_b ? a : b;
  }
  cut(low, q);
  cut(high, q);
}

void Sweep::cut(std::uint32_t piece, Vec2d p) {
  const Piece old = pieces_[piece];
  if (p == old.a || p == old.b) return;
  if (!before(point_, p) || !before(p, old.b)) {
    late_cuts_.push_back({piece, p});
    return;
  }
  pieces_[piece].b = p;
  push(ends_, p, piece);
  add_later(p, old.b, old.line, old.delta);
}

void Sweep::add_later(Vec2d a, Vec2d b, std::uint32_t line, Winding delta) {
  const auto piece = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({a, b, line, delta, {}});
  place_.push_back(none);
  push(starts_, a, piece);
}

void Sweep::finish() {
  for (const Cut& cut : late_cuts_) {
    const Piece old = pieces_[cut.piece];
    const auto part = [&](Vec2d a, Vec2d b) {
      return before(a, b) ? Piece{a, b, old.line, old.delta, {}} : Piece{b, a, old.line, -old.delta, {}};
    };
    if (cut.point == old.a || cut.point == old.b) continue;
    pieces_[cut.piece] = part(old.a, cut.point);
    pieces_.push_back(part(cut.point, old.b));
  }
  if (moved_) std::erase_if(pieces_, [](const Piece& piece) { return piece.delta == Winding{}; });
}

}  // namespace lambert::polygon::arrangement
