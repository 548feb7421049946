#pragma once
/// The kinds of elements that plan.cpp makes trees of.

#include "lambert/image/composite/element.h"
#include "lambert/image/composite/pictures.h"
#include "lambert/image/composite/porter_duff.h"

#include <functional>
#include <string>
#include <vector>

namespace lambert::composite {

/// Which channels of a tree somebody looks at, besides R, G, B and A.
struct Wanted {
  bool all = false;
  std::vector<std::string> names;
  bool has(std::string_view name) const;
};

/// A file: R, G, B and A of it (a "Y" thrice where it has no colour, A = 1 where it has none) and what else is wanted.
ElementPtr picture(Pictures& pictures, const std::string& file, const Wanted& wanted);

/// A op B over the union of both data windows. Extra channels are those of both: layers (albedo.R …) go as the colours
/// do, with the picture's alpha; what is_sampled() is chosen. The display window is B's, or else A's.
ElementPtr combined(Operator op, ElementPtr a, ElementPtr b);
/// By Z: what is nearer lies over the other, A where both are equally near. Where alpha is 0 or Z is not a number,
/// there is nothing, infinitely far away; so is all of an element without Z. The result's Z is the nearer one.
ElementPtr depth_combined(ElementPtr a, ElementPtr b);

/// The four main channels of a row, and all of the band that they are in.
struct Row {
  std::span<float> r, g, b, a;
  Band& band;
  const Band* second;  ///< null without a second input; of the same window
  int y;
};
using RowFunction = std::function<void(const Row&)>;
/// Changes pixels one by one; several rows at a time. What is outside of `shape` is set to nothing. Extra channels stay
/// as far as they are in `shape`, whose channels are the first ones of the first input's.
ElementPtr rowwise(Shape shape, ElementPtr input, ElementPtr second, RowFunction function);
/// All channels from a function of the pixel centre.
using Generator = std::function<float(float x, float y)>;
ElementPtr generated(Shape shape, Generator matte);
ElementPtr constant(Pixel pixel);
/// Coverage of each pixel by the inside of a closed polygon (non-zero winding), exact but for rounding where its edges
/// do not cross in the pixel. `points` are x0, y0, x1, y1 ….
ElementPtr polygon_matte(const std::vector<float>& points);

enum class Neighbourhood { blur, erode, dilate, edge };
/// See language.cpp; `radius` is the standard deviation of the blur, and is rounded for the others.
ElementPtr neighbourhood(Neighbourhood kind, double radius, ElementPtr input);

ElementPtr translated(double x, double y, ElementPtr input);
ElementPtr cropped(const Window& window, ElementPtr input);
/// The channels `name`.R … as the colour; those of a layer of one channel thrice. Throws Error naming the layers that
/// there are.
ElementPtr layer(const std::string& name, ElementPtr input);

}  // namespace lambert::composite
