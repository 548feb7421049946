#include "lambert/image/composite/band.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace lambert::composite {
namespace {

/// From corners, of which `x1` and `y1` are behind the last pixel.
Window window_of(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  constexpr std::int64_t farthest = std::numeric_limits<int>::max();
  if (x1 <= x0 || y1 <= y0) return {};
  if (x0 < -farthest || y0 < -farthest || x1 > farthest || y1 > farthest || x1 - x0 > farthest || y1 - y0 > farthest)
    throw Error("the elements lie too far apart on the plane");
  return {static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1 - x0), static_cast<int>(y1 - y0)};
}
std::int64_t right(const Window& w) { return std::int64_t{w.x} + w.width; }
std::int64_t bottom(const Window& w) { return std::int64_t{w.y} + w.height; }

}  // namespace

Band BandPool::take(const Window& window, std::size_t channels) {
  if (stop_.stop_requested()) throw Stopped();
  constexpr std::uint64_t most_floats = std::uint64_t{1} << 31;
  const std::uint64_t pixels = static_cast<std::uint64_t>(window.width) * static_cast<std::uint64_t>(window.height);
  if (channels > 0 && pixels > most_floats / channels)
    throw Error("a band of " + std::to_string(window.width) + "x" + std::to_string(window.height) +
                " pixels is too large");
  const auto size = static_cast<std::size_t>(pixels) * channels;
  const auto fits = std::find_if(kept_.begin(), kept_.end(), [&](const Band& b) { return b.capacity_ >= size; });
  Band band;
  if (fits != kept_.end()) {
    band = std::move(*fits);
    kept_.erase(fits);
  } else {
    if (!kept_.empty()) kept_.pop_back();
    band.pixels_ = std::make_unique_for_overwrite<float[]>(std::max<std::size_t>(size, 1));
    band.capacity_ = size;
  }
  band.window_ = window;
  band.channels_ = channels;
  taken_ += band.capacity_;
  peak_ = std::max(peak_, taken_);
  return band;
}

void BandPool::give(Band&& band) {
  if (!band.pixels_) return;
  taken_ -= band.capacity_;
  kept_.push_back(std::move(band));
}

bool is_empty(const Window& w) { return w.width <= 0 || w.height <= 0; }

Window intersection(const Window& a, const Window& b) {
  if (is_empty(a) || is_empty(b)) return {};
  return window_of(std::max(a.x, b.x), std::max(a.y, b.y), std::min(right(a), right(b)),
                   std::min(bottom(a), bottom(b)));
}

Window united(const Window& a, const Window& b) {
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return window_of(std::min(a.x, b.x), std::min(a.y, b.y), std::max(right(a), right(b)),
                   std::max(bottom(a), bottom(b)));
}

Window shifted(const Window& w, int x, int y) {
  if (is_empty(w)) return {};
  return window_of(std::int64_t{w.x} + x, std::int64_t{w.y} + y, right(w) + x, bottom(w) + y);
}

Window grown(const Window& w, int margin) {
  if (is_empty(w)) return {};
  const std::int64_t m = margin;
  return window_of(w.x - m, w.y - m, right(w) + m, bottom(w) + m);
}

}  // namespace lambert::composite
