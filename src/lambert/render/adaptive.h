#pragma once
/// How many samples each pixel gets, without bias.
///
/// Stopping when the samples so far look good favours lucky samples (Kirk and Arvo, "Unbiased Sampling Techniques for
/// Image Synthesis", 1991). Here a pixel is estimated by two independent halves A and B, averaged with equal weights.
/// The length of A is decided once, by B's pilot samples alone, and that of B by A's: given B, the samples of A are as
/// many as they are whatever they are, so E[mean A] is the pixel's value, likewise E[mean B], and hence that of their
/// average.

#include "lambert/render/film.h"

#include <cstdint>
#include <vector>

namespace lambert {

inline constexpr std::uint32_t pilot_samples = 16;  ///< per half and pixel

/// Samples wanted per pixel of a crop.
class SampleMap {
 public:
  SampleMap(const PixelRect& crop, std::uint32_t initial) : crop_(crop), counts_(crop.area(), initial) {}
  std::uint32_t at(Vec2i p) const { return counts_[index(p)]; }
  void set(Vec2i p, std::uint32_t n) { counts_[index(p)] = n; }
  std::uint64_t total() const;

 private:
  std::size_t index(Vec2i p) const {
    return static_cast<std::size_t>(p.y - crop_.min.y) * static_cast<std::size_t>(crop_.size().x) +
           static_cast<std::size_t>(p.x - crop_.min.x);
  }
  PixelRect crop_;
  std::vector<std::uint32_t> counts_;
};

/// Samples for each pixel of one half so that, with as many in the other half, the standard error of the average is
/// `target_error` times the pixel's luminance (or that of a dark grey, 0.05, where the pixel is darker). Judged by
/// `pilot`, the film of the other half; its variances are averaged over 5x5 pixels, since 16 samples know little of
/// rare events.
SampleMap plan_samples(const Film& pilot, double target_error, std::uint32_t at_least, std::uint32_t at_most);

}  // namespace lambert
