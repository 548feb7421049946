#include "lambert/image/hdr/merge.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/base/parallel.h"
#include "lambert/image/hdr/samples.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {
namespace {

struct Name {
  const char* name;
  Weighting weighting;
};
constexpr Name names[] = {{"variance", Weighting::variance},
                          {"hat", Weighting::hat},
                          {"gaussian", Weighting::gaussian},
                          {"robertson", Weighting::robertson}};

struct Entry {
  float weight = 0, weighted = 0;  // u and u X
};

/// What the codes of one channel count and mean; a frame's weight is u(code) exposure^power.
struct ChannelTable {
  std::vector<Entry> entries;
  std::vector<float> rounding;  // variance of X that rounding to codes makes
  const std::vector<float>* exposure = nullptr;
  UsableCodes usable;
};

double slope(const std::vector<float>& x, std::size_t code) {
  const std::size_t a = code > 0 ? code - 1 : 0, b = std::min(code + 1, x.size() - 1);
  return static_cast<double>(x[b] - x[a]) / static_cast<double>(b - a);
}

ChannelTable table_for(const ExposureStack& stack, const Response& response, std::size_t channel,
                       const MergeSettings& settings) {
  const std::vector<float>& x = response.channel(channel);
  const UsableCodes usable = usable_codes(stack, channel);
  const double top = stack.levels - 1, middle = 0.5 * top;
  ChannelTable t{.exposure = &x, .usable = usable};
  std::vector<double> u(x.size());
  double largest = 0;
  for (std::size_t code = 0; code < x.size(); ++code) {
    const double z = static_cast<double>(code), x1 = std::max(slope(x, code), 1e-9);
    t.rounding.push_back(static_cast<float>(x1 * x1 / 12));
    if (!usable.contains(static_cast<int>(code)) || !(x[code] > 0)) continue;
    const double off = z / middle - 1;
    switch (settings.weights) {
      case Weighting::variance: {
        const double full = settings.noise.full_well, read = full > 0 ? settings.noise.read_noise / full : 0;
        const double sigma = static_cast<double>(settings.code_noise.at(channel, code));
        u[code] = full > 0 ? 1 / (x1 * x1 / 12 + static_cast<double>(x[code]) / full + read * read)
                           : 1 / (x1 * x1 * sigma * sigma);
        break;
      }
      case Weighting::hat: u[code] = std::min(z - usable.black, usable.saturated - z); break;
      case Weighting::gaussian:
      case Weighting::robertson: u[code] = std::exp(-4 * off * off); break;
    }
    // The last codes below saturation may be clipped light and noise: trusted less and less.
    u[code] *= std::min(1.0, (usable.saturated - z) / (0.04 * top));
    largest = std::max(largest, u[code]);
  }
  t.entries.resize(x.size());
  for (std::size_t code = 0; code < x.size() && largest > 0; ++code) {
    const double w = u[code] / largest;
    t.entries[code] = {static_cast<float>(w), static_cast<float>(w * static_cast<double>(x[code]))};
  }
  return t;
}

double power_of(Weighting w) { return w == Weighting::variance || w == Weighting::robertson ? 2 : 0; }

class Merger {
 public:
  Merger(const ExposureStack& stack, const Response& response, const MergeSettings& settings, const GhostMasks& ghosts)
      : stack_(stack), settings_(settings), ghosts_(ghosts) {
    for (std::size_t c = 0; c < stack.channels; ++c) tables_.push_back(table_for(stack, response, c, settings));
    const double power = power_of(settings.weights), longest = stack.frames.back().exposure;
    for (const Frame& frame : stack.frames) {
      const double relative = frame.exposure / longest;
      weight_scale_.push_back(static_cast<float>(std::pow(relative, power)));
      value_scale_.push_back(static_cast<float>(std::pow(relative, power) / frame.exposure));
    }
  }

  struct Counts {
    std::size_t saturated = 0, black = 0;
  };

  Counts row(int y, std::span<float> out) const {
    const std::size_t n = stack_.channels;
    std::vector<float> weight(out.size());
    std::fill(out.begin(), out.end(), 0.0f);
    for (std::size_t j = 0; j < stack_.frames.size(); ++j) {
      const Span covered = stack_.covered(j, y);
      const std::uint16_t* codes = stack_.row(j, y);
      const std::uint8_t* rejected = ghosts_.row(j, y, stack_.width);
      for (std::size_t c = 0; c < n; ++c) {
        const Entry* entries = tables_[c].entries.data();
        const float ws = weight_scale_[j], vs = value_scale_[j];
        const auto add = [&](std::size_t i, float use) {
          const Entry e = entries[codes[i]];
          weight[i] += use * ws * e.weight;
          out[i] += use * vs * e.weighted;
        };
        const std::size_t begin = static_cast<std::size_t>(covered.begin), end = static_cast<std::size_t>(covered.end);
        if (!rejected)
          for (std::size_t x = begin; x < end; ++x) add(x * n + c, 1);
        else
          for (std::size_t x = begin; x < end; ++x) add(x * n + c, rejected[x] ? 0.0f : 1.0f);
      }
    }
    Counts counts;
    for (std::size_t x = 0; x < out.size() / n; ++x) {
      bool saturated = false, black = false;
      for (std::size_t c = 0; c < n; ++c) {
        const std::size_t i = x * n + c;
        if (weight[i] > 0)
          out[i] /= weight[i];
        else
          out[i] = without_weight(static_cast<int>(x), y, c, saturated, black);
      }
      counts.saturated += saturated, counts.black += black && !saturated;
    }
    if (settings_.weights == Weighting::variance && settings_.noise.full_well > 0) refine(y, out);
    return counts;
  }

 private:
  bool shows(std::size_t frame, int x, int y) const {
    const Span covered = stack_.covered(frame, y);
    const std::uint8_t* rejected = ghosts_.row(frame, y, stack_.width);
    return x >= covered.begin && x < covered.end && !(rejected && rejected[x]);
  }
  int code(std::size_t frame, int x, int y, std::size_t c) const {
    return stack_.row(frame, y)[static_cast<std::size_t>(x) * stack_.channels + c];
  }

  /// A channel of a pixel that no photograph shows within its range.
  float without_weight(int x, int y, std::size_t c, bool& saturated, bool& black) const {
    const ChannelTable& t = tables_[c];
    for (std::size_t j = 0; j < stack_.frames.size(); ++j)
      if (shows(j, x, y) && code(j, x, y, c) >= t.usable.saturated) {
        saturated = true;
        const double bound = static_cast<double>((*t.exposure)[static_cast<std::size_t>(t.usable.saturated)]);
        return static_cast<float>(bound / stack_.frames[j].exposure);
      }
    black = true;
    return 0;
  }

  /// Granados et al. 2010: the variances that the mean so far predicts, not those that each noisy code does. Two turns.
  void refine(int y, std::span<float> out) const {
    const double read = settings_.noise.read_noise / settings_.noise.full_well;
    const float gain = static_cast<float>(1 / settings_.noise.full_well), floor = static_cast<float>(read * read);
    for (int turn = 0; turn < 2; ++turn)
      for (std::size_t i = 0; i < out.size(); ++i) {
        const std::size_t c = i % stack_.channels;
        const int x = static_cast<int>(i / stack_.channels);
        const ChannelTable& t = tables_[c];
        float sum = 0, weights = 0;
        for (std::size_t j = 0; j < stack_.frames.size(); ++j) {
          if (!shows(j, x, y)) continue;
          const auto z = static_cast<std::size_t>(code(j, x, y, c));
          if (!(t.entries[z].weight > 0)) continue;
          const auto h = static_cast<float>(stack_.frames[j].exposure);
          const float near_top = std::min(1.0f, static_cast<float>(t.usable.saturated - static_cast<int>(z)) /
                                                    (0.04f * static_cast<float>(stack_.levels - 1)));
          const float w = near_top * h * h / (gain * out[i] * h + floor + t.rounding[z]);
          weights += w, sum += w * (*t.exposure)[z] / h;
        }
        if (weights > 0) out[i] = sum / weights;
      }
  }

  const ExposureStack& stack_;
  const MergeSettings& settings_;
  const GhostMasks& ghosts_;
  std::vector<ChannelTable> tables_;
  std::vector<float> weight_scale_, value_scale_;
};

}  // namespace

Weighting weighting(std::string_view name) {
  for (const Name& n : names)
    if (name == n.name) return n.weighting;
  throw Error("unknown weighting " + unknown_word(name, weighting_names()));
}

std::vector<std::string> weighting_names() {
  std::vector<std::string> all;
  for (const Name& n : names) all.push_back(n.name);
  return all;
}

Merged merge(const ExposureStack& stack, const Response& response, const MergeSettings& settings,
             const GhostMasks& ghosts) {
  if (response.levels() != static_cast<std::size_t>(stack.levels))
    throw Error("the response has " + std::to_string(response.levels()) + " codes, the photographs have " +
                std::to_string(stack.levels));
  Merged merged{
      .image = Image(stack.width, stack.height, stack.channels == 3 ? rgb_channels() : std::vector<std::string>{"Y"})};
  const Merger merger(stack, response, settings, ghosts);
  std::vector<Merger::Counts> counts(static_cast<std::size_t>(stack.height));
  parallel_for(counts.size(), [&](std::size_t y) {
    counts[y] = merger.row(static_cast<int>(y), merged.image.row(static_cast<int>(y)));
  });
  for (const auto& c : counts) merged.saturated += c.saturated, merged.black += c.black;
  std::string exposures;
  for (const Frame& frame : stack.frames) {
    if (!exposures.empty()) exposures += " ";
    append_number(exposures, static_cast<float>(frame.exposure));
  }
  merged.image.metadata["hdr.exposures"] = exposures;
  merged.image.metadata["hdr.response"] = response.name;
  return merged;
}

}  // namespace lambert::hdr
