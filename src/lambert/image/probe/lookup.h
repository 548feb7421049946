#pragma once
#include "lambert/image/probe/directions.h"
#include "lambert/image/probe/layout.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lambert::probe {

/// Where directions lie among the texels of a Lookup: which four, and the place between them.
struct Places {
  std::vector<std::uint32_t> texel;  // the upper left one
  std::vector<float> across, down;   // 0 to 1
};

/// A map that can be looked up between its texels: bilinear, across the edges of charts, over poles, and at the rim of
/// a disk from within. In rows of a lat-long map whose texels are less than half as wide as high, near the poles, the
/// columns are averaged to that width first: they say more than the rows can.
class Lookup {
 public:
  /// Values must be finite.
  explicit Lookup(const Probe& probe);

  std::size_t channel_count() const { return channels_; }
  const Probe& probe() const { return *probe_; }
  /// What is seen along a direction, 0 where the map shows nothing.
  Rgb rgb(Vec3 direction) const;

  /// The same for many and all channels: where they lie, and Σ weights[i] · value of place first + i, added to `sums`
  /// (stride() floats).
  void find(const Directions& directions, Places& places) const;
  void add(const Places& places, std::size_t first, std::span<const float> weights, std::span<float> sums) const;
  std::size_t stride() const { return stride_; }  ///< channels rounded up to a multiple of 4

  /// The angle between neighbouring texels about a direction, along the coarser axis (but at most four times the finer
  /// one); infinite where the map shows nothing.
  float texel_angle(Vec3 direction) const;

 private:
  float* texel(int chart, int x, int y) const;
  void build_chart(int chart);
  void extend(int chart, int x, int y);
  template <class P>
  void find_all(const P& projection, std::size_t count, const float* __restrict dx, const float* __restrict dy,
                const float* __restrict dz, std::uint32_t* __restrict texels, float* __restrict across,
                float* __restrict down) const;

  const Probe* probe_;
  int width_, height_;  // of a chart without its border of one texel
  std::size_t channels_, stride_;
  bool colour_ = false;
  Vec2 scale_, shift_;        // from uv to texels of the stored, bordered chart
  std::uint32_t row_, dark_;  // texels of a bordered row; the first of four that hold 0, for what the map does not show
  std::unique_ptr<float[]> values_;
};

}  // namespace lambert::probe
