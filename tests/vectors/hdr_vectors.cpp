#include "vectors.h"

#include "lambert/image/hdr/merge.h"
#include "lambert/image/hdr/range.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

// rows: LF-15
const CheckOf shortfall("V-LF-03", [](const Vector& v) {
  const double range = v.input.at("world_range").get<double>();
  v.expect_near(hdr::shortfall(range, 8), v.expected.at("bits8"));
  v.expect_near(hdr::shortfall(range, 12), v.expected.at("bits12"));
});

// rows: LF-17
const CheckOf map_range("V-LF-04", [](const Vector& v) {
  Image map(2, 1, {"Y"});
  map.at(0, 0, 0) = v.input.at("max").get<float>(), map.at(1, 0, 0) = v.input.at("min").get<float>();
  const hdr::RadianceRange range = hdr::radiance_range(map);
  v.expect_near(range.ratio(), v.expected.at("ratio"));
  v.expect_near(hdr::step_size(range, 8), v.expected.at("per_8bit_step"));
});

// rows: LF-11
// With 257 codes its pixel values, which are quarters and eighths, are codes.
const CheckOf merged("V-LF-14", [](const Vector& v) {
  hdr::ExposureStack stack{.width = 2, .height = 1, .channels = 1, .levels = 257};
  for (const std::size_t j : {1u, 0u}) {  // the shorter one first
    std::vector<std::uint16_t> codes;
    for (const auto& value : v.input.at("pixel")[j])
      codes.push_back(static_cast<std::uint16_t>(std::lround(value.get<double>() * 256)));
    stack.frames.push_back(
        {.name = "exposure", .exposure = v.input.at("exposure")[j].get<double>(), .codes = std::move(codes)});
  }
  const Image image = hdr::merge(stack, hdr::response_named("linear", 1, 257)).image;
  for (int x = 0; x < 2; ++x) v.expect_near(image.at(x, 0, 0), v.expected.at("radiance")[static_cast<std::size_t>(x)]);
});

}  // namespace
}  // namespace lambert
