#pragma once
#include "lambert/image/probe/layout.h"

#include <span>
#include <vector>

namespace lambert::probe {

/// A map that can be looked up between its texels: bilinear, across the edges of charts, over poles, and at the rim of
/// a disk from within. In rows of a lat-long map whose texels are less than half as wide as high, near the poles, the
/// columns are averaged to that width first: they say more than the rows can.
class Lookup {
 public:
  /// Values must be finite.
  explicit Lookup(const Probe& probe);

  std::size_t channel_count() const { return channels_; }
  const Probe& probe() const { return *probe_; }
  /// One direction's values, 0 where the map shows nothing.
  void read(Vec3 direction, std::span<float> values) const;
  Rgb rgb(Vec3 direction) const;

  /// Σ weight · value over many directions, added to `sums` (stride() floats). Directions that the map does not show
  /// add nothing.
  void add(std::span<const Vec3> directions, std::span<const float> weights, std::span<float> sums) const;
  std::size_t stride() const { return stride_; }  ///< channels rounded up to a multiple of 4

  /// The angle between neighbouring texels about a direction, along the coarser axis (but at most four times the finer
  /// one); infinite where the map shows nothing.
  float texel_angle(Vec3 direction) const;

 private:
  const float* texel(int chart, int x, int y) const;
  void build_chart(int chart);
  void extend(int chart, int x, int y);
  template <class P>
  void add_all(const P& projection, std::span<const Vec3>, std::span<const float>, float* sums) const;

  const Probe* probe_;
  int width_, height_;  // of a chart without its border of one texel
  std::size_t channels_, stride_;
  bool colour_ = false;
  Vec2 scale_, shift_;  // from uv to texels of the stored, bordered chart
  std::vector<float> values_;
};

}  // namespace lambert::probe
