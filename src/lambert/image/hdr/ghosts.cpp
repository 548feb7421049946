#include "lambert/image/hdr/ghosts.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/hdr/samples.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {
namespace {

/// Exposure and its slope, by code.
struct Meaning {
  std::vector<float> exposure, slope, variance;  // of the code
  UsableCodes usable;
};

Meaning meaning_of(const ExposureStack& stack, const Response& response, const CodeNoise& noise, std::size_t channel) {
  Meaning m{.exposure = response.channel(channel), .usable = usable_codes(stack, channel)};
  for (std::size_t z = 0; z < m.exposure.size(); ++z) {
    const std::size_t a = z > 0 ? z - 1 : 0, b = std::min(z + 1, m.exposure.size() - 1);
    // No photograph is as free of noise as rounding alone would make it.
    const float sigma = std::max(noise.at(channel, z), 0.5f * static_cast<float>(stack.levels / 256));
    m.variance.push_back(sigma * sigma);
    m.slope.push_back((m.exposure[b] - m.exposure[a]) / static_cast<float>(b - a));
  }
  return m;
}

/// Sums over a square of side 2 radius + 1, cut at the borders, divided by its area; rows first, then columns.
void box_mean(std::vector<float>& values, int width, int height, int radius) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  const auto r = static_cast<std::size_t>(radius);
  std::vector<float> across(values.size());
  parallel_for(h, [&](std::size_t y) {
    for (std::size_t x = 0; x < w; ++x) {
      const std::size_t a = x > r ? x - r : 0, b = std::min(x + r, w - 1);
      float sum = 0;
      for (std::size_t k = a; k <= b; ++k) sum += values[y * w + k];
      across[y * w + x] = sum / static_cast<float>(b - a + 1);
    }
  });
  parallel_for(h, [&](std::size_t y) {
    const std::size_t a = y > r ? y - r : 0, b = std::min(y + r, h - 1);
    for (std::size_t x = 0; x < w; ++x) values[y * w + x] = 0;
    for (std::size_t k = a; k <= b; ++k)
      for (std::size_t x = 0; x < w; ++x) values[y * w + x] += across[k * w + x];
    for (std::size_t x = 0; x < w; ++x) values[y * w + x] /= static_cast<float>(b - a + 1);
  });
}

/// The pixels above `threshold`, grown by `radius` in a square.
std::vector<std::uint8_t> grown(const std::vector<float>& values, int width, int height, float threshold, int radius) {
  std::vector<float> moved(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) moved[i] = values[i] > threshold ? 1.0f : 0.0f;
  box_mean(moved, width, height, radius);
  std::vector<std::uint8_t> mask(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) mask[i] = moved[i] > 0;
  return mask;
}

class Comparison {
 public:
  Comparison(const ExposureStack& stack, const Response& response, const GhostSettings& settings, std::size_t reference)
      : stack_(stack), reference_(reference), tolerance_(static_cast<float>(settings.tolerance)) {
    for (std::size_t c = 0; c < stack.channels; ++c) meaning_.push_back(meaning_of(stack, response, settings.noise, c));
  }

  std::vector<float> deviations(std::size_t frame) const {
    std::vector<float> chi(static_cast<std::size_t>(stack_.width) * static_cast<std::size_t>(stack_.height));
    parallel_for(static_cast<std::size_t>(stack_.height), [&](std::size_t y) {
      const Span covered = stack_.covered(frame, static_cast<int>(y)),
                 shown = stack_.covered(reference_, static_cast<int>(y));
      for (int x = std::max(covered.begin, shown.begin); x < std::min(covered.end, shown.end); ++x)
        chi[y * static_cast<std::size_t>(stack_.width) + static_cast<std::size_t>(x)] =
            deviation(frame, x, static_cast<int>(y));
    });
    return chi;
  }

 private:
  float deviation(std::size_t frame, int x, int y) const {
    float sum = 0;
    for (std::size_t c = 0; c < stack_.channels; ++c) sum += deviation(frame, x, y, c);
    return sum / static_cast<float>(stack_.channels);
  }

  float deviation(std::size_t frame, int x, int y, std::size_t c) const {
    const Meaning& m = meaning_[c];
    const std::size_t i = static_cast<std::size_t>(x) * stack_.channels + c;
    const int z = stack_.row(frame, y)[i], zr = stack_.row(reference_, y)[i];
    const auto h = static_cast<float>(stack_.frames[frame].exposure),
               hr = static_cast<float>(stack_.frames[reference_].exposure);
    if (z >= m.usable.saturated && zr >= m.usable.saturated) return 0;
    const float value = m.exposure[static_cast<std::size_t>(z)] / h,
                believed = m.exposure[static_cast<std::size_t>(zr)] / hr;
    const float difference = value - believed;
    // A saturated pixel says "at least", a black one "at most".
    if ((zr >= m.usable.saturated || z <= m.usable.black) && difference > 0) return 0;
    if ((zr <= m.usable.black || z >= m.usable.saturated) && difference < 0) return 0;
    const float s = m.slope[static_cast<std::size_t>(z)] / h, sr = m.slope[static_cast<std::size_t>(zr)] / hr;
    const float blur = slope_variance(frame, x, y, c), blur_r = slope_variance(reference_, x, y, c);
    const float error = tolerance_ * std::max(value, believed);
    const float noise = m.variance[static_cast<std::size_t>(z)], noise_r = m.variance[static_cast<std::size_t>(zr)];
    const float variance = s * s * (noise + blur) + sr * sr * (noise_r + blur_r) + error * error;
    return variance > 0 ? std::min(difference * difference / variance, 100.0f) : 0.0f;
  }

  /// Of codes half a pixel away.
  float slope_variance(std::size_t frame, int x, int y, std::size_t c) const {
    const auto code = [&](int px, int py) {
      return static_cast<float>(stack_.row(frame, py)[static_cast<std::size_t>(px) * stack_.channels + c]);
    };
    const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, stack_.width - 1);
    const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, stack_.height - 1);
    const float dx = 0.25f * (code(x1, y) - code(x0, y)), dy = 0.25f * (code(x, y1) - code(x, y0));
    return dx * dx + dy * dy;
  }

  const ExposureStack& stack_;
  std::size_t reference_;
  std::vector<Meaning> meaning_;
  float tolerance_;
};

}  // namespace

std::size_t best_exposed(const ExposureStack& stack) {
  const int low = stack.levels / 16, high = stack.levels - 1 - low;
  std::size_t best = 0, most = 0;
  for (std::size_t j = 0; j < stack.frames.size(); ++j) {
    std::size_t usable = 0;
    const auto& codes = stack.frames[j].codes;
    const std::size_t step = std::max<std::size_t>(1, codes.size() / 500000) | 1;  // odd, so that rows do not repeat
    for (std::size_t i = 0; i < codes.size(); i += step) usable += codes[i] > low && codes[i] < high;
    if (usable > most) most = usable, best = j;
  }
  return best;
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
    std::vector<float> chi = comparison.deviations(j);
    box_mean(chi, stack.width, stack.height, settings.radius);
    masks.rejected[j] =
        grown(chi, stack.width, stack.height, static_cast<float>(settings.threshold), settings.radius + 1);
  }
  return masks;
}

}  // namespace lambert::hdr
