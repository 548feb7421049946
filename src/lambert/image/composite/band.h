#pragma once
#include "lambert/image/image.h"

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace lambert::composite {

/// Pixels of a rectangle of the plane, each channel a plane of its own. Its memory comes from a BandPool.
class Band {
 public:
  const Window& window() const { return window_; }
  std::size_t channel_count() const { return channels_; }
  /// The same pixels at another place.
  void move_to(int x, int y) { window_.x = x, window_.y = y; }
  std::size_t width() const { return static_cast<std::size_t>(window_.width); }
  /// Row `y` of the plane, in the window.
  std::span<float> row(std::size_t channel, int y) { return {pixels_.get() + offset(channel, y), width()}; }
  std::span<const float> row(std::size_t channel, int y) const { return {pixels_.get() + offset(channel, y), width()}; }
  std::span<float> pixels() { return {pixels_.get(), channels_ * width() * static_cast<std::size_t>(window_.height)}; }
  std::span<float> plane(std::size_t channel) {
    return {pixels_.get() + offset(channel, window_.y), width() * static_cast<std::size_t>(window_.height)};
  }

 private:
  friend class BandPool;
  std::size_t offset(std::size_t channel, int y) const {
    const auto rows = channel * static_cast<std::size_t>(window_.height) + static_cast<std::size_t>(y - window_.y);
    return rows * width();
  }
  Window window_;
  std::size_t channels_ = 0, capacity_ = 0;
  std::unique_ptr<float[]> pixels_;
};

/// Thrown by a BandPool that was told to stop.
struct Stopped {};

/// Keeps what is given back for the next band, so that memory is touched once.
class BandPool {
 public:
  explicit BandPool(std::stop_token stop = {}) : stop_(std::move(stop)) {}
  /// Its pixels are not set. Throws Error when it is too large, and Stopped.
  Band take(const Window& window, std::size_t channels);
  void give(Band&& band);
  /// The most floats that were taken at one time.
  std::size_t peak() const { return peak_; }

 private:
  std::stop_token stop_;
  std::vector<Band> kept_;
  std::size_t taken_ = 0, peak_ = 0;
};

bool is_empty(const Window& w);
/// What lies in both; empty (no width) when nothing does.
Window intersection(const Window& a, const Window& b);
/// The least window that holds both, of which an empty one does not count. Throws Error when it is too large.
Window united(const Window& a, const Window& b);
/// Moved by (x, y). Throws Error when it goes too far.
Window shifted(const Window& w, int x, int y);
/// `margin` further on all sides; what is empty stays so. Throws Error when it is too large.
Window grown(const Window& w, int margin);

}  // namespace lambert::composite
