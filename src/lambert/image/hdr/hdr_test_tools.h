#pragma once
/// What tests of photographs share.

#include "lambert/image/hdr/expose.h"
#include "lambert/image/hdr/stack.h"
#include "lambert/image/io.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lambert::hdr {

/// A scene of about ten stops: waves of light, finer ones on them, and sharp edges.
inline Image test_map(int width, int height, bool colour = true) {
  Image map(width, height, colour ? rgb_channels() : std::vector<std::string>{"Y"});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float u = static_cast<float>(x), v = static_cast<float>(y);
      float stops = 3 * std::sin(0.031f * u + 0.4f * std::sin(0.05f * v)) + 1.5f * std::cos(0.047f * v - 0.01f * u) +
                    0.25f * std::sin(0.7f * u) * std::sin(0.9f * v);
      if ((x / 23 + y / 17) % 3 == 0) stops += 0.8f;
      if (x % 37 == 5 || y % 41 == 9) stops -= 0.6f;
      for (std::size_t c = 0; c < map.channel_count(); ++c)
        map.at(x, y, c) = std::exp2(stops + 0.3f * static_cast<float>(c) * std::cos(0.02f * u));
    }
  return map;
}

/// Photographs of `map` as expose() takes them, in the order of `settings`.
inline ExposureStack photographs(const std::vector<const Image*>& maps, const std::string& response,
                                 const std::vector<ExposeSettings>& settings) {
  const std::size_t channels = maps[0]->has_colour() ? 3 : 1;
  const Response camera = response_named(response, channels, 65536);
  ExposureStack stack{.width = maps[0]->width(),
                      .height = maps[0]->height(),
                      .channels = channels,
                      .levels = settings[0].bits == 8 ? 256 : 65536};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const DisplayImage d = expose(*maps[i % maps.size()], camera, settings[i]);
    Frame frame{.name = "photograph " + std::to_string(i), .exposure = settings[i].exposure};
    if (settings[i].bits == 8)
      frame.codes = d.bytes;
    else
      frame.codes = d.words;
    stack.frames.push_back(std::move(frame));
  }
  return stack;
}

inline ExposureStack photographs(const Image& map, const std::string& response, const std::vector<double>& exposures,
                                 int bits = 8, SensorNoise noise = {}) {
  std::vector<ExposeSettings> settings;
  for (const double e : exposures)
    settings.push_back({.exposure = e, .noise = noise, .bits = bits, .seed = settings.size() + 1});
  return photographs(std::vector<const Image*>{&map}, response, settings);
}

/// The same photographs after JPEG has kept them, with its colours at half resolution.
inline ExposureStack through_jpeg(ExposureStack stack) {
  for (Frame& frame : stack.frames) {
    const DisplayImage d{.width = stack.width,
                         .height = stack.height,
                         .channels = static_cast<int>(stack.channels),
                         .bytes = std::get<0>(frame.codes)};
    frame.codes = decode_texels(encode_jpeg(d), frame.name).bytes;
  }
  return stack;
}

inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median of |ln a - ln b| over the values that `of` gives, after the medians of ln a and ln b are made equal.
inline double median_log_error(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> d;
  for (std::size_t i = 0; i < a.size(); ++i) d.push_back(std::log(a[i]) - std::log(b[i]));
  const double offset = median_of(d);
  for (double& x : d) x = std::abs(x - offset);
  return median_of(d);
}

/// Of radiance, over what is neither black nor saturated in two photographs or more; all channels with one scale.
inline double radiance_error(const ExposureStack& stack, const Image& merged, const Image& truth) {
  std::vector<double> a, b;
  for (int y = 0; y < stack.height; ++y)
    for (int x = 0; x < stack.width; ++x)
      for (std::size_t c = 0; c < stack.channels; ++c) {
        int usable = 0;
        for (std::size_t j = 0; j < stack.frames.size(); ++j) {
          const int z = stack.with_code_type([&]<class Code>(Code) {
            return static_cast<int>(stack.row<Code>(j, y)[static_cast<std::size_t>(x) * stack.channels + c]);
          });
          usable += z > 0 && z < stack.levels - 1;
        }
        const float found = merged.at(x, y, c), known = truth.at(x, y, c);
        if (usable < 2 || !(found > 0) || !(known > 0)) continue;
        a.push_back(static_cast<double>(found)), b.push_back(static_cast<double>(known));
      }
  return median_log_error(a, b);
}

/// Of the response, over the codes from 2 % to 98 %.
inline double response_error(const Response& found, const Response& known) {
  std::vector<double> a, b;
  const std::size_t n = known.levels();
  for (std::size_t c = 0; c < found.exposure.size(); ++c)
    for (std::size_t z = n / 50; z < n - n / 50; z += n / 256)
      a.push_back(static_cast<double>(found.channel(c)[z])), b.push_back(static_cast<double>(known.channel(c)[z]));
  return median_log_error(a, b);
}

}  // namespace lambert::hdr
