#pragma once
/// How often the rings of both operands wind around a place, and what that means.

#include "lambert/polygon/boolean/boolean.h"

#include <cstdint>

namespace lambert::polygon::arrangement {

struct Winding {
  std::int32_t subject = 0, clip = 0;

  Winding operator+(Winding o) const { return {subject + o.subject, clip + o.clip}; }
  Winding operator-(Winding o) const { return {subject - o.subject, clip - o.clip}; }
  Winding operator-() const { return {-subject, -clip}; }
  bool operator==(const Winding&) const = default;
};

/// The set that an operation makes, as a predicate on windings.
struct Selection {
  BooleanOp op;
  FillRule rule;

  bool covers(std::int32_t winding) const {
    switch (rule) {
      case FillRule::even_odd: return (winding & 1) != 0;
      case FillRule::non_zero: return winding != 0;
      case FillRule::positive: return winding > 0;
      case FillRule::negative: break;
    }
    return winding < 0;
  }

  bool contains(Winding w) const {
    const bool in_subject = covers(w.subject), in_clip = covers(w.clip);
    switch (op) {
      case BooleanOp::unite: return in_subject || in_clip;
      case BooleanOp::intersect: return in_subject && in_clip;
      case BooleanOp::subtract: return in_subject && !in_clip;
      case BooleanOp::exclude: break;
    }
    return in_subject != in_clip;
  }
};

}  // namespace lambert::polygon::arrangement
