#include "lambert/image/composite/pointwise.h"

#include "lambert/base/error.h"
#include "lambert/image/composite/adjust.h"
#include "lambert/image/composite/key.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lambert::composite {
namespace {

/// A row function from one of pixels.
template <class F>
RowFunction each_pixel(F function) {
  return [function](const Row& row) {
    float *__restrict r = row.r.data(), *__restrict g = row.g.data(), *__restrict b = row.b.data(),
          *__restrict a = row.a.data();
    for (std::size_t x = 0; x < row.r.size(); ++x) {
      const Pixel p = function(Pixel{r[x], g[x], b[x], a[x]});
      r[x] = p.r, g[x] = p.g, b[x] = p.b, a[x] = p.a;
    }
  };
}

/// With the pixel of the second input.
template <class F>
RowFunction each_pair(F function) {
  return [function](const Row& row) {
    const auto r = row.second->row(red_channel, row.y), g = row.second->row(green_channel, row.y),
               b = row.second->row(blue_channel, row.y), a = row.second->row(alpha_channel, row.y);
    for (std::size_t x = 0; x < row.r.size(); ++x) {
      const Pixel p = function(Pixel{row.r[x], row.g[x], row.b[x], row.a[x]}, Pixel{r[x], g[x], b[x], a[x]});
      row.r[x] = p.r, row.g[x] = p.g, row.b[x] = p.b, row.a[x] = p.a;
    }
  };
}

/// The same function of two values in every main channel.
template <class F>
RowFunction each_channel(F function) {
  return [function](const Row& row) {
    for (std::size_t c = 0; c < first_extra; ++c) {
      float* __restrict to = row.band.row(c, row.y).data();
      const float* __restrict from = row.second->row(c, row.y).data();
      for (std::size_t x = 0; x < row.r.size(); ++x) to[x] = function(to[x], from[x]);
    }
  };
}

Shape matte_shape(const Element& input, bool everywhere) {
  Shape shape{.data = input.shape().data, .display = input.shape().display};
  if (everywhere) shape.data.reset();
  return shape;
}

template <class F>
ElementPtr matte_from(ElementPtr input, bool everywhere, F function) {
  Shape shape = matte_shape(*input, everywhere);
  return rowwise(std::move(shape), std::move(input), nullptr,
                 each_pixel([function](Pixel p) { return matte_pixel(function(p)); }));
}

float luminance_of(Pixel p) { return luminance({p.r, p.g, p.b}); }

/// `cut`: the result has an alpha also where the input has none of its own.
template <class F>
ElementPtr changed(ElementPtr input, F function, bool cut = false) {
  Shape shape = input->shape();
  shape.has_alpha = shape.has_alpha || cut;
  return rowwise(std::move(shape), std::move(input), nullptr, each_pixel(function));
}

std::size_t channel_of(const Element& input, const std::string& name) {
  const auto index = input.shape().channel(name);
  if (!index) throw Error("no channel " + unknown_word(name, input.shape().channels));
  return *index;
}

/// A ramp of a channel; of Z, what covers nothing is infinitely far away.
ElementPtr channel_matte(ElementPtr input, const std::string& name, float low, float high) {
  const std::size_t index = channel_of(*input, name);
  const bool depth = name == "Z";
  Shape shape = matte_shape(*input, depth);
  return rowwise(std::move(shape), std::move(input), nullptr, [=](const Row& row) {
    const auto values = row.band.row(index, row.y);
    for (std::size_t x = 0; x < values.size(); ++x) {
      const float value = !depth ? values[x] : row.a[x] > 0 ? distance_of(values[x]) : distance_of(0);
      row.r[x] = ramp(value, low, high);
    }
    for (const auto to : {row.g, row.b, row.a}) std::ranges::copy(row.r, to.begin());
  });
}

/// Everything mixed by `amount`, extra layers too.
ElementPtr dissolved(ElementPtr input, float amount) {
  Shape shape = input->shape();
  shape.has_alpha = true;
  const std::vector<std::string> channels = shape.channels;
  return rowwise(std::move(shape), std::move(input), nullptr, [amount, channels](const Row& row) {
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const auto to = row.band.row(c, row.y);
      if (amount > 0 && is_sampled(channels[c])) continue;
      const float nothing = nothing_of(channels[c]);
      for (float& v : to) v = amount > 0 ? amount * v : nothing;
    }
  });
}

}  // namespace

ElementPtr arithmetic(Verb verb, ElementPtr a, ElementPtr b) {
  Shape shape = a->shape();
  const bool postfix = verb == Verb::multiply || verb == Verb::screen;
  if (!postfix || !shape.display) shape.display = b->shape().display ? b->shape().display : shape.display;
  shape.has_alpha = shape.has_alpha || b->shape().has_alpha;
  if (shape.data) {
    const std::optional<Window>& other = b->shape().data;
    shape.data = other ? std::optional(united(*shape.data, *other)) : std::nullopt;
  }
  const auto rows = [&]() -> RowFunction {
    switch (verb) {
      case Verb::minus: return each_channel([](float p, float q) { return p - q; });
      case Verb::difference: return each_channel([](float p, float q) { return std::abs(p - q); });
      case Verb::max: return each_channel([](float p, float q) { return p > q ? p : q; });
      case Verb::min: return each_channel([](float p, float q) { return p < q ? p : q; });
      case Verb::multiply: return each_channel([](float p, float q) { return p * q; });
      default: return each_channel([](float p, float q) { return screen(p, q); });
    }
  };
  return rowwise(std::move(shape), std::move(a), std::move(b), rows());
}

ElementPtr matte_of(ElementPtr input) {
  if (!input->shape().has_alpha) return matte_from(std::move(input), false, luminance_of);
  return matte_from(std::move(input), false, [](Pixel p) { return p.a; });
}

ElementPtr pointwise(Verb verb, const std::vector<float>& n, const std::string& text, ElementPtr input,
                     ElementPtr second) {
  const auto colour = [&] { return Rgb(n[0], n[1], n[2]); };
  switch (verb) {
    case Verb::matte: return matte_of(std::move(input));
    case Verb::invert: {
      if (input->shape().has_alpha) return matte_from(std::move(input), true, [](Pixel p) { return 1 - p.a; });
      return matte_from(std::move(input), true, [](Pixel p) { return 1 - luminance_of(p); });
    }
    case Verb::luminance:
      return matte_from(std::move(input), false,
                        [low = n[0], high = n[1]](Pixel p) { return ramp(luminance_of(p), low, high); });
    case Verb::channel: return channel_matte(std::move(input), text, n[0], n[1]);
    case Verb::depth_matte: return channel_matte(std::move(input), "Z", n[0], n[1]);
    case Verb::key_colour: {
      const ColourKey key{.colour = colour(), .inner = n[3], .outer = n[4], .spill = n[5]};
      check(key);
      return changed(
          std::move(input), [key](Pixel p) { return apply(key, p); }, true);
    }
    case Verb::key_screen: {
      const ScreenKey key{.colour = colour(), .low = n[3], .high = n[4], .spill = n[5]};
      check(key);
      return changed(
          std::move(input), [key](Pixel p) { return apply(key, p); }, true);
    }
    case Verb::key_difference: {
      const DifferenceKey key{n[0], n[1]};
      check(key);
      Shape shape = input->shape();
      shape.has_alpha = true;
      return rowwise(std::move(shape), std::move(input), std::move(second),
                     each_pair([key](Pixel p, Pixel clean) { return apply(key, p, clean); }));
    }
    case Verb::despill: {
      const Rgb key = colour();
      return changed(std::move(input), [key, amount = n[3]](Pixel p) {
        const Rgb c = suppress_spill({p.r, p.g, p.b}, key, amount);
        return Pixel{c.r, c.g, c.b, p.a};
      });
    }
    case Verb::darken: return changed(std::move(input), [f = n[0]](Pixel p) { return darken(p, f); });
    case Verb::dissolve: return dissolved(std::move(input), n[0]);
    case Verb::opaque:
      return changed(
          std::move(input), [w = n[0]](Pixel p) { return opaque(p, w); }, true);
    case Verb::exposure: return changed(std::move(input), [f = std::exp2(n[0])](Pixel p) { return darken(p, f); });
    case Verb::gain:
      return changed(std::move(input), [k = colour()](Pixel p) { return Pixel{k.r * p.r, k.g * p.g, k.b * p.b, p.a}; });
    case Verb::saturation:
      return changed(std::move(input), [s = n[0]](Pixel p) {
        const float y = luminance_of(p);
        return Pixel{y + s * (p.r - y), y + s * (p.g - y), y + s * (p.b - y), p.a};
      });
    case Verb::clamp: return changed(std::move(input), [](Pixel p) { return clamp(p); });
    case Verb::premultiply: return changed(std::move(input), [](Pixel p) { return premultiply(p); });
    case Verb::unpremultiply: return changed(std::move(input), [](Pixel p) { return unpremultiply(p); });
    default: throw Error("is not done pixel by pixel");
  }
}

}  // namespace lambert::composite
