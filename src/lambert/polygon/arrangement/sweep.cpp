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

constexpr auto later = [](const auto& a, const auto& b) { return before(b.point, a.point); };

}  // namespace

void Sweep::push(const Event& event) {
  events_.push_back(event);
  std::push_heap(events_.begin(), events_.end(), later);
}

bool Sweep::run(const Grid& grid, double tolerance) {
  grid_ = grid;
  tolerance_ = tolerance;
  moved_ = false;
  nodes_ = 0;
  next_in_order_ = next_slot_ = 0;
  status_.clear();
  started_.clear();
  order_.resize(pieces_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  // After a pass they are nearly always in order.
  const auto starts_before = [&](std::uint32_t i, std::uint32_t j) { return before(pieces_[i].a, pieces_[j].a); };
  if (!std::is_sorted(order_.begin(), order_.end(), starts_before))
    std::sort(order_.begin(), order_.end(), starts_before);
  sort_ends();
  place_.assign(pieces_.size(), none);
  while (next_point()) handle_point();
  finish();
  return !moved_;
}

void Sweep::sort_ends() {
  if (ended_.size() == pieces_.size()) {
    owner_.swap(ended_);
  } else {
    owner_.resize(pieces_.size());
    std::iota(owner_.begin(), owner_.end(), 0U);
  }
  ended_.clear();
  const auto ends_before = [&](std::uint32_t i, std::uint32_t j) { return before(pieces_[i].b, pieces_[j].b); };
  if (!std::is_sorted(owner_.begin(), owner_.end(), ends_before)) std::sort(owner_.begin(), owner_.end(), ends_before);
  sorted_slots_ = owner_.size();
  slot_.resize(pieces_.size());
  for (std::uint32_t slot = 0; slot < owner_.size(); ++slot) slot_[owner_[slot]] = slot;
}

bool Sweep::next_point() {
  bool any = false;
  const auto consider = [&](Vec2d p) {
    if (!any || before(p, point_)) point_ = p;
    any = true;
  };
  if (next_in_order_ < order_.size()) consider(pieces_[order_[next_in_order_]].a);
  if (next_slot_ < sorted_slots_) consider(pieces_[owner_[next_slot_]].b);
  if (!events_.empty()) consider(events_.front().point);
  return any;
}

void Sweep::handle_point() {
  collect();
  if (ending_.empty() && starting_.empty()) return;  // all that ended here has merged into other pieces
  find_neighbours();
  absorb_touching();
  for (const std::uint32_t piece : ending_) {
    pieces_[piece].to = nodes_;
    status_.erase(place_[piece]);
    place_[piece] = none;
    ended_.push_back(piece);
  }
  order_starting();
  insert_starting();
  ++nodes_;
}

void Sweep::collect_end(std::uint32_t slot) {
  if (slot == none) return;
  const std::uint32_t piece = owner_[slot];
  if (place_[piece] != none && pieces_[piece].b == point_) ending_.push_back(piece);
}

void Sweep::collect() {
  ending_.clear();
  starting_.clear();
  for (; next_slot_ < sorted_slots_ && pieces_[owner_[next_slot_]].b == point_; ++next_slot_)
    collect_end(static_cast<std::uint32_t>(next_slot_));
  for (; next_in_order_ < order_.size() && pieces_[order_[next_in_order_]].a == point_; ++next_in_order_)
    starting_.push_back(order_[next_in_order_]);
  while (!events_.empty() && events_.front().point == point_) {
    std::pop_heap(events_.begin(), events_.end(), later);
    const Event event = events_.back();
    events_.pop_back();
    for (const std::uint32_t slot : event.ends) collect_end(slot);
    for (const std::uint32_t piece : event.starts) {
      if (piece != none) starting_.push_back(piece);
    }
  }
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

/// The tolerance as a distance: relative to the largest coordinate, and no less than some quanta of the grid.
double Sweep::reach(Vec2d a, Vec2d b, Vec2d c) const {
  const auto size = [](Vec2d p) { return std::max(std::abs(p.x), std::abs(p.y)); };
  return tolerance_ * std::max(std::max(size(a), 0x1p52 * grid_.quantum()), std::max(size(b), size(c)));
}

bool Sweep::touches_point(const Piece& piece) {
  if (side(piece, point_) == 0) return true;
  if (tolerance_ == 0 || !in_box({piece.a, piece.b}, point_)) return false;
  const double twice_area = cross(piece.a, piece.b, point_);
  const bool near = std::abs(twice_area) <= reach(piece.a, piece.b, point_) * length(piece.b - piece.a);
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

/// Lets a piece end at p, in a slot of its own, and returns what is left of it, which ends where the piece did.
std::uint32_t Sweep::cut_off(std::uint32_t piece, Vec2d p) {
  const Piece old = pieces_[piece];
  const auto rest = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({p, old.b, old.line, old.delta, {}});
  pieces_[piece].b = p;
  place_.push_back(none);
  slot_.push_back(slot_[piece]);
  owner_[slot_[piece]] = rest;
  slot_[piece] = static_cast<std::uint32_t>(owner_.size());
  owner_.push_back(piece);
  return rest;
}

void Sweep::cut_at_point(std::uint32_t piece) {
  if (pieces_[piece].b == point_ || pieces_[piece].a == point_) return;
  starting_.push_back(cut_off(piece, point_));
  ending_.push_back(piece);
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
      const std::uint32_t shorter = starting_[kept - 1];
      const Vec2d end = pieces_[shorter].b;
      if (end != pieces_[piece].b) push({end, {none, none}, {cut_off(piece, end), none}});
      Piece &into = pieces_[shorter], &from = pieces_[piece];
      into.delta = into.delta + from.delta;
      into.line = std::min(into.line, from.line);
      from.delta = {};
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
    started_.push_back(piece);
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

/// The end of one segment next to q that lies in the box of the other, if one is within reach.
Vec2d Sweep::snap_to_end(Vec2d q, Segment s, Segment t) const {
  double nearest = reach(s.a, s.b, q);
  Vec2d found = q;
  const auto consider = [&](Vec2d end, Segment other) {
    const double distance = length(end - q);
    if (distance > nearest || end == other.a || end == other.b || !in_box(other, end)) return;
    nearest = distance;
    found = end;
  };
  consider(s.a, t);
  consider(s.b, t);
  consider(t.a, s);
  consider(t.b, s);
  return found;
}

void Sweep::cut_crossing(std::uint32_t low, std::uint32_t high) {
  const Piece l = pieces_[low], h = pieces_[high];
  moved_ = true;
  // A late cut leaves the order wrong for the rest of the pass; then they need not cross at all.
  if (!segments_cross({l.a, l.b}, {h.a, h.b})) return;
  const Vec2d* const p = outline_.points.data();
  Vec2d q = crossing_of_parts({l.a, l.b}, {h.a, h.b}, {p[l.line], p[l.line + 1]}, {p[h.line], p[h.line + 1]});
  q = grid_(q);
  if (tolerance_ > 0) q = snap_to_end(q, {l.a, l.b}, {h.a, h.b});
  Event event{q, {none, none}, {none, none}};
  cut(low, event, 0);
  cut(high, event, 1);
  if (event.starts[0] != none || event.starts[1] != none) push(event);
}

void Sweep::cut(std::uint32_t piece, Event& event, int which) {
  const Piece& old = pieces_[piece];
  const Vec2d p = event.point;
  if (p == old.a || p == old.b) return;
  if (!before(point_, p) || !before(p, old.b)) {
    late_cuts_.push_back({piece, p});
    return;
  }
  event.starts[which] = cut_off(piece, p);
  event.ends[which] = slot_[piece];
}

/// Leaves the pieces in the order of the next sweep.
void Sweep::finish() {
  if (!moved_) return;
  std::vector<Piece> sorted;
  sorted.reserve(started_.size() + late_cuts_.size());
  std::vector<std::uint32_t>& place_of = place_;
  for (const std::uint32_t piece : started_) {
    place_of[piece] = static_cast<std::uint32_t>(sorted.size());
    const Piece& p = pieces_[piece];
    sorted.push_back({p.a, p.b, p.line, p.delta, {}});
  }
  for (std::uint32_t& piece : ended_) piece = place_of[piece];
  for (const Cut& cut : late_cuts_) {
    const Piece old = sorted[place_of[cut.piece]];
    const auto part = [&](Vec2d a, Vec2d b) {
      return before(a, b) ? Piece{a, b, old.line, old.delta, {}} : Piece{b, a, old.line, -old.delta, {}};
    };
    // The piece may have been cut shorter meanwhile.
    if (cut.point == old.a || cut.point == old.b || !in_box({old.a, old.b}, cut.point)) continue;
    sorted[place_of[cut.piece]] = part(old.a, cut.point);
    sorted.push_back(part(cut.point, old.b));
  }
  late_cuts_.clear();
  pieces_.swap(sorted);
}

}  // namespace lambert::polygon::arrangement
