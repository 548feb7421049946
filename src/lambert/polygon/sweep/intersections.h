#pragma once
#include "lambert/polygon/queries/segment.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambert::polygon {

/// Two of several segments that meet, by index, first < second. The meeting is intersect() of the first with the
/// second, except that segments that meet where another one ends all get that end as their point.
struct SegmentPair {
  std::size_t first, second;
  SegmentMeeting meeting;
};

/// All pairs that have a point in common, ends included, in ascending order. Which pairs meet, and how, is decided
/// exactly; the points are rounded (see SegmentMeeting). O((n + k) log n) time and O(n + k) memory for k pairs.
std::vector<SegmentPair> all_intersections(std::span<const Segment> segments);

/// The same pairs by trying each, O(n^2).
std::vector<SegmentPair> all_intersections_by_pairs(std::span<const Segment> segments);

}  // namespace lambert::polygon
