#include "lambert/image/composite/elements.h"
#include "lambert/image/filter/blur.h"
#include "lambert/image/filter/morphology.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::composite {
namespace {

/// Beyond it a Gaussian leaves 6e-7 of its weight.
constexpr double blur_reach = 5;

int reach_of(Neighbourhood kind, double radius) {
  return static_cast<int>(kind == Neighbourhood::blur ? std::ceil(blur_reach * radius) : std::round(radius));
}

Shape shape_of(Neighbourhood kind, int reach, const Element& input) {
  Shape shape = input.shape();
  if (kind == Neighbourhood::edge) shape.channels = Shape().channels;
  const bool spreads = kind != Neighbourhood::erode && (kind != Neighbourhood::blur || shape.has_alpha);
  if (shape.data && spreads) shape.data = grown(*shape.data, reach);
  return shape;
}

class NeighbourhoodElement final : public Element {
 public:
  NeighbourhoodElement(Neighbourhood kind, double radius, ElementPtr input)
      : Element(shape_of(kind, reach_of(kind, radius), *input)),
        kind_(kind),
        radius_(radius),
        reach_(reach_of(kind, radius)),
        input_(std::move(input)) {
    bands_needed_ = input_->bands_needed() + 2;  // two for the filter's own copies
    margin_ = input_->margin() + reach_;
    source_ = input_->source();
  }

  Band pull(const Window& region, BandPool& pool) override {
    if (is_empty(covered(shape_, region))) return nothing(region, pool);
    const Window wide = grown(region, reach_);
    Band from = input_->pull(wide, pool);
    Band to = pool.take(region, shape_.channels.size());
    for (std::size_t c = 0; c < shape_.channels.size(); ++c)
      for (int y = region.y; y < region.y + region.height; ++y)
        std::ranges::copy(from.row(c, y).subspan(static_cast<std::size_t>(reach_), to.width()), to.row(c, y).begin());
    switch (kind_) {
      case Neighbourhood::blur: blur(from, to); break;
      case Neighbourhood::erode: erode(from, to); break;
      case Neighbourhood::dilate: dilate(from, to); break;
      case Neighbourhood::edge: edge(from, to); break;
    }
    pool.give(std::move(from));
    return to;
  }

 private:
  Band nothing(const Window& region, BandPool& pool) const {
    Band band = pool.take(region, shape_.channels.size());
    clear_outside(shape_, band);
    return band;
  }

  static Image plane(Band& from, std::size_t channel) {
    Image image(from.window().width, from.window().height, {"Y"});
    std::ranges::copy(from.plane(channel), image.pixels().begin());
    return image;
  }
  std::span<const float> middle(const Image& image, int y, const Band& to) const {
    return image.row(y - to.window().y + reach_).subspan(static_cast<std::size_t>(reach_), to.width());
  }

  void blur(Band& from, Band& to) const {
    const float sigma = static_cast<float>(radius_);
    for (std::size_t c = 0; c < first_extra; ++c) {
      const Image blurred = gaussian_blurred(plane(from, c), {sigma, sigma}, EdgeMode::clamp, GaussianMethod::direct);
      for (int y = to.window().y; y < to.window().y + to.window().height; ++y)
        std::ranges::copy(middle(blurred, y, to), to.row(c, y).begin());
    }
    if (!shape_.has_alpha) renew_coverage(to);
  }

  /// A picture without alpha stays whole: what the blur took of its edge from outside is made up for.
  void renew_coverage(Band& to) const {
    for (int y = to.window().y; y < to.window().y + to.window().height; ++y) {
      const auto a = to.row(alpha_channel, y);
      for (const std::size_t c : {red_channel, green_channel, blue_channel}) {
        const auto row = to.row(c, y);
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = a[x] > 0 ? row[x] / a[x] : 0.0f;
      }
      std::ranges::fill(a, 1.0f);
    }
    clear_outside(shape_, to);
  }

  /// Colour and alpha in the proportion of the smaller alpha to the old one.
  void erode(Band& from, Band& to) const {
    const Image least = eroded(plane(from, alpha_channel), {reach_, reach_});
    for (int y = to.window().y; y < to.window().y + to.window().height; ++y) {
      const auto small = middle(least, y, to);
      const auto a = to.row(alpha_channel, y);
      for (const std::size_t c : {red_channel, green_channel, blue_channel}) {
        const auto row = to.row(c, y);
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = a[x] > 0 ? row[x] * (small[x] / a[x]) : 0.0f;
      }
      std::ranges::copy(small, a.begin());
    }
  }

  /// As erode() where there is colour; where there is none, the greatest of the colours around.
  void dilate(Band& from, Band& to) const {
    const Image greatest = dilated(plane(from, alpha_channel), {reach_, reach_});
    for (const std::size_t c : {red_channel, green_channel, blue_channel}) {
      const Image colour = dilated(plane(from, c), {reach_, reach_});
      for (int y = to.window().y; y < to.window().y + to.window().height; ++y) {
        const auto large = middle(greatest, y, to), around = middle(colour, y, to);
        const auto row = to.row(c, y), a = to.row(alpha_channel, y);
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = a[x] > 0 ? row[x] * (large[x] / a[x]) : around[x];
      }
    }
    for (int y = to.window().y; y < to.window().y + to.window().height; ++y)
      std::ranges::copy(middle(greatest, y, to), to.row(alpha_channel, y).begin());
  }

  void edge(Band& from, Band& to) const {
    const Image a = plane(from, alpha_channel);
    const Image greatest = dilated(a, {reach_, reach_}), least = eroded(a, {reach_, reach_});
    for (int y = to.window().y; y < to.window().y + to.window().height; ++y) {
      const auto large = middle(greatest, y, to), small = middle(least, y, to);
      for (std::size_t c = 0; c < first_extra; ++c) {
        const auto row = to.row(c, y);
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = large[x] - small[x];
      }
    }
  }

  Neighbourhood kind_;
  double radius_;
  int reach_;
  ElementPtr input_;
};

}  // namespace

ElementPtr neighbourhood(Neighbourhood kind, double radius, ElementPtr input) {
  if (kind != Neighbourhood::edge && reach_of(kind, radius) == 0) return input;
  return std::make_unique<NeighbourhoodElement>(kind, radius, std::move(input));
}

}  // namespace lambert::composite
