#include "lambert/polygon/sweep/intersections.h"

#include "lambert/polygon/sweep/sweep.h"

#include <algorithm>
#include <utility>

namespace lambert::polygon {
namespace {

class Collector : public SweepVisitor {
 public:
  Collector(std::span<const Segment> segments, const SweepSegments& prepared)
      : segments_(segments), prepared_(prepared) {}

  bool crossing(std::uint32_t s, std::uint32_t t) override {
    add(s, t);
    return true;
  }

  bool at_point(const SweepPoint& p) override {
    members_.clear();
    for (const auto& part : {p.starting, p.points, p.ending, p.through})
      members_.insert(members_.end(), part.begin(), part.end());
    const std::size_t begun_here = p.starting.size() + p.points.size();
    for (std::size_t i = 0; i < members_.size(); ++i)
      for (std::size_t k = i + 1; k < members_.size(); ++k) {
        // Two of one line were found together already where the later one began.
        if (i >= begun_here && prepared_.rank[members_[i]] == prepared_.rank[members_[k]]) continue;
        SegmentMeeting& meeting = add(members_[i], members_[k]);
        if (meeting.kind == SegmentCase::crossing) meeting.from = meeting.to = p.point / prepared_.scale;
      }
    return true;
  }

  std::vector<SegmentPair> sorted() {
    const auto key = [](const SegmentPair& p) { return std::pair(p.first, p.second); };
    std::sort(pairs_.begin(), pairs_.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    // No pair comes twice or does not meet unless the predicates were beyond their range.
    const auto last =
        std::unique(pairs_.begin(), pairs_.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); });
    pairs_.erase(std::remove_if(pairs_.begin(), last, [](const auto& p) { return !p.meeting.meet(); }), pairs_.end());
    return std::move(pairs_);
  }

 private:
  SegmentMeeting& add(std::uint32_t s, std::uint32_t t) {
    const auto [first, second] = std::minmax(s, t);
    pairs_.push_back({first, second, intersect(segments_[first], segments_[second])});
    return pairs_.back().meeting;
  }

  std::span<const Segment> segments_;
  const SweepSegments& prepared_;
  std::vector<SegmentPair> pairs_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

std::vector<SegmentPair> all_intersections(std::span<const Segment> segments) {
  const SweepSegments prepared = prepare_sweep(segments);
  Collector collector(segments, prepared);
  sweep(prepared, collector);
  return collector.sorted();
}

std::vector<SegmentPair> all_intersections_by_pairs(std::span<const Segment> segments) {
  std::vector<SegmentPair> pairs;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t k = i + 1; k < segments.size(); ++k)
      if (const SegmentMeeting m = intersect(segments[i], segments[k]); m.meet()) pairs.push_back({i, k, m});
  return pairs;
}

}  // namespace lambert::polygon
