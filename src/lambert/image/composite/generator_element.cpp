#include "lambert/image/composite/elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lambert::composite {
namespace {

class GeneratedElement final : public Element {
 public:
  GeneratedElement(Shape shape, Generator matte) : Element(std::move(shape)), matte_(std::move(matte)) {}
  Band pull(const Window& region, BandPool& pool) override {
    Band band = pool.take(region, shape_.channels.size());
    const Window inside = covered(shape_, region);
    for (int y = inside.y; y < inside.y + inside.height; ++y) {
      const auto row = band.row(red_channel, y);
      for (int x = inside.x; x < inside.x + inside.width; ++x)
        row[static_cast<std::size_t>(x - region.x)] =
            matte_(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      for (const std::size_t c : {green_channel, blue_channel, alpha_channel})
        std::ranges::copy(row, band.row(c, y).begin());
    }
    clear_outside(shape_, band);
    return band;
  }

 private:
  Generator matte_;
};

class ConstantElement final : public Element {
 public:
  explicit ConstantElement(Pixel pixel) : Element({}), values_{pixel.r, pixel.g, pixel.b, pixel.a} {}
  Band pull(const Window& region, BandPool& pool) override {
    Band band = pool.take(region, shape_.channels.size());
    for (std::size_t c = 0; c < values_.size(); ++c) std::ranges::fill(band.plane(c), values_[c]);
    return band;
  }

 private:
  std::array<float, 4> values_;
};

}  // namespace

ElementPtr generated(Shape shape, Generator matte) {
  return std::make_unique<GeneratedElement>(std::move(shape), std::move(matte));
}
ElementPtr constant(Pixel pixel) { return std::make_unique<ConstantElement>(pixel); }

}  // namespace lambert::composite
