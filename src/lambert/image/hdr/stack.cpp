#include "lambert/image/hdr/stack.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/number.h"
#include "lambert/base/parallel.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/io.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {
namespace {

std::size_t colours(int channels) { return channels >= 3 ? 3 : 1; }

Texels read_codes(const std::string& file) {
  const MappedFile mapped = open_input(file);
  Texels t = decode_texels(mapped.bytes(), input_name(file));
  if (t.linear)
    throw Error(input_name(file) +
                ": holds radiance already, not the codes of a photograph (PNG, JPEG, TIFF and WebP have them)");
  return t;
}

/// Bytes where the file has them and the stack takes them, else words. Alpha is left out.
Codes codes_of(Texels&& t, bool sixteen_bits) {
  const auto from = static_cast<std::size_t>(t.channels), to = colours(t.channels);
  if (!sixteen_bits && from == to) return std::move(t.bytes);
  const std::size_t count = static_cast<std::size_t>(t.width) * static_cast<std::size_t>(t.height);
  const auto gather = [&]<class Code>(const auto& values, const auto& code_of, std::vector<Code> codes) {
    codes.resize(count * to);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t c = 0; c < to; ++c) codes[i * to + c] = static_cast<Code>(code_of(values[i * from + c]));
    return codes;
  };
  if (!sixteen_bits)
    return gather(
        t.bytes, [](unsigned v) { return v; }, std::vector<std::uint8_t>());
  if (t.floats.empty())
    return gather(
        t.bytes, [](unsigned v) { return v * 257; }, std::vector<std::uint16_t>());
  const auto rounded = [](float v) { return std::clamp(v, 0.0f, 1.0f) * 65535 + 0.5f; };
  return gather(t.floats, rounded, std::vector<std::uint16_t>());
}

std::string size_text(const Texels& t) { return std::to_string(t.width) + "x" + std::to_string(t.height); }

/// How much brighter the second of two photographs is, in codes per pixel, where neither is black or saturated.
struct Difference {
  double mean = 0;
  std::size_t count = 0;
};
Difference brightening(const ExposureStack& stack, std::size_t a, std::size_t b) {
  const int low = stack.levels / 64, high = stack.levels - 1 - low;
  const std::size_t rows = static_cast<std::size_t>(stack.height), n = stack.row_size(), step = stack.row_step(500000);
  return stack.with_code_type([&]<class Code>(Code) {
    std::int64_t sum = 0;
    std::size_t count = 0;
    for (std::size_t r = 0; r < rows; r += step) {
      const Code *x = stack.row<Code>(a, static_cast<int>(r)), *y = stack.row<Code>(b, static_cast<int>(r));
      for (std::size_t i = 0; i < n; ++i) {
        const int p = x[i], q = y[i];
        const int use = (p <= high) & (q <= high) & ((p >= low) | (q >= low));
        sum += use * (q - p), count += static_cast<std::size_t>(use);
      }
    }
    return Difference{count ? static_cast<double>(sum) / static_cast<double>(count) : 0, count};
  });
}

}  // namespace

ExposureStack read_stack(const std::vector<std::string>& files, const std::vector<double>& exposures,
                         const FractionSink& progress) {
  if (files.empty()) throw Error("no photographs given");
  std::vector<Texels> texels(files.size());
  parallel_for(files.size(), progress, [&](std::size_t i) { texels[i] = read_codes(files[i]); });
  ExposureStack stack;
  stack.width = texels[0].width, stack.height = texels[0].height;
  stack.channels = colours(texels[0].channels);
  const bool sixteen_bits =
      std::any_of(texels.begin(), texels.end(), [](const Texels& t) { return !t.floats.empty(); });
  stack.levels = sixteen_bits ? 65536 : 256;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Texels& t = texels[i];
    if (t.width != stack.width || t.height != stack.height)
      throw Error(input_name(files[i]) + ": is " + size_text(t) + " pixels, but " + input_name(files[0]) + " is " +
                  size_text(texels[0]));
    if (colours(t.channels) != stack.channels)
      throw Error(input_name(files[i]) + ": is " + (stack.channels == 1 ? "in colour" : "grey") + ", but " +
                  input_name(files[0]) + " is not");
  }
  stack.frames.resize(files.size());
  parallel_for(files.size(), [&](std::size_t i) {
    stack.frames[i] = {
        .name = input_name(files[i]), .exposure = exposures[i], .codes = codes_of(std::move(texels[i]), sixteen_bits)};
  });
  return stack;
}

void check_exposures(ExposureStack& stack) {
  auto& frames = stack.frames;
  std::stable_sort(frames.begin(), frames.end(),
                   [](const Frame& a, const Frame& b) { return a.exposure < b.exposure; });
  if (frames.size() < 2) return;
  if (frames.back().exposure < 1.01 * frames.front().exposure)
    throw Error("all photographs have the same exposure (" + number_text(frames.front().exposure) +
                "): no more range can be had from them");
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double ratio = frames[i].exposure / frames[i - 1].exposure;
    if (ratio < 1.01) continue;
    const Difference d = brightening(stack, i - 1, i);
    const double code = stack.levels / 256.0;
    const double expected = ratio > 1.3 ? 0.25 * code : -0.5 * code;  // a third of a stop is seen, through noise too
    if (d.count >= 64 && d.mean < expected)
      throw Error(frames[i].name + ": is not brighter than " + frames[i - 1].name + " though its exposure is " +
                  number_text(std::round(1000 * ratio) / 1000) + " times as long: the exposures contradict the images");
  }
}

}  // namespace lambert::hdr
