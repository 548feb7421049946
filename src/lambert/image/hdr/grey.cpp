#include "lambert/image/hdr/grey.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {

Grey grey_of(const ExposureStack& stack, std::size_t frame) {
  Grey grey{.width = stack.width, .height = stack.height};
  grey.pixels.resize(static_cast<std::size_t>(stack.width) * static_cast<std::size_t>(stack.height));
  const auto width = static_cast<std::size_t>(stack.width);
  const bool colour = stack.channels == 3, wide = stack.levels > 256;
  stack.with_code_type([&]<class Code>(Code) {
    parallel_for(static_cast<std::size_t>(stack.height), [&](std::size_t y) {
      const Code* codes = stack.row<Code>(frame, static_cast<int>(y));
      std::uint8_t* to = grey.pixels.data() + y * width;
      for (std::size_t x = 0; x < width; ++x) {
        const std::uint32_t sum =
            colour ? (54u * codes[3 * x] + 183u * codes[3 * x + 1] + 19u * codes[3 * x + 2]) / 256u : codes[x];
        to[x] = static_cast<std::uint8_t>(
            wide ? static_cast<std::uint32_t>(std::sqrt(static_cast<float>(sum) * (255.0f * 255.0f / 65535.0f))) : sum);
      }
    });
  });
  return grey;
}

Grey halved(const Grey& grey) {
  Grey half{.width = grey.width / 2, .height = grey.height / 2};
  half.pixels.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  for (int y = 0; y < half.height; ++y) {
    const std::uint8_t *a = grey.row(2 * y), *b = grey.row(2 * y + 1);
    std::uint8_t* to = half.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(half.width);
    for (int x = 0; x < half.width; ++x)
      to[x] = static_cast<std::uint8_t>((a[2 * x] + a[2 * x + 1] + b[2 * x] + b[2 * x + 1] + 2) / 4);
  }
  return half;
}

std::vector<Grey> pyramid(Grey grey, int levels) {
  std::vector<Grey> all{std::move(grey)};
  while (static_cast<int>(all.size()) < levels && std::min(all.back().width, all.back().height) >= 16)
    all.push_back(halved(all.back()));
  return all;
}

}  // namespace lambert::hdr
