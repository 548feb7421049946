#include "lambert/image/hdr/merge.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/base/parallel.h"
#include "lambert/image/hdr/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// A weight u and u X; for a frame what its codes' are multiplied by.
using Share = float __attribute__((vector_size(2 * sizeof(float))));

/// What the codes of one channel count and mean; a frame's weight is u(code) exposure^power.
struct ChannelTable {
  std::vector<Share> shares;
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
  t.shares.resize(x.size());
  for (std::size_t code = 0; code < x.size() && largest > 0; ++code) {
    const double w = u[code] / largest;
    t.shares[code] = Share{static_cast<float>(w), static_cast<float>(w * static_cast<double>(x[code]))};
  }
  return t;
}

double power_of(Weighting w) { return w == Weighting::variance || w == Weighting::robertson ? 2 : 0; }

struct Scale {
  Share share;
  float exposure;
};

class Merger {
 public:
  Merger(const ExposureStack& stack, const Response& response, const MergeSettings& settings, const GhostMasks& ghosts)
      : stack_(stack), settings_(settings), ghosts_(ghosts) {
    for (std::size_t c = 0; c < stack.channels; ++c) {
      const ChannelTable& t = tables_.emplace_back(table_for(stack, response, c, settings));
      // Far below saturation it is motion that makes a shorter exposure say more.
      const int top = t.usable.saturated, doubted = top - stack.levels / 4;
      const float most = 1.2f * (*t.exposure)[static_cast<std::size_t>(top)];
      std::vector<float>& limits = limits_.emplace_back();
      for (int code = 0; code < stack.levels; ++code)
        limits.push_back(code >= doubted ? most : std::numeric_limits<float>::max());
      scattered_ |= t.usable.scattered;
    }
    const double power = power_of(settings.weights), longest = stack.frames.back().exposure;
    for (const Frame& frame : stack.frames) {
      const double relative = frame.exposure / longest;
      const double weight = std::pow(relative, power);
      scale_.push_back({Share{static_cast<float>(weight), static_cast<float>(weight / frame.exposure)},
                        static_cast<float>(frame.exposure)});
    }
  }

  struct Counts {
    std::size_t saturated = 0, black = 0;
  };

  template <class Code>
  Counts row(int y, std::span<float> out) const {
    const std::size_t n = stack_.channels, frames = stack_.frames.size();
    std::vector<std::vector<Code>> partly(frames);
    std::vector<const Code*> codes(frames);
    std::vector<float> weight(out.size());
    std::fill(out.begin(), out.end(), 0.0f);
    for (std::size_t j = 0; j < frames; ++j) codes[j] = used_codes(j, y, partly[j]);
    if (scattered_)
      add<true>(codes, weight.data(), out);
    else
      add<false>(codes, weight.data(), out);
    Counts counts;
    std::uint32_t without = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const bool some = weight[i] > 0;
      out[i] /= some ? weight[i] : 1;
      without += !some;
    }
    for (std::size_t x = 0; without > 0 && x < out.size() / n; ++x) {
      bool saturated = false, black = false;
      for (std::size_t i = x * n, c = 0; c < n; ++i, ++c)
        if (!(weight[i] > 0)) out[i] = without_weight<Code>(static_cast<int>(x), y, c, saturated, black);
      counts.saturated += saturated, counts.black += black && !saturated;
    }
    if (settings_.weights == Weighting::variance && settings_.noise.full_well > 0) refine(codes, out);
    return counts;
  }

 private:
  /// The sums over frames of u and u X. Of a lossy stack, if `doubting`, a frame has no share where the shorter
  /// exposures say that it is saturated.
  template <bool doubting, class Code>
  void add(const std::vector<const Code*>& codes, float* weight, std::span<float> weighted) const {
    constexpr std::size_t most = 5;
    for (std::size_t j = 0; j < codes.size(); j += most) switch (std::min(codes.size() - j, most)) {
        case 1: add_frames<1, doubting>(&codes[j], &scale_[j], weight, weighted); break;
        case 2: add_frames<2, doubting>(&codes[j], &scale_[j], weight, weighted); break;
        case 3: add_frames<3, doubting>(&codes[j], &scale_[j], weight, weighted); break;
        case 4: add_frames<4, doubting>(&codes[j], &scale_[j], weight, weighted); break;
        default: add_frames<most, doubting>(&codes[j], &scale_[j], weight, weighted); break;
      }
  }

  /// Of `n` frames at a time: the sums are loaded and stored that many times less.
  template <std::size_t n, bool doubting, class Code>
  void add_frames(const Code* const* codes, const Scale* scales, float* weight, std::span<float> weighted) const {
    std::array<const Code*, n> code;
    std::array<Scale, n> scale;
    std::copy_n(codes, n, code.begin());
    std::copy_n(scales, n, scale.begin());
    for (std::size_t c = 0; c < stack_.channels; ++c) {
      const Share* const shares = tables_[c].shares.data();
      const float* const limits = limits_[c].data();
      for (std::size_t i = c; i < weighted.size(); i += stack_.channels) {
        Share sum{weight[i], weighted[i]};
        for (std::size_t j = 0; j < n; ++j) {
          const std::size_t entry = code[j][i];
          const Share share = scale[j].share * shares[entry];
          if constexpr (doubting)
            sum += sum[1] * scale[j].exposure > sum[0] * limits[entry] ? Share{} : share;
          else
            sum += share;
        }
        weight[i] = sum[0], weighted[i] = sum[1];
      }
    }
  }

  bool shows(std::size_t frame, int x, int y) const {
    const Span covered = stack_.covered(frame, y);
    const std::uint8_t* rejected = ghosts_.row(frame, y, stack_.width);
    return x >= covered.begin && x < covered.end && !(rejected && rejected[x]);
  }
  /// A row's codes, with 0, which has no weight, where the frame is not to be used; `copy` holds them if they are not
  /// the frame's own.
  template <class Code>
  const Code* used_codes(std::size_t frame, int y, std::vector<Code>& copy) const {
    const Code* codes = stack_.row<Code>(frame, y);
    const Span covered = stack_.covered(frame, y);
    const std::uint8_t* rejected = ghosts_.row(frame, y, stack_.width);
    if (!rejected && covered == Span{0, stack_.width}) return codes;
    const std::size_t n = stack_.channels;
    copy.resize(stack_.row_size());
    for (auto x = static_cast<std::size_t>(covered.begin); x < static_cast<std::size_t>(covered.end); ++x)
      for (std::size_t c = 0; c < n; ++c) copy[x * n + c] = rejected && rejected[x] ? Code{0} : codes[x * n + c];
    return copy.data();
  }

  /// A channel of a pixel that no photograph shows within its range.
  template <class Code>
  float without_weight(int x, int y, std::size_t c, bool& saturated, bool& black) const {
    const ChannelTable& t = tables_[c];
    const std::size_t i = static_cast<std::size_t>(x) * stack_.channels + c;
    for (std::size_t j = 0; j < stack_.frames.size(); ++j)
      if (shows(j, x, y) && stack_.row<Code>(j, y)[i] >= t.usable.saturated) {
        saturated = true;
        const double bound = static_cast<double>((*t.exposure)[static_cast<std::size_t>(t.usable.saturated)]);
        return static_cast<float>(bound / stack_.frames[j].exposure);
      }
    black = true;
    return 0;
  }

  /// Granados et al. 2010: the variances that the mean so far predicts, not those that each noisy code does. Two turns.
  template <class Code>
  void refine(const std::vector<const Code*>& codes, std::span<float> out) const {
    const double read = settings_.noise.read_noise / settings_.noise.full_well;
    const float gain = static_cast<float>(1 / settings_.noise.full_well), floor = static_cast<float>(read * read);
    for (int turn = 0; turn < 2; ++turn)
      for (std::size_t i = 0; i < out.size(); ++i) {
        const ChannelTable& t = tables_[i % stack_.channels];
        float sum = 0, weights = 0;
        for (std::size_t j = 0; j < codes.size(); ++j) {
          const std::size_t z = codes[j][i];
          const auto h = static_cast<float>(stack_.frames[j].exposure);
          const bool doubted = scattered_ && out[i] * h > limits_[i % stack_.channels][z];
          if (!(t.shares[z][0] > 0) || doubted) continue;
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
  std::vector<std::vector<float>> limits_;  // exposures by shorter frames above which codes are those of saturation
  bool scattered_ = false;
  std::vector<Scale> scale_;  // by frame
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
  stack.with_code_type([&]<class Code>(Code) {
    parallel_for(counts.size(), settings.progress, [&](std::size_t y) {
      counts[y] = merger.row<Code>(static_cast<int>(y), merged.image.row(static_cast<int>(y)));
    });
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
