#include "lambert/image/composite/elements.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::composite {
namespace {

/// Of an element that asks one other.
class OneInput : public Element {
 protected:
  OneInput(Shape shape, ElementPtr&& input) : Element(std::move(shape)), input_(std::move(input)) {
    bands_needed_ = input_->bands_needed();
    margin_ = input_->margin();
    source_ = input_->source();
  }
  ElementPtr input_;
};

class CroppedElement final : public OneInput {
 public:
  CroppedElement(Shape shape, ElementPtr input) : OneInput(std::move(shape), std::move(input)) {}
  Band pull(const Window& region, BandPool& pool) override {
    if (is_empty(covered(shape_, region))) {
      Band band = pool.take(region, shape_.channels.size());
      clear_outside(shape_, band);
      return band;
    }
    Band band = input_->pull(region, pool);
    clear_outside(shape_, band);
    return band;
  }
};

int whole(double v) { return static_cast<int>(std::floor(v)); }

Shape moved(const Shape& of, double x, double y) {
  Shape shape = of;
  if (!shape.data || is_empty(*shape.data)) return shape;
  const bool between_x = x != std::floor(x), between_y = y != std::floor(y);
  const Window there = shifted(*shape.data, whole(x), whole(y));
  shape.data = united(there, shifted(there, between_x ? 1 : 0, between_y ? 1 : 0));
  return shape;
}

class TranslatedElement final : public OneInput {
 public:
  TranslatedElement(double x, double y, ElementPtr input)
      : OneInput(moved(input->shape(), x, y), std::move(input)),
        x_(whole(x)),
        y_(whole(y)),
        fraction_x_(static_cast<float>(x - x_)),
        fraction_y_(static_cast<float>(y - y_)) {
    margin_ += fraction_y_ > 0 ? 1 : 0;
    if (is_between()) ++bands_needed_;
  }

  Band pull(const Window& region, BandPool& pool) override {
    Window asked = shifted(region, -x_, -y_);
    if (!is_between()) {
      Band band = input_->pull(asked, pool);
      band.move_to(region.x, region.y);
      return band;
    }
    // A pixel shows (1 - fraction) of its own place and the rest of the one before it.
    asked = {asked.x - 1, asked.y - 1, asked.width + 1, asked.height + 1};
    Band from = input_->pull(asked, pool);
    Band to = pool.take(region, shape_.channels.size());
    for (std::size_t c = 0; c < shape_.channels.size(); ++c)
      for (int y = 0; y < region.height; ++y) {
        const auto upper = from.row(c, asked.y + y), lower = from.row(c, asked.y + y + 1);
        const auto row = to.row(c, region.y + y);
        if (is_sampled(shape_.channels[c])) {
          const auto& nearest = fraction_y_ < 0.5f ? lower : upper;
          std::ranges::copy(nearest.subspan(fraction_x_ < 0.5f ? 1 : 0, row.size()), row.begin());
          continue;
        }
        const float u = fraction_x_, v = fraction_y_;
        for (std::size_t x = 0; x < row.size(); ++x)
          row[x] = (1 - v) * ((1 - u) * lower[x + 1] + u * lower[x]) + v * ((1 - u) * upper[x + 1] + u * upper[x]);
      }
    pool.give(std::move(from));
    return to;
  }

 private:
  bool is_between() const { return fraction_x_ > 0 || fraction_y_ > 0; }
  int x_, y_;
  float fraction_x_, fraction_y_;
};

class LayerElement final : public OneInput {
 public:
  LayerElement(Shape shape, ElementPtr input, std::array<std::size_t, 3> from)
      : OneInput(std::move(shape), std::move(input)), from_(from) {}
  Band pull(const Window& region, BandPool& pool) override {
    Band band = input_->pull(region, pool);
    for (std::size_t c = 0; c < 3; ++c) std::ranges::copy(band.plane(from_[c]), band.plane(c).begin());
    return band;
  }

 private:
  std::array<std::size_t, 3> from_;
};

/// albedo of albedo.R, or the channel itself.
std::string layer_of(const std::string& channel) { return channel.substr(0, channel.rfind('.')); }

}  // namespace

ElementPtr translated(double x, double y, ElementPtr input) {
  return std::make_unique<TranslatedElement>(x, y, std::move(input));
}

ElementPtr cropped(const Window& window, ElementPtr input) {
  Shape shape = input->shape();
  shape.data = shape.data ? intersection(*shape.data, window) : window;
  return std::make_unique<CroppedElement>(std::move(shape), std::move(input));
}

ElementPtr layer(const std::string& name, ElementPtr input) {
  const Shape& shape = input->shape();
  std::vector<std::size_t> own;
  std::vector<std::string> known;
  for (std::size_t c = first_extra; c < shape.channels.size(); ++c) {
    const std::string of = layer_of(shape.channels[c]);
    if (std::find(known.begin(), known.end(), of) == known.end()) known.push_back(of);
    if (of == name && shape.channels[c] != name + ".A") own.push_back(c);
  }
  const auto named = [&](const char* suffix) { return shape.channel(name + suffix); };
  if (own.empty()) throw Error("no layer " + unknown_word(name, known));
  std::array<std::size_t, 3> from{own[0], own[own.size() > 1 ? 1 : 0], own[own.size() > 2 ? 2 : own.size() - 1]};
  if (named(".R") && named(".G") && named(".B")) from = {*named(".R"), *named(".G"), *named(".B")};
  return std::make_unique<LayerElement>(shape, std::move(input), from);
}

}  // namespace lambert::composite
