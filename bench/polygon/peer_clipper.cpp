#include "peers.h"
#include "stopwatch.h"

#include <cmath>
#include <polyclipping/clipper.hpp>

namespace lambert::bench {
namespace {

/// Clipper computes on integers: coordinates, of size 1 here, become multiples of 2^-30.
constexpr double scale = 0x1p30;

ClipperLib::Paths paths_of(const polygon::Rings& rings) {
  ClipperLib::Paths paths;
  for (const polygon::Ring& ring : rings) {
    ClipperLib::Path& path = paths.emplace_back();
    for (const Vec2d p : ring) path.emplace_back(std::llround(p.x * scale), std::llround(p.y * scale));
  }
  return paths;
}

ClipperLib::ClipType clip_type(polygon::BooleanOp op) {
  switch (op) {
    case polygon::BooleanOp::unite: return ClipperLib::ctUnion;
    case polygon::BooleanOp::intersect: return ClipperLib::ctIntersection;
    case polygon::BooleanOp::subtract: return ClipperLib::ctDifference;
    case polygon::BooleanOp::exclude: break;
  }
  return ClipperLib::ctXor;
}

class ClipperOperands final : public Operands {
 public:
  ClipperOperands(const polygon::Rings& subject, const polygon::Rings& clip)
      : subject_(paths_of(subject)), clip_(paths_of(clip)) {}

  Run run(polygon::BooleanOp op) override {
    Stopwatch watch;
    ClipperLib::Clipper clipper;
    clipper.AddPaths(subject_, ClipperLib::ptSubject, true);
    clipper.AddPaths(clip_, ClipperLib::ptClip, true);
    ClipperLib::PolyTree tree;  // as ours, a result that knows which hole lies in which outer ring
    clipper.Execute(clip_type(op), tree, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
    Run run{.seconds = watch.seconds()};
    ClipperLib::Paths paths;
    ClipperLib::PolyTreeToPaths(tree, paths);
    for (const ClipperLib::Path& path : paths) {
      run.area += ClipperLib::Area(path) / (scale * scale);
      run.vertices += path.size();
    }
    return run;
  }

 private:
  ClipperLib::Paths subject_, clip_;
};

}  // namespace

Peer clipper_peer() { return {"clipper", prepared<ClipperOperands>}; }

}  // namespace lambert::bench
