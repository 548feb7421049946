#pragma once
/// Elements are what compositing trees are evaluated as: pictures that are asked for rectangles of themselves and ask
/// their inputs in turn, so that a tree of any depth holds few bands at a time.

#include "lambert/image/composite/band.h"
#include "lambert/image/stream.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::composite {

/// Of every element the first four channels are R, G, B and A, whatever its file has; others follow.
inline constexpr std::size_t red_channel = 0, green_channel = 1, blue_channel = 2, alpha_channel = 3, first_extra = 4;

struct Shape {
  std::optional<Window> data;     ///< nothing outside it; without it the element is everywhere
  std::optional<Window> display;  ///< none for what is generated
  std::vector<std::string> channels{"R", "G", "B", "A"};
  bool has_alpha = true;  ///< false: the A of a picture that has none, 1 in its data window
  std::optional<std::size_t> channel(std::string_view name) const;
};

/// True for channels whose values cannot be mixed: Z, numbers of objects, counts, variances.
bool is_sampled(std::string_view channel);
/// What a channel has where there is nothing: infinity for Z, else 0.
float nothing_of(std::string_view channel);

/// Z as a distance: what is not above 0, as renderers store it where they saw nothing, and NaN are infinitely far.
inline float distance_of(float z) { return z > 0 ? z : std::numeric_limits<float>::infinity(); }

class Element {
 public:
  explicit Element(Shape shape) : shape_(std::move(shape)) {}
  virtual ~Element() = default;
  const Shape& shape() const { return shape_; }
  /// All of `region`, which may reach out of the data window, where every channel is nothing_of() it. The band may have
  /// further channels behind those of the shape.
  virtual Band pull(const Window& region, BandPool& pool) = 0;
  /// Bands that are held at a time at most, by the order in which inputs are asked.
  std::size_t bands_needed() const { return bands_needed_; }
  /// By how many rows the regions asked of the inputs reach above and below that asked for.
  int margin() const { return margin_; }
  /// The file whose metadata the result keeps; null where there is none.
  const ImageHeader* source() const { return source_; }

 protected:
  Shape shape_;
  std::size_t bands_needed_ = 1;
  int margin_ = 0;
  const ImageHeader* source_ = nullptr;
};
using ElementPtr = std::unique_ptr<Element>;

/// The part of `region` in which the element is.
Window covered(const Shape& shape, const Window& region);
/// Sets what is outside of the element in its own `band` to nothing.
void clear_outside(const Shape& shape, Band& band);

}  // namespace lambert::composite
