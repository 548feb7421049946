#include "lambert/render/film.h"

#include <algorithm>
#include <limits>

namespace lambert {

template <std::size_t N>
void Film::Sums<N>::add(const Sums& other) {
  for (std::size_t i = 0; i < N; ++i) weighted[i] += other.weighted[i], unweighted[i] += other.unweighted[i];
  weight += other.weight;
  count += other.count;
}

template <std::size_t N>
void Film::Sums<N>::add(const std::array<float, N>& values, float w) {
  for (std::size_t i = 0; i < N; ++i) {
    weighted[i] += static_cast<double>(w) * static_cast<double>(values[i]);
    unweighted[i] += values[i];
  }
  weight += static_cast<double>(w);
  ++count;
}

template <std::size_t N>
std::array<double, N> Film::Sums<N>::mean() const {
  std::array<double, N> result{};
  if (count == 0) return result;
  const bool has_weight = weight > 0.1 * count;
  for (std::size_t i = 0; i < N; ++i)
    result[i] = has_weight ? weighted[i] / weight : static_cast<double>(unweighted[i]) / count;
  return result;
}

void Film::add_denoising(DenoisingSums& to, const FilmSample& sample, std::size_t half) {
  const Guide& g = sample.features.guide;
  const Rgb scattered = sample.radiance - g.emission;
  to.halves[half].add({scattered.r, scattered.g, scattered.b, g.albedo.r, g.albedo.g, g.albedo.b, g.normal.x,
                       g.normal.y, g.normal.z, g.distance},
                      sample.weight);
  to.emission[half].add({g.emission.r, g.emission.g, g.emission.b}, sample.weight);
  for (int c = 0; c < 3; ++c) {
    const double y = static_cast<double>(sample.weight) * static_cast<double>(scattered[c]);
    to.squared[static_cast<std::size_t>(c)] += y * y;
  }
}

void Film::add_emission(Vec2i pixel, std::size_t half, Rgb emission, float weight) {
  denoising_[index(pixel)].emission[half].add({emission.r, emission.g, emission.b}, weight);
}

std::array<Rgb, 2> Film::emission(Vec2i pixel) const {
  std::array<Rgb, 2> means;
  for (std::size_t half = 0; half < 2; ++half) {
    const auto e = denoising_[index(pixel)].emission[half].mean();
    means[half] = {static_cast<float>(e[0]), static_cast<float>(e[1]), static_cast<float>(e[2])};
  }
  return means;
}

Film::DenoisingSums Film::average_denoising(const DenoisingSums& a, const DenoisingSums& b) {
  DenoisingSums both = a;
  both.halves[0].add(a.halves[1]), both.emission[0].add(a.emission[1]);
  both.halves[1] = b.halves[0], both.emission[1] = b.emission[0];
  both.halves[1].add(b.halves[1]), both.emission[1].add(b.emission[1]);
  for (std::size_t c = 0; c < 3; ++c) both.squared[c] += b.squared[c];
  return both;
}

void Film::write_denoising(Image& image, std::size_t first) const {
  for (int y = 0; y < crop_.size().y; ++y)
    for (int x = 0; x < crop_.size().x; ++x) {
      const DenoisingSums& d = denoising_[index(crop_.min + Vec2i(x, y))];
      Sums<10> all = d.halves[0];
      all.add(d.halves[1]);
      if (all.count == 0) continue;
      std::size_t channel = first;
      const auto put = [&](double v) { image.at(x, y, channel++) = static_cast<float>(v); };
      for (std::size_t half = 0; half < 2; ++half) {
        // A half without samples says what the other one says.
        const std::size_t used = d.halves[half].count > 0 ? half : 1 - half;
        const std::array<double, 10> mean = d.halves[used].mean();
        for (std::size_t c = 0; c < 3; ++c) put(mean[c]);
        for (const double e : d.emission[d.emission[half].count > 0 ? half : used].mean()) put(e);
        for (std::size_t i = 3; i < mean.size(); ++i) put(mean[i]);
      }
      const double n = all.count;
      for (std::size_t c = 0; c < 3; ++c)
        put(n < 2 ? std::numeric_limits<double>::infinity()
                  : std::max(0.0, (d.squared[c] - all.weighted[c] * all.weighted[c] / n) / (n * (n - 1))));
    }
}

}  // namespace lambert
