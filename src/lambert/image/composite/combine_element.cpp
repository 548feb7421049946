#include "lambert/image/composite/elements.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lambert::composite {
namespace {

std::vector<std::string> all_channels(const Shape& a, const Shape& b) {
  std::vector<std::string> names = b.channels;
  for (const std::string& name : a.channels)
    if (!b.channel(name)) names.push_back(name);
  return names;
}

Shape joined_shape(const Shape& a, const Shape& b) {
  Shape shape{.display = b.display ? b.display : a.display, .channels = all_channels(a, b)};
  if (a.data && b.data) shape.data = united(*a.data, *b.data);
  return shape;
}

/// Two elements of which the result takes the second's place.
class PairElement : public Element {
 public:
  PairElement(ElementPtr a, ElementPtr b)
      : Element(joined_shape(a->shape(), b->shape())), a_(std::move(a)), b_(std::move(b)) {
    const std::size_t na = a_->bands_needed(), nb = b_->bands_needed();
    bands_needed_ = std::max(std::max(na, nb), std::min(na, nb) + 1);
    if (b_->shape().channels != shape_.channels) ++bands_needed_;
    margin_ = std::max(a_->margin(), b_->margin());
    source_ = b_->source() ? b_->source() : a_->source();
    for (const std::string& name : shape_.channels)
      channels_.push_back({a_->shape().channel(name), is_sampled(name), nothing_of(name)});
  }

  Band pull(const Window& region, BandPool& pool) final {
    const Window part = covered(a_->shape(), region);
    std::optional<Band> a;
    const bool a_first = a_->bands_needed() > b_->bands_needed();
    if (a_first && !is_empty(part)) a = a_->pull(part, pool);
    Band b = with_all_channels(b_->pull(region, pool), pool);
    if (!a_first && !is_empty(part)) a = a_->pull(part, pool);
    for (Channel& c : channels_)
      if (!c.in_a) c.nothing_row.resize(static_cast<std::size_t>(std::max(part.width, 0)), c.nothing);
    parallel_for(static_cast<std::size_t>(region.height), [&](std::size_t row) {
      const int y = region.y + static_cast<int>(row);
      if (!a || y < part.y || y >= part.y + part.height) return alone(b, y, 0, b.width());
      const auto left = static_cast<std::size_t>(part.x - region.x), width = static_cast<std::size_t>(part.width);
      alone(b, y, 0, left);
      alone(b, y, left + width, b.width() - left - width);
      combine_rows(*a, b, y, left, width);
    });
    if (a) pool.give(std::move(*a));
    return b;
  }

 protected:
  /// Pixels [x, x + n) of the row where A is nothing.
  virtual void alone(Band& b, int y, std::size_t x, std::size_t n) const = 0;
  /// Pixels [x, x + n) of the row, which is all of A's row.
  virtual void combine_rows(const Band& a, Band& b, int y, std::size_t x, std::size_t n) const = 0;

  struct Channel {
    std::optional<std::size_t> in_a;
    bool sampled;
    float nothing;
    std::vector<float> nothing_row = {};  // where A has no such channel
  };
  const Channel& channel(std::size_t c) const { return channels_[c]; }

  /// A's row of a channel of the result, of nothing where it has none.
  std::span<const float> row_of_a(const Band& a, std::size_t c, int y) const {
    if (channels_[c].in_a) return a.row(*channels_[c].in_a, y);
    return channels_[c].nothing_row;
  }

 private:
  Band with_all_channels(Band b, BandPool& pool) const {
    const std::vector<std::string>& own = b_->shape().channels;
    if (own.size() == shape_.channels.size()) return b;
    Band all = pool.take(b.window(), shape_.channels.size());
    for (std::size_t c = 0; c < shape_.channels.size(); ++c)
      if (c < own.size())
        std::ranges::copy(b.plane(c), all.plane(c).begin());
      else
        std::ranges::fill(all.plane(c), nothing_of(shape_.channels[c]));
    pool.give(std::move(b));
    return all;
  }

  ElementPtr a_, b_;
  std::vector<Channel> channels_;
};

class CombinedElement final : public PairElement {
 public:
  CombinedElement(Operator op, ElementPtr a, ElementPtr b) : PairElement(std::move(a), std::move(b)), op_(op) {}

 private:
  void alone(Band& b, int y, std::size_t x, std::size_t n) const override {
    if (value_of(factors(op_).b, 0) > 0) return;
    for (std::size_t c = 0; c < shape_.channels.size(); ++c)
      std::ranges::fill(b.row(c, y).subspan(x, n), channel(c).nothing);
  }
  void combine_rows(const Band& a, Band& b, int y, std::size_t x, std::size_t n) const override {
    const std::span<const float> alpha_a = a.row(alpha_channel, y);
    const std::span<float> alpha_b = b.row(alpha_channel, y).subspan(x, n);
    for (std::size_t c = 0; c < shape_.channels.size(); ++c) {
      if (c == alpha_channel) continue;
      const std::span<float> to = b.row(c, y).subspan(x, n);
      const std::span<const float> from = row_of_a(a, c, y);
      if (channel(c).sampled)
        choose_row(op_, from, alpha_a, alpha_b, channel(c).nothing, to);
      else
        combine_row(op_, from, alpha_a, alpha_b, to);
    }
    combine_alpha_row(op_, alpha_a, alpha_b);
  }
  Operator op_;
};

class DepthElement final : public PairElement {
 public:
  DepthElement(ElementPtr a, ElementPtr b) : PairElement(std::move(a), std::move(b)), z_(*shape_.channel("Z")) {}

 private:
  void alone(Band&, int, std::size_t, std::size_t) const override {}

  void combine_rows(const Band& a, Band& b, int y, std::size_t x, std::size_t n) const override {
    constexpr float far = std::numeric_limits<float>::infinity();
    const std::span<const float> alpha_a = a.row(alpha_channel, y), depth_a = row_of_a(a, z_, y);
    const std::span<float> alpha_b = b.row(alpha_channel, y).subspan(x, n), depth_b = b.row(z_, y).subspan(x, n);
    std::vector<float> front(n);  // 1 where A is
    for (std::size_t i = 0; i < n; ++i) {
      const float za = alpha_a[i] > 0 ? distance_of(depth_a[i]) : far;
      const float zb = alpha_b[i] > 0 ? distance_of(depth_b[i]) : far;
      front[i] = za <= zb ? 1.0f : 0.0f;
      depth_b[i] = za <= zb ? za : zb;
    }
    for (std::size_t c = 0; c < shape_.channels.size(); ++c) {
      if (c == alpha_channel || c == z_) continue;
      const std::span<float> to = b.row(c, y).subspan(x, n);
      const std::span<const float> from = row_of_a(a, c, y);
      if (channel(c).sampled)
        choose(front, from, alpha_a, alpha_b, to);
      else
        mix(front, from, alpha_a, alpha_b, to);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const float ca = coverage(alpha_a[i]), cb = coverage(alpha_b[i]);
      alpha_b[i] = front[i] > 0 ? seen(1, alpha_a[i]) + seen(1 - ca, alpha_b[i])
                                : seen(1, alpha_b[i]) + seen(1 - cb, alpha_a[i]);
    }
  }

  static float seen(float weight, float value) { return weight > 0 ? weight * value : 0.0f; }

  static void mix(std::span<const float> front, std::span<const float> from, std::span<const float> alpha_a,
                  std::span<const float> alpha_b, std::span<float> to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
      const float behind_a = seen(1 - coverage(alpha_a[i]), to[i]), behind_b = seen(1 - coverage(alpha_b[i]), from[i]);
      to[i] = front[i] > 0 ? from[i] + behind_a : to[i] + behind_b;
    }
  }
  static void choose(std::span<const float> front, std::span<const float> from, std::span<const float> alpha_a,
                     std::span<const float> alpha_b, std::span<float> to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
      const bool a = front[i] > 0 ? alpha_a[i] > 0 : !(alpha_b[i] > 0) && alpha_a[i] > 0;
      to[i] = a ? from[i] : to[i];
    }
  }

  std::size_t z_;
};

}  // namespace

ElementPtr combined(Operator op, ElementPtr a, ElementPtr b) {
  return std::make_unique<CombinedElement>(op, std::move(a), std::move(b));
}
ElementPtr depth_combined(ElementPtr a, ElementPtr b) {
  return std::make_unique<DepthElement>(std::move(a), std::move(b));
}

}  // namespace lambert::composite
