#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace lambert::denoise {

/// One number a pixel, rows from the top.
class Plane {
 public:
  Plane() = default;
  Plane(int width, int height, float value = 0)
      : width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return values_.empty(); }
  float* row(int y) { return values_.data() + static_cast<std::ptrdiff_t>(y) * width_; }
  const float* row(int y) const { return values_.data() + static_cast<std::ptrdiff_t>(y) * width_; }
  float& at(int x, int y) { return row(y)[x]; }
  float at(int x, int y) const { return row(y)[x]; }
  std::vector<float>& values() { return values_; }
  const std::vector<float>& values() const { return values_; }

 private:
  int width_ = 0, height_ = 0;
  std::vector<float> values_;
};

/// R, G, B.
using Colour = std::array<Plane, 3>;
Colour black(int width, int height);

/// A plane with `pad` more pixels on each side, which repeat its edge: row(y)[x] may be read for x and y from -pad to
/// size + pad - 1, and some numbers behind the end of each row.
class PaddedPlane {
 public:
  PaddedPlane() = default;
  PaddedPlane(const Plane& plane, int pad);
  const float* row(int y) const { return values_.data() + static_cast<std::ptrdiff_t>(y + pad_) * stride_ + pad_; }

 private:
  int pad_ = 0, stride_ = 0;
  std::vector<float> values_;
};

/// The mean over (2 radius + 1)² pixels, fewer at the edges.
Plane box_mean(const Plane& plane, int radius);

}  // namespace lambert::denoise
