#include "lambert/image/composite/elements.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <utility>

namespace lambert::composite {
namespace {

class RowElement final : public Element {
 public:
  RowElement(Shape shape, ElementPtr input, ElementPtr second, RowFunction function)
      : Element(std::move(shape)),
        input_(std::move(input)),
        second_(std::move(second)),
        function_(std::move(function)) {
    bands_needed_ = input_->bands_needed();
    margin_ = input_->margin();
    source_ = input_->source();
    if (!second_) return;
    const std::size_t m = input_->bands_needed(), n = second_->bands_needed();
    bands_needed_ = std::max(std::max(m, n), std::min(m, n) + 1);
    margin_ = std::max(margin_, second_->margin());
    if (!source_) source_ = second_->source();
  }

  Band pull(const Window& region, BandPool& pool) override {
    std::optional<Band> second;
    const bool second_first = second_ && second_->bands_needed() > input_->bands_needed();
    if (second_first) second = second_->pull(region, pool);
    Band band = input_->pull(region, pool);
    if (second_ && !second_first) second = second_->pull(region, pool);
    const Band* other = second ? &*second : nullptr;
    parallel_for(static_cast<std::size_t>(region.height), [&](std::size_t row) {
      const int y = region.y + static_cast<int>(row);
      function_({band.row(red_channel, y), band.row(green_channel, y), band.row(blue_channel, y),
                 band.row(alpha_channel, y), band, other, y});
    });
    if (shape_.data) clear_outside(shape_, band);
    if (second) pool.give(std::move(*second));
    return band;
  }

 private:
  ElementPtr input_, second_;
  RowFunction function_;
};

}  // namespace

ElementPtr rowwise(Shape shape, ElementPtr input, ElementPtr second, RowFunction function) {
  return std::make_unique<RowElement>(std::move(shape), std::move(input), std::move(second), std::move(function));
}

}  // namespace lambert::composite
