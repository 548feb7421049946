#include "vectors.h"

#include "lambert/image/tonemap/tonemap.h"

#include <gtest/gtest.h>

#include <vector>

namespace lambert {
namespace {

Image greys(const std::vector<float>& values) {
  Image image(static_cast<int>(values.size()), 1, rgb_channels());
  for (std::size_t i = 0; i < values.size(); ++i) image.set_rgb(static_cast<int>(i), 0, Rgb(values[i]));
  return image;
}

// rows: LF-24
const CheckOf reinhard("V-LF-12", [](const Vector& v) {
  const Image shown = tonemap(greys(v.input.at("L").get<std::vector<float>>()), {.op = tone::Reinhard{}});
  for (int x = 0; x < shown.width(); ++x)
    v.expect_near(shown.rgb(x, 0).g, v.expected.at("Ld")[static_cast<std::size_t>(x)]);
});

// rows: LF-22
// The reading by the range of values (E-LF-09): white is 0.1 % of the largest.
const CheckOf darkest("V-LF-13", [](const Vector& v) {
  auto values = v.input.at("L").get<std::vector<float>>();
  const std::size_t count = values.size();
  values.push_back(v.input.at("max").get<float>());
  const Image shown = tonemap(greys(values), {.op = tone::DarkestRange{}});
  for (std::size_t i = 0; i < count; ++i)
    v.expect_near(shown.rgb(static_cast<int>(i), 0).g, v.expected.at("display")[i]);
});

}  // namespace
}  // namespace lambert
