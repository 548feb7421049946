#include "lambert/image/hdr/response.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace lambert::hdr {
namespace {

/// Exposure behind a pixel value, both in [0,1].
using Curve = std::function<double(double)>;

double srgb_curve(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

Curve film_curve(std::size_t channel) {
  constexpr double half[] = {0.22, 0.25, 0.28};
  const double s = half[channel % 3];
  return [s](double v) { return std::pow(v * s / (1 + s - v), 1 / 0.9); };
}

std::optional<double> gamma_of(const std::string& word) {
  if (!word.starts_with("gamma")) return std::nullopt;
  const std::size_t at = word.find_first_not_of(" =", 5);
  if (at == std::string::npos) return 2.2;
  double gamma = 0;
  const char* end = parse_double(word.data() + at, word.data() + word.size(), gamma);
  if (end != word.data() + word.size() || !(gamma >= 0.1 && gamma <= 10))
    throw Error("response '" + printable(word) + "': expected gamma and a number from 0.1 to 10");
  return gamma;
}

std::optional<Curve> curve_named(const std::string& word, std::size_t channel) {
  if (word == "srgb") return srgb_curve;
  if (word == "linear") return [](double v) { return v; };
  if (word == "film") return film_curve(channel);
  if (word == "log") return [](double v) { return std::expm1(v * std::log(1001.0)) / 1000; };
  if (const auto gamma = gamma_of(word)) return [g = *gamma](double v) { return std::pow(v, g); };
  return std::nullopt;
}

}  // namespace

std::vector<std::string> response_names() { return {"srgb", "linear", "gamma 2.2", "film", "log"}; }

Response response_named(const std::string& word, std::size_t channels, std::size_t levels) {
  if (!curve_named(word, 0)) {
    if (std::filesystem::path(word).has_extension() || std::filesystem::exists(word))
      return read_response(word, channels, levels);
    std::vector<std::string> known = response_names();
    known.push_back("a CSV file");
    throw Error("unknown response " + unknown_word(word, known));
  }
  Response r{.name = word};
  for (std::size_t c = 0; c < channels; ++c) {
    const Curve curve = *curve_named(word, c);
    std::vector<float>& table = r.exposure.emplace_back(levels);
    for (std::size_t i = 0; i < levels; ++i)
      table[i] = static_cast<float>(curve(static_cast<double>(i) / static_cast<double>(levels - 1)));
  }
  return r;
}

double encode(const std::vector<float>& channel, double exposure) {
  if (!(exposure > static_cast<double>(channel.front()))) return 0;
  if (exposure >= static_cast<double>(channel.back())) return static_cast<double>(channel.size() - 1);
  const auto above = std::upper_bound(channel.begin(), channel.end(), exposure,
                                      [](double x, float entry) { return x < static_cast<double>(entry); });
  const double high = static_cast<double>(*above), low = static_cast<double>(*(above - 1));
  return static_cast<double>(above - channel.begin() - 1) + (exposure - low) / (high - low);
}

double decode(const std::vector<float>& channel, double code) {
  const auto top = static_cast<double>(channel.size() - 1);
  const double at = std::clamp(code, 0.0, top);
  const auto i = std::min(static_cast<std::size_t>(at), channel.size() - 2);
  const double a = static_cast<double>(channel[i]), b = static_cast<double>(channel[i + 1]);
  return a + (b - a) * (at - static_cast<double>(i));
}

}  // namespace lambert::hdr
