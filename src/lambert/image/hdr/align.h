#pragma once
/// Photographs from the hand: where each one looked.

#include "lambert/image/hdr/stack.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::hdr {

/// Reference point p, from the centre, is seen at R(turn) p + shift in the other photograph; x right, y down, pixels
/// and radians.
struct Motion {
  Vec2d shift{0};
  double turn = 0;
  bool still() const { return shift == Vec2d(0) && turn == 0; }
  bool whole() const { return turn == 0 && shift == glm::round(shift); }
};
/// First `a`, then `b`.
Motion then(const Motion& a, const Motion& b);

enum class Alignment {
  none,
  shift,  ///< by whole pixels, no code is changed: median threshold bitmaps (Ward 2003)
  rigid,  ///< then by parts of pixels and rotation (Lucas and Kanade 1981) where that is clearly better
};
Alignment alignment(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> alignment_names();

struct AlignmentSettings {
  Alignment kind = Alignment::rigid;
  int largest_shift = 64;  ///< pixels between neighbouring exposures
};

/// The motion of each frame against frame `reference`, found between neighbours in exposure. A motion is believed when
/// one photograph tells the codes of the other better with it: a shift by 2 %, a rotation or part of a pixel by another
/// 5 %.
std::vector<Motion> find_motions(const ExposureStack& stack, std::size_t reference,
                                 const AlignmentSettings& settings = {}, const FractionSink& progress = {});

/// Moves the frames back by their motions, and says in Frame::covered what they show. Whole shifts keep codes; others
/// are bilinear between codes, the top code where one of the four is.
void move_back(ExposureStack& stack, const std::vector<Motion>& motions);

}  // namespace lambert::hdr
