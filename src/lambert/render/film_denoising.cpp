#include "lambert/render/film.h"

#include <algorithm>
#include <limits>

namespace lambert {

void Film::HalfSums::add(const HalfSums& other) {
  for (std::size_t i = 0; i < values; ++i) {
    weighted[i] += other.weighted[i];
    unweighted[i] += other.unweighted[i];
  }
  weight += other.weight;
  count += other.count;
}

void Film::add_denoising(DenoisingSums& to, const FilmSample& sample, std::size_t half) {
  const Guide& g = sample.features.guide;
  const Rgb scattered = sample.radiance - g.emission;
  HalfSums one{.unweighted = {scattered.r, scattered.g, scattered.b, g.emission.r, g.emission.g, g.emission.b,
                              g.albedo.r, g.albedo.g, g.albedo.b, g.normal.x, g.normal.y, g.normal.z, g.distance},
               .weight = static_cast<double>(sample.weight),
               .count = 1};
  for (std::size_t i = 0; i < HalfSums::values; ++i)
    one.weighted[i] = one.weight * static_cast<double>(one.unweighted[i]);
  for (std::size_t c = 0; c < 3; ++c) to.squared[c] += one.weighted[c] * one.weighted[c];
  to.halves[half].add(one);
}

Film::DenoisingSums Film::average_denoising(const DenoisingSums& a, const DenoisingSums& b) {
  DenoisingSums both = a;
  both.halves[0].add(a.halves[1]);
  both.halves[1] = b.halves[0];
  both.halves[1].add(b.halves[1]);
  for (std::size_t c = 0; c < 3; ++c) both.squared[c] += b.squared[c];
  return both;
}

void Film::write_denoising(Image& image, std::size_t first) const {
  for (int y = 0; y < crop_.size().y; ++y)
    for (int x = 0; x < crop_.size().x; ++x) {
      const DenoisingSums& d = denoising_[index(crop_.min + Vec2i(x, y))];
      HalfSums all = d.halves[0];
      all.add(d.halves[1]);
      if (all.count == 0) continue;
      std::size_t channel = first;
      const auto put = [&](double v) { image.at(x, y, channel++) = static_cast<float>(v); };
      for (const HalfSums& measured : d.halves) {
        const HalfSums& half = measured.count > 0 ? measured : all;
        const bool has_weight = half.weight > 0.1 * half.count;  // as in Pixel
        for (std::size_t i = 0; i < HalfSums::values; ++i)
          put(has_weight ? half.weighted[i] / half.weight : static_cast<double>(half.unweighted[i]) / half.count);
      }
      const double n = all.count;
      for (std::size_t c = 0; c < 3; ++c)
        put(n < 2 ? std::numeric_limits<double>::infinity()
                  : std::max(0.0, (d.squared[c] - all.weighted[c] * all.weighted[c] / n) / (n * (n - 1))));
    }
}

}  // namespace lambert
