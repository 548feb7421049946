#include "lambert/image/hdr/align.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/hdr/threshold_bitmap.h"
#include "lambert/image/hdr/transfer.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {
namespace {

struct Name {
  const char* name;
  Alignment kind;
};
constexpr Name names[] = {{"none", Alignment::none}, {"shift", Alignment::shift}, {"rigid", Alignment::rigid}};

/// Lower is better. Two pictures without a code in common tell nothing.
double spread(const Grey& a, const Grey& b, const Motion& motion) {
  const Transfer t = transfer(a, b, motion);
  return t.pixels < 100 ? 1e30 : t.spread + 0.02;  // rounding to codes: perfect pictures are never twice as perfect
}

/// The best of the whole shifts about `start`, downhill.
Motion best_whole(const Grey& a, const Grey& b, Motion start, double& least) {
  least = spread(a, b, start);
  for (int turn = 0; turn < 8; ++turn) {
    const Vec2d centre = start.shift;
    for (const Vec2d by : {Vec2d(1, 0), Vec2d(-1, 0), Vec2d(0, 1), Vec2d(0, -1)}) {
      const Motion near{centre + by};
      if (const double s = spread(a, b, near); s < least) least = s, start = near;
    }
    if (start.shift == centre) break;
  }
  return start;
}

Motion between(const std::vector<Grey>& a, const std::vector<Grey>& b, const AlignmentSettings& settings) {
  Motion best;
  const double unmoved = spread(a[0], b[0], best);
  double least = unmoved;
  const Motion whole = best_whole(a[0], b[0], {Vec2d(bitmap_shift(a, b, settings.largest_shift))}, least);
  if (least < 0.98 * unmoved)
    best = whole;
  else
    least = unmoved;
  if (settings.kind != Alignment::rigid) return best;
  const Motion fine = refined(a, b, best);
  const bool near = glm::length(fine.shift) <= 2.0 * settings.largest_shift && std::abs(fine.turn) < 0.2;
  // Interpolation smooths, and a smoother picture is easier to tell: moving back by half a pixel must not win by that.
  return near && spread(a[0], b[0], fine) < 0.8 * least ? fine : best;
}

Motion inverse(const Motion& m) {
  const double c = std::cos(m.turn), s = std::sin(m.turn);
  return {{-c * m.shift.x - s * m.shift.y, s * m.shift.x - c * m.shift.y}, -m.turn};
}

template <class Code>
Code interpolated(const ExposureStack& stack, const std::vector<Code>& codes, Vec2d at, std::size_t c) {
  const int x = std::min(static_cast<int>(at.x), std::max(stack.width - 2, 0));
  const int y = std::min(static_cast<int>(at.y), std::max(stack.height - 2, 0));
  const double u = at.x - x, v = at.y - y;
  const auto code = [&](int px, int py) {
    px = std::min(px, stack.width - 1), py = std::min(py, stack.height - 1);
    return static_cast<double>(
        codes[static_cast<std::size_t>(py) * stack.row_size() + static_cast<std::size_t>(px) * stack.channels + c]);
  };
  const double a = code(x, y), b = code(x + 1, y), d = code(x, y + 1), e = code(x + 1, y + 1);
  if (std::max({a, b, d, e}) >= stack.levels - 1) return static_cast<Code>(stack.levels - 1);
  return static_cast<Code>(std::lerp(std::lerp(a, b, u), std::lerp(d, e, u), v) + 0.5);
}

template <class Code>
void move_frame(const ExposureStack& stack, Frame& frame, const Motion& motion) {
  auto& codes = std::get<std::vector<Code>>(frame.codes);
  const std::vector<Code> from = std::move(codes);
  codes.assign(from.size(), 0);
  frame.covered.assign(static_cast<std::size_t>(stack.height), Span{});
  const double cx = 0.5 * (stack.width - 1), cy = 0.5 * (stack.height - 1);
  const double cosine = std::cos(motion.turn), sine = std::sin(motion.turn);
  parallel_for(static_cast<std::size_t>(stack.height), [&](std::size_t row) {
    Span covered;
    for (int x = 0; x < stack.width; ++x) {
      const double px = x - cx, py = static_cast<double>(row) - cy;
      const Vec2d at(cx + cosine * px - sine * py + motion.shift.x, cy + sine * px + cosine * py + motion.shift.y);
      if (!(at.x >= 0 && at.y >= 0 && at.x <= stack.width - 1 && at.y <= stack.height - 1)) continue;
      if (covered.end == 0) covered.begin = x;
      covered.end = x + 1;
      for (std::size_t c = 0; c < stack.channels; ++c)
        codes[row * stack.row_size() + static_cast<std::size_t>(x) * stack.channels + c] =
            interpolated(stack, from, at, c);
    }
    frame.covered[row] = covered;
  });
}

}  // namespace

Motion then(const Motion& a, const Motion& b) {
  const double c = std::cos(b.turn), s = std::sin(b.turn);
  return {{c * a.shift.x - s * a.shift.y + b.shift.x, s * a.shift.x + c * a.shift.y + b.shift.y}, a.turn + b.turn};
}

Alignment alignment(std::string_view name) {
  for (const Name& n : names)
    if (name == n.name) return n.kind;
  throw Error("unknown alignment " + unknown_word(name, alignment_names()));
}

std::vector<std::string> alignment_names() {
  std::vector<std::string> all;
  for (const Name& n : names) all.push_back(n.name);
  return all;
}

std::vector<Motion> find_motions(const ExposureStack& stack, std::size_t reference, const AlignmentSettings& settings,
                                 const FractionSink& progress) {
  const std::size_t n = stack.frames.size();
  std::vector<Motion> motions(n);
  if (settings.kind == Alignment::none || n < 2) return motions;
  std::vector<std::vector<Grey>> greys(n);
  parallel_for(n, part_of(progress, 0, 0.5), [&](std::size_t j) { greys[j] = pyramid(grey_of(stack, j), 7); });
  std::vector<Motion> next(n - 1);  // from frame j to frame j + 1
  parallel_for(n - 1, part_of(progress, 0.5, 1),
               [&](std::size_t j) { next[j] = between(greys[j], greys[j + 1], settings); });
  for (std::size_t j = reference; j + 1 < n; ++j) motions[j + 1] = then(motions[j], next[j]);
  for (std::size_t j = reference; j > 0; --j) motions[j - 1] = then(motions[j], inverse(next[j - 1]));
  return motions;
}

void move_back(ExposureStack& stack, const std::vector<Motion>& motions) {
  for (std::size_t j = 0; j < stack.frames.size(); ++j)
    if (!motions[j].still())
      stack.with_code_type([&]<class Code>(Code) { move_frame<Code>(stack, stack.frames[j], motions[j]); });
}

}  // namespace lambert::hdr
