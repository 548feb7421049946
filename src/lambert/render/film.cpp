#include "lambert/render/film.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace lambert {
namespace {

struct AovDescription {
  Aov aov;
  const char* name;
  std::vector<std::string> channels;
  bool needs_features;
};

const std::array<AovDescription, 8>& aov_table() {
  static const std::array<AovDescription, 8> table{{
      {Aov::albedo, "albedo", {"albedo.R", "albedo.G", "albedo.B"}, true},
      {Aov::normal, "normal", {"normal.X", "normal.Y", "normal.Z"}, true},
      {Aov::depth, "depth", {"Z"}, true},
      {Aov::position, "position", {"position.X", "position.Y", "position.Z"}, true},
      {Aov::object_id, "object-id", {"object.id"}, true},
      {Aov::sample_count, "sample-count", {"samples.count"}, false},
      {Aov::variance, "variance", {"variance.Y"}, false},
      {Aov::denoising,
       "denoising",
       {"denoising.a.R",          "denoising.a.G",          "denoising.a.B",          "denoising.a.emission.R",
        "denoising.a.emission.G", "denoising.a.emission.B", "denoising.a.albedo.R",   "denoising.a.albedo.G",
        "denoising.a.albedo.B",   "denoising.a.normal.X",   "denoising.a.normal.Y",   "denoising.a.normal.Z",
        "denoising.a.depth.Z",    "denoising.b.R",          "denoising.b.G",          "denoising.b.B",
        "denoising.b.emission.R", "denoising.b.emission.G", "denoising.b.emission.B", "denoising.b.albedo.R",
        "denoising.b.albedo.G",   "denoising.b.albedo.B",   "denoising.b.normal.X",   "denoising.b.normal.Y",
        "denoising.b.normal.Z",   "denoising.b.depth.Z",    "denoising.variance.R",   "denoising.variance.G",
        "denoising.variance.B"},
       true},
  }};
  return table;
}

/// In double and with the same weights for single samples as for sums: a variance is their small difference.
double luminance_of(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

const AovDescription& describe(Aov a) { return aov_table()[static_cast<std::size_t>(a)]; }

}  // namespace

Aov aov(std::string_view name) {
  for (const AovDescription& d : aov_table())
    if (name == d.name) return d.aov;
  throw Error("unknown layer " + unknown_word(name, aov_names()));
}

std::vector<std::string> aov_names() {
  std::vector<std::string> names;
  for (const AovDescription& d : aov_table()) names.emplace_back(d.name);
  return names;
}

Film::Film(Vec2i resolution, const PixelRect& crop, std::vector<Aov> aovs)
    : resolution_(resolution), crop_(crop), aovs_(std::move(aovs)), pixels_(crop.area()) {
  if (std::any_of(aovs_.begin(), aovs_.end(), [](Aov a) { return describe(a).needs_features; }))
    features_.resize(crop.area());
  if (std::find(aovs_.begin(), aovs_.end(), Aov::denoising) != aovs_.end()) denoising_.resize(crop.area());
}

void Film::add(Vec2i pixel, const FilmSample& sample) {
  Pixel& p = pixels_[index(pixel)];
  const double w = static_cast<double>(sample.weight);
  p.r += w * static_cast<double>(sample.radiance.r);
  p.g += w * static_cast<double>(sample.radiance.g);
  p.b += w * static_cast<double>(sample.radiance.b);
  p.weight += w;
  const double y = w * luminance_of(static_cast<double>(sample.radiance.r), static_cast<double>(sample.radiance.g),
                                    static_cast<double>(sample.radiance.b));
  p.luminance_squared += y * y;
  p.unweighted += sample.radiance;
  ++p.count;

  if (!denoising_.empty()) {
    const bool first = first_half_ > 0 ? p.count <= first_half_ : p.count % 2 == 1;
    add_denoising(denoising_[index(pixel)], sample, first ? 0 : 1);
  }
  if (features_.empty() || sample.features.object == 0) return;
  FeatureSums& f = features_[index(pixel)];
  f.albedo += sample.features.albedo;
  f.normal += sample.features.normal;
  f.position += sample.features.position;
  f.depth += sample.features.depth;
  if (f.hits++ == 0) f.object = sample.features.object;
}

Rgb Film::mean(Vec2i pixel) const { return mean_of(pixels_[index(pixel)]); }

Rgb Film::mean_of(const Pixel& p) {
  if (p.count == 0) return {};
  if (!p.has_weight()) return p.unweighted / static_cast<float>(p.count);
  return {static_cast<float>(p.r / p.weight), static_cast<float>(p.g / p.weight), static_cast<float>(p.b / p.weight)};
}

double Film::variance_of_mean(Vec2i pixel) const {
  const Pixel& p = pixels_[index(pixel)];
  if (p.count < 2) return std::numeric_limits<double>::infinity();
  const double n = p.count, sum = luminance_of(p.r, p.g, p.b);
  return std::max(0.0, (p.luminance_squared - sum * sum / n) / (n * (n - 1)));
}

std::uint64_t Film::total_samples() const {
  std::uint64_t total = 0;
  for (const Pixel& p : pixels_) total += p.count;
  return total;
}

Film Film::average(const Film& a, const Film& b) {
  Film film(a.resolution_, a.crop_, a.aovs_);
  for (std::size_t i = 0; i < film.pixels_.size(); ++i) {
    const Pixel &pa = a.pixels_[i], &pb = b.pixels_[i];
    Pixel& p = film.pixels_[i];
    p.count = pa.count + pb.count;
    p.weight = p.count;
    const double share = pa.count > 0 && pb.count > 0 ? 0.5 : 1;
    // Sums as they would be if every sample of a half had that half's share, so that mean and variance read as usual.
    const auto add_half = [&](const Pixel& half) {
      if (half.count == 0) return;
      const bool weighted = half.has_weight();
      const double scale = share * p.count / (weighted ? half.weight : half.count);
      p.r += scale * (weighted ? half.r : static_cast<double>(half.unweighted.r));
      p.g += scale * (weighted ? half.g : static_cast<double>(half.unweighted.g));
      p.b += scale * (weighted ? half.b : static_cast<double>(half.unweighted.b));
      p.luminance_squared += scale * scale * half.luminance_squared;
    };
    add_half(pa), add_half(pb);
    if (film.features_.empty()) continue;
    const FeatureSums &fa = a.features_[i], &fb = b.features_[i];
    film.features_[i] = {fa.albedo + fb.albedo, fa.normal + fb.normal, fa.position + fb.position,
                         fa.depth + fb.depth,   fa.hits + fb.hits,     fa.hits ? fa.object : fb.object};
  }
  for (std::size_t i = 0; i < film.denoising_.size(); ++i)
    film.denoising_[i] = average_denoising(a.denoising_[i], b.denoising_[i]);
  return film;
}

void Film::write_layer(Image& image, Aov layer, std::size_t c) const {
  for (int y = crop_.min.y; y < crop_.max.y; ++y) {
    for (int x = crop_.min.x; x < crop_.max.x; ++x) {
      const Vec2i at(x, y), to = at - crop_.min;
      const auto put = [&](std::size_t i, float v) { image.at(to.x, to.y, c + i) = v; };
      if (layer == Aov::sample_count) put(0, static_cast<float>(sample_count(at)));
      if (layer == Aov::variance) put(0, sample_count(at) < 2 ? 0 : static_cast<float>(variance_of_mean(at)));
      if (!describe(layer).needs_features) continue;
      const FeatureSums& f = features_[index(at)];
      const float scale = f.hits ? 1.0f / static_cast<float>(f.hits) : 0.0f;
      const float coverage = static_cast<float>(f.hits) / std::max(1.0f, static_cast<float>(sample_count(at)));
      for (int i = 0; i < 3; ++i) {
        const auto channel = static_cast<std::size_t>(i);
        if (layer == Aov::albedo) put(channel, f.albedo[i] * scale * coverage);
        if (layer == Aov::normal) put(channel, f.normal[i] * scale);
        if (layer == Aov::position) put(channel, f.position[i] * scale);
      }
      if (layer == Aov::depth) put(0, f.depth * scale);
      if (layer == Aov::object_id) put(0, static_cast<float>(f.object));
    }
  }
}

Image Film::develop() const {
  std::vector<std::string> channels = rgb_channels();
  for (Aov a : aovs_) channels.insert(channels.end(), describe(a).channels.begin(), describe(a).channels.end());
  Image image(crop_.size().x, crop_.size().y, std::move(channels));
  for (int y = crop_.min.y; y < crop_.max.y; ++y)
    for (int x = crop_.min.x; x < crop_.max.x; ++x) image.set_rgb(x - crop_.min.x, y - crop_.min.y, mean({x, y}));
  std::size_t channel = 3;
  for (Aov a : aovs_) {
    a == Aov::denoising ? write_denoising(image, channel) : write_layer(image, a, channel);
    channel += describe(a).channels.size();
  }
  return image;
}

}  // namespace lambert
