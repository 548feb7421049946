#include "lambert/image/hdr/ghosts.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/hdr/samples.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {
namespace {

/// What a code stands for: its exposure, the square of the exposure's slope, and the variance of the code.
struct Meaning {
  float exposure, slope_squared, variance;
};
struct ChannelMeaning {
  std::vector<Meaning> codes;
  UsableCodes usable;
};

ChannelMeaning meaning_of(const ExposureStack& stack, const Response& response, const CodeNoise& noise,
                          std::size_t channel) {
  ChannelMeaning m{.usable = usable_codes(stack, channel)};
  const std::vector<float>& exposure = response.channel(channel);
  for (std::size_t z = 0; z < exposure.size(); ++z) {
    const std::size_t a = z > 0 ? z - 1 : 0, b = std::min(z + 1, exposure.size() - 1);
    // No photograph is as free of noise as rounding alone would make it.
    const float sigma = std::max(noise.at(channel, z), 0.5f * static_cast<float>(stack.levels / 256));
    const float slope = (exposure[b] - exposure[a]) / static_cast<float>(b - a);
    m.codes.push_back({exposure[z], slope * slope, sigma * sigma});
  }
  return m;
}

/// A number for each pixel, by rows.
template <class T>
struct Plane {
  std::size_t width = 0, height = 0;
  std::vector<T> values;
  Plane(std::size_t w, std::size_t h) : width(w), height(h), values(w * h) {}
  T* row(std::size_t y) { return values.data() + y * width; }
  const T* row(std::size_t y) const { return values.data() + y * width; }
};

/// to[x] = from[x - radius] + … + from[x + radius], what lies outside being 0; `add` in place of +.
template <class T, class Add>
void gather_row(const T* from, T* to, std::size_t width, std::size_t radius, const Add& add) {
  std::copy_n(from, width, to);
  for (std::size_t k = 1; k <= std::min(radius, width - 1); ++k) {
    for (std::size_t x = 0; x + k < width; ++x) to[x] = add(to[x], from[x + k]);
    for (std::size_t x = k; x < width; ++x) to[x] = add(to[x], from[x - k]);
  }
}

/// Over the square of side 2 radius + 1 about each pixel, cut at the borders.
template <class T, class Add>
Plane<T> gathered(const Plane<T>& plane, std::size_t radius, const Add& add) {
  Plane<T> across(plane.width, plane.height), all(plane.width, plane.height);
  parallel_for(plane.height, [&](std::size_t y) { gather_row(plane.row(y), across.row(y), plane.width, radius, add); });
  parallel_for(plane.height, [&](std::size_t y) {
    T* to = all.row(y);
    for (std::size_t k = y > radius ? y - radius : 0; k <= std::min(y + radius, plane.height - 1); ++k) {
      const T* from = across.row(k);
      for (std::size_t x = 0; x < plane.width; ++x) to[x] = add(to[x], from[x]);
    }
  });
  return all;
}

/// How many pixels lie within `radius` of pixel x of `width`.
std::size_t reach(std::size_t x, std::size_t width, std::size_t radius) {
  return std::min(x + radius, width - 1) - (x > radius ? x - radius : 0) + 1;
}

/// 1 within `radius` + 1, in a square, of pixels about which the mean over a square of `radius` is above `threshold`;
/// empty where there are none.
std::vector<std::uint8_t> moved(const Plane<float>& deviations, float threshold, std::size_t radius) {
  const Plane<float> sums = gathered(deviations, radius, [](float a, float b) { return a + b; });
  Plane<std::uint8_t> above(sums.width, sums.height);
  std::vector<float> area(sums.width);
  for (std::size_t x = 0; x < area.size(); ++x) area[x] = static_cast<float>(reach(x, sums.width, radius));
  std::vector<std::uint8_t> any(sums.height);
  parallel_for(sums.height, [&](std::size_t y) {
    const float limit = threshold * static_cast<float>(reach(y, sums.height, radius));
    for (std::size_t x = 0; x < sums.width; ++x) {
      above.row(y)[x] = sums.row(y)[x] > limit * area[x];
      any[y] |= above.row(y)[x];
    }
  });
  if (std::find(any.begin(), any.end(), 1) == any.end()) return {};
  return gathered(above, radius + 1, [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); })
      .values;
}

class Comparison {
 public:
  Comparison(const ExposureStack& stack, const Response& response, const GhostSettings& settings, std::size_t reference)
      : stack_(stack), reference_(reference), tolerance_(static_cast<float>(settings.tolerance)) {
    for (std::size_t c = 0; c < stack.channels; ++c)
      meanings_.push_back(meaning_of(stack, response, settings.noise, c));
  }

  Plane<float> deviations(std::size_t frame) const {
    Plane<float> chi(static_cast<std::size_t>(stack_.width), static_cast<std::size_t>(stack_.height));
    stack_.with_code_type([&]<class Code>(Code) {
      parallel_for(chi.height, [&](std::size_t y) { row<Code>(frame, static_cast<int>(y), chi.row(y)); });
    });
    return chi;
  }

 private:
  /// A row and its neighbours, which at the borders are it.
  template <class Code>
  struct Rows {
    const Code *above, *here, *below;
    std::size_t channels, last;  // column
    Rows(const ExposureStack& s, std::size_t frame, int y)
        : above(s.row<Code>(frame, std::max(y - 1, 0))),
          here(s.row<Code>(frame, y)),
          below(s.row<Code>(frame, std::min(y + 1, s.height - 1))),
          channels(s.channels),
          last(static_cast<std::size_t>(s.width) - 1) {}
    /// The variance of codes half a pixel away.
    float blur(std::size_t x, std::size_t c) const {
      const std::size_t i = x * channels + c;
      const std::size_t left = x > 0 ? i - channels : i, right = x < last ? i + channels : i;
      const float dx = 0.25f * static_cast<float>(here[right] - here[left]);
      const float dy = 0.25f * static_cast<float>(below[i] - above[i]);
      return dx * dx + dy * dy;
    }
  };

  template <class Code>
  void row(std::size_t frame, int y, float* chi) const {
    const Span covered = stack_.covered(frame, y), shown = stack_.covered(reference_, y);
    const auto begin = static_cast<std::size_t>(std::max(covered.begin, shown.begin));
    const auto end = static_cast<std::size_t>(std::max(std::min(covered.end, shown.end), 0));
    const Rows<Code> rows(stack_, frame, y), rows_r(stack_, reference_, y);
    const float scale = static_cast<float>(1 / stack_.frames[frame].exposure),
                scale_r = static_cast<float>(1 / stack_.frames[reference_].exposure);
    const float share = 1 / static_cast<float>(stack_.channels);
    for (std::size_t c = 0; c < stack_.channels; ++c) {
      const Meaning* meanings = meanings_[c].codes.data();
      const UsableCodes usable = meanings_[c].usable;
      for (std::size_t x = begin; x < end; ++x) {
        const int z = rows.here[x * stack_.channels + c], zr = rows_r.here[x * stack_.channels + c];
        const Meaning m = meanings[z], mr = meanings[zr];
        const float value = m.exposure * scale, believed = mr.exposure * scale_r;
        float difference = value - believed;
        // A saturated pixel says "at least", a black one "at most".
        if ((zr >= usable.saturated) | (z <= usable.black)) difference = std::min(difference, 0.0f);
        if ((zr <= usable.black) | (z >= usable.saturated)) difference = std::max(difference, 0.0f);
        const float error = tolerance_ * std::max(value, believed);
        const float variance = scale * scale * m.slope_squared * (m.variance + rows.blur(x, c)) +
                               scale_r * scale_r * mr.slope_squared * (mr.variance + rows_r.blur(x, c)) + error * error;
        chi[x] += variance > 0 ? share * std::min(difference * difference / variance, 100.0f) : 0.0f;
      }
    }
  }

  const ExposureStack& stack_;
  std::size_t reference_;
  std::vector<ChannelMeaning> meanings_;
  float tolerance_;
};

}  // namespace

std::size_t best_exposed(const ExposureStack& stack) {
  const int low = stack.levels / 16, high = stack.levels - 1 - low;
  std::vector<std::size_t> usable(stack.frames.size());
  stack.with_code_type([&]<class Code>(Code) {
    for (std::size_t j = 0; j < usable.size(); ++j)
      for (std::size_t y = 0; y < static_cast<std::size_t>(stack.height); y += stack.row_step(500000)) {
        const Code* codes = stack.row<Code>(j, static_cast<int>(y));
        for (std::size_t i = 0; i < stack.row_size(); ++i) usable[j] += codes[i] > low && codes[i] < high;
      }
  });
  return static_cast<std::size_t>(std::max_element(usable.begin(), usable.end()) - usable.begin());
}

std::size_t GhostMasks::count() const {
  std::size_t sum = 0;
  for (const auto& mask : rejected) sum += static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1));
  return sum;
}

GhostMasks find_ghosts(const ExposureStack& stack, const Response& response, const GhostSettings& settings) {
  GhostMasks masks{.rejected = std::vector<std::vector<std::uint8_t>>(stack.frames.size()),
                   .reference = settings.reference.value_or(best_exposed(stack))};
  if (masks.reference >= stack.frames.size())
    throw Error("there is no photograph " + std::to_string(masks.reference) + ": there are " +
                std::to_string(stack.frames.size()) + ", counted from 0 and the shortest exposure");
  const Comparison comparison(stack, response, settings, masks.reference);
  for (std::size_t j = 0; j < stack.frames.size(); ++j) {
    if (j == masks.reference) continue;
    masks.rejected[j] = moved(comparison.deviations(j), static_cast<float>(settings.threshold),
                              static_cast<std::size_t>(settings.radius));
  }
  return masks;
}

}  // namespace lambert::hdr
