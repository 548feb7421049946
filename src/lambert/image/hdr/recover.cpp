#include "lambert/image/hdr/recover.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/hdr/recover_methods.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace lambert::hdr {
namespace {

struct Name {
  const char* name;
  RecoveryMethod method;
};
constexpr Name names[] = {{"auto", RecoveryMethod::automatic},
                          {"debevec", RecoveryMethod::debevec},
                          {"robertson", RecoveryMethod::robertson},
                          {"mitsunaga", RecoveryMethod::mitsunaga}};

[[noreturn]] void unsolvable(const std::string& reason) {
  throw Error("the response cannot be recovered: " + reason + "; give it with --response srgb, linear, …");
}

/// Why these samples do not determine a response; an empty optional where they do.
std::optional<std::string> shortcoming(const ExposureStack& stack, const Samples& samples, std::size_t channel) {
  if (samples.count() >= 32) {
    std::vector<bool> seen(static_cast<std::size_t>(stack.levels));
    int different = 0, low = stack.levels, high = 0;
    for (const std::uint16_t code : samples.codes) {
      if (!samples.usable.contains(code)) continue;
      different += !seen[code], seen[code] = true;
      low = std::min<int>(low, code), high = std::max<int>(high, code);
    }
    if (different < 16)
      return "the photographs have only " + std::to_string(different) +
             " different codes that are neither black nor saturated (16 are needed)";
    if (high - low < stack.levels / 16)
      return "the codes that are neither black nor saturated span only " + std::to_string(low) + " to " +
             std::to_string(high);
    return std::nullopt;
  }
  std::size_t saturated = 0, black = 0, all = 0;
  stack.with_code_type([&]<class Code>(Code) {
    for (std::size_t j = 0; j < stack.frames.size(); ++j) {
      const std::span<const Code> codes = stack.codes<Code>(j);
      for (std::size_t i = channel; i < codes.size(); i += stack.channels, ++all)
        saturated += codes[i] >= samples.usable.saturated, black += codes[i] <= samples.usable.black;
    }
  });
  if (saturated == all) return "everything is saturated";
  if (black == all) return "everything is black";
  return "only " + std::to_string(samples.count()) +
         " pixels with different codes are neither black nor saturated in two photographs (32 are needed)";
}

/// ln exposure at the knots to exposures at all codes: never falling, the top one 1.
std::vector<float> table_of(const std::vector<double>& g, const Knots& knots) {
  const std::vector<double> rising = never_falling(g, std::vector<double>(g.size(), 1));
  std::vector<float> table(knots.below.size());
  // Between knots the exposure's own straight line: near 0 its logarithm's would be far off.
  std::vector<double> exposure;
  for (const double value : rising) exposure.push_back(std::exp(value - rising.back()));
  for (std::size_t code = 0; code < table.size(); ++code) table[code] = static_cast<float>(knots.eval(exposure, code));
  table.front() = 0;
  return table;
}

std::vector<double> log_of(const std::vector<float>& table, const Knots& knots) {
  std::vector<double> g;
  for (const double z : knots.position)
    g.push_back(std::log(std::max(1e-12, static_cast<double>(table[static_cast<std::size_t>(z)]))));
  return g;
}

/// By code, straight between the middles of the sixteenths.
std::vector<float> noise_table(const std::vector<double>& noise, const Knots& knots) {
  std::vector<float> table;
  for (std::size_t code = 0; code < knots.below.size(); ++code) {
    const double knot = knots.below[code] + static_cast<double>(knots.fraction[code]);
    const double at = std::clamp(knot * static_cast<double>(noise.size()) / static_cast<double>(knots.count()) - 0.5,
                                 0.0, static_cast<double>(noise.size()) - 1.001);
    const auto k = static_cast<std::size_t>(at);
    table.push_back(static_cast<float>(std::lerp(noise[k], noise[k + 1], at - static_cast<double>(k))));
  }
  return table;
}

/// The known curve that explains the photographs as well as the recovered ones do, up to 2 % of the misfit and what
/// their freedom alone gains. Codes below 12 of 255 have no say: rounding makes their mean another than the curve's,
/// which only the recovered ones can follow.
std::optional<Response> known_curve(const std::vector<LogRecovery>& channels, const std::vector<Samples>& samples,
                                    const Knots& knots) {
  std::vector<LogEquations> equations;
  double least = 0, terms = 0;
  const std::size_t lowest = 12 * knots.below.size() / 256;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    std::vector<double> weights = channels[c].weights;
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (samples[c].codes[i] < lowest) weights[i] = 0;
    equations.push_back(log_equations(samples[c], knots, weights));
    least += equations[c].misfit(channels[c].g), terms += static_cast<double>(equations[c].terms);
  }
  if (terms == 0) return std::nullopt;
  const double freedom = 40.0 * static_cast<double>(channels.size());
  double allowed = 1.02 * least * (terms + freedom) / terms;
  std::optional<Response> best;
  for (const char* word : {"srgb", "linear", "gamma 2.2"}) {
    Response known = response_named(word, channels.size(), knots.below.size());
    double misfit = 0;
    for (std::size_t c = 0; c < channels.size(); ++c) misfit += equations[c].misfit(log_of(known.exposure[c], knots));
    if (misfit <= allowed) allowed = misfit, best = std::move(known);
  }
  return best;
}

}  // namespace

RecoveryMethod recovery_method(std::string_view name) {
  for (const Name& n : names)
    if (name == n.name) return n.method;
  throw Error("unknown method of response recovery " + unknown_word(name, recovery_method_names()));
}

std::vector<std::string> recovery_method_names() {
  std::vector<std::string> all;
  for (const Name& n : names) all.push_back(n.name);
  return all;
}

CodeNoise measure_noise(const ExposureStack& stack, const Response& response) {
  CodeNoise noise;
  if (stack.frames.size() < 2) return noise;
  const Knots knots(stack.levels);
  noise.deviation.resize(stack.channels);
  const std::vector<Samples> samples = select_samples(stack);
  parallel_for(stack.channels, [&](std::size_t c) {
    noise.deviation[c] = noise_table(noise_by_sixteenths(samples[c], knots, log_of(response.channel(c), knots)), knots);
  });
  return noise;
}

Recovery recover_response(const ExposureStack& stack, const RecoverySettings& settings) {
  if (stack.frames.size() < 2) unsolvable("it takes two photographs or more");
  if (stack.frames.back().exposure < 1.01 * stack.frames.front().exposure) unsolvable("all exposures are equal");
  const Knots knots(stack.levels);
  const std::vector<Samples> samples = select_samples(stack);
  Recovery recovery{.model = "recovered"};
  recovery.response.name = "recovered";
  recovery.response.exposure.resize(stack.channels), recovery.noise.deviation.resize(stack.channels);
  std::vector<LogRecovery> found(stack.channels, LogRecovery{.equations = LogEquations(0)});
  const auto solve = [&](std::size_t c) {
    if (const auto reason = shortcoming(stack, samples[c], c)) unsolvable(*reason);
    if (settings.method == RecoveryMethod::debevec) {
      found[c] = recover_debevec(samples[c], knots, settings.smoothness);
      return;
    }
    found[c] = recover_automatic(samples[c], knots);
    if (settings.method == RecoveryMethod::automatic) return;
    const std::vector<double> exposure = settings.method == RecoveryMethod::robertson
                                             ? recover_robertson(samples[c], knots, found[c].g)
                                             : recover_mitsunaga(samples[c], knots);
    for (std::size_t k = 0; k < exposure.size(); ++k) found[c].g[k] = std::log(std::max(exposure[k], 1e-9));
  };
  parallel_for(stack.channels, [&](std::size_t c) {
    solve(c);
    recovery.noise.deviation[c] = noise_table(noise_by_sixteenths(samples[c], knots, found[c].g), knots);
    recovery.response.exposure[c] = table_of(found[c].g, knots);
  });
  for (const Samples& s : samples) recovery.samples += s.count();
  if (settings.method == RecoveryMethod::automatic)
    if (auto known = known_curve(found, samples, knots)) {
      recovery.model = known->name;
      recovery.response = std::move(*known);
    }
  return recovery;
}

}  // namespace lambert::hdr
