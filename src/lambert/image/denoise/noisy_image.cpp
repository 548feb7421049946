#include "lambert/image/denoise/noisy_image.h"

#include "lambert/base/error.h"
#include "lambert/image/denoise/fireflies.h"
#include "lambert/image/denoise/layer_names.h"
#include "lambert/image/denoise/noise_level.h"
#include "lambert/image/denoise/repair.h"

#include <algorithm>
#include <cmath>

namespace lambert::denoise {
namespace {

using Channels = std::vector<std::size_t>;

Plane plane_of(const Image& image, std::size_t channel) {
  Plane plane(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) plane.at(x, y) = image.at(x, y, channel);
  return plane;
}

/// Three planes of three channels, or of one thrice.
Colour colour_of(const Image& image, const std::vector<std::size_t>& channels) {
  Colour c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = plane_of(image, channels[channels.size() == 1 ? 0 : i]);
  return c;
}

/// A quarter of the squared difference of two halves, over 3x3 pixels: the variance of their mean.
Plane variance_of_halves(const Plane& a, const Plane& b) {
  Plane squared = a;
  for (std::size_t i = 0; i < b.values().size(); ++i) {
    const float d = a.values()[i] - b.values()[i];
    squared.values()[i] = 0.25f * d * d;
  }
  return box_mean(squared, 1);
}
Plane mean_of(const Plane& a, const Plane& b) {
  Plane mean = a;
  for (std::size_t i = 0; i < b.values().size(); ++i) mean.values()[i] = 0.5f * (a.values()[i] + b.values()[i]);
  return mean;
}

Plane finite_plane(const Image& image, std::size_t channel) {
  Plane plane = plane_of(image, channel);
  repair(plane);
  return plane;
}

/// A guide from two halves, from one mean with its variance, or from a mean that is taken to be free of noise.
void add_guide(NoisyImage& to, const Image& image, GuideKind kind, const std::array<Channels, 2>& halves,
               const Channels& means, const Channels& variances) {
  Guide guide{.kind = kind};
  for (std::size_t i = 0; i < halves[0].size() && !halves[1].empty(); ++i) {
    const Plane a = finite_plane(image, halves[0][i]), b = finite_plane(image, halves[1][i]);
    guide.mean.push_back(mean_of(a, b));
    guide.variance.push_back(variance_of_halves(a, b));
  }
  for (std::size_t i = 0; i < means.size() && guide.mean.size() < means.size(); ++i) {
    guide.mean.push_back(finite_plane(image, means[i]));
    guide.variance.push_back(variances.size() == means.size() ? plane_of(image, variances[i])
                                                              : Plane(image.width(), image.height()));
    for (float& v : guide.variance.back().values()) v = std::isfinite(v) ? std::max(v, 0.0f) : 0.0f;
  }
  if (!guide.mean.empty()) to.guides.push_back(std::move(guide));
}

void add_guides(NoisyImage& to, const Image& image) {
  const auto halves = [&](auto find, const std::string& layer) {
    const std::string a = "denoising.a." + layer, b = "denoising.b." + layer;
    return std::array<Channels, 2>{find(image, {a}), find(image, {b})};
  };
  add_guide(to, image, GuideKind::albedo, halves(find_triple, "albedo"), albedo_channels(image),
            find_triple(image, {"albedo.variance", "albedo_variance"}));
  add_guide(to, image, GuideKind::normal, halves(find_triple, "normal"), normal_channels(image),
            find_triple(image, {"normal.variance", "N_variance"}));
  add_guide(to, image, GuideKind::depth, halves(find_single, "depth.Z"),
            find_single(image, {"Denoising Depth.Z", "Depth.Z", "depth.Z", "Z"}),
            find_single(image, {"Z.variance", "Z_variance"}));
}

void add_emission(NoisyImage& to, const Image& image) {
  to.emission = to.emission_variance = black(image.width(), image.height());
  const Channels a = find_triple(image, {"denoising.a.emission"}), b = find_triple(image, {"denoising.b.emission"});
  for (std::size_t c = 0; c < 3 && !a.empty() && !b.empty(); ++c) {
    const Plane half_a = finite_plane(image, a[c]), half_b = finite_plane(image, b[c]);
    to.emission[c] = mean_of(half_a, half_b);
    to.emission_variance[c] = variance_of_halves(half_a, half_b);
  }
}

}  // namespace

const Guide* NoisyImage::guide(GuideKind kind) const {
  const auto found = std::find_if(guides.begin(), guides.end(), [&](const Guide& g) { return g.kind == kind; });
  return found == guides.end() ? nullptr : &*found;
}

std::vector<std::size_t> colour_channels(const Image& image) {
  if (auto bare = find_triple(image, {""}); !bare.empty()) return bare;
  if (const auto grey = image.channel("Y")) return {*grey};
  if (auto layer = find_triple(image, {"Noisy Image", "Combined", "beauty", "rgba"}); !layer.empty()) return layer;
  throw Error("denoising needs colour: channels R, G, B or Y, or a layer 'Combined'");
}

std::vector<std::size_t> albedo_channels(const Image& image) {
  return find_triple(image, {"albedo", "Denoising Albedo", "Albedo", "diffuse_albedo"});
}
std::vector<std::size_t> normal_channels(const Image& image) {
  return find_triple(image, {"normal", "Denoising Normal", "Normal", "N", "Ns"});
}

NoisyImage gather(const Image& image, const GatherSettings& settings) {
  NoisyImage result{.width = image.width(), .height = image.height()};
  const auto half_a = find_triple(image, {"denoising.a"}), half_b = find_triple(image, {"denoising.b"});
  result.measured_halves = !half_a.empty() && !half_b.empty();

  auto channels = find_triple(image, {"denoising.variance", "variance", "Variance"});
  if (channels.empty()) channels = find_single(image, {"variance.Y", "variance"});
  const Colour noisy = colour_of(image, colour_channels(image));
  if (!channels.empty()) result.variance = colour_of(image, channels);
  if (result.measured_halves) {
    result.halves = {colour_of(image, half_a), colour_of(image, half_b)};
    for (Colour& half : result.halves)
      for (Plane& plane : half) repair(plane);
    for (std::size_t c = 0; c < 3 && channels.empty(); ++c)
      result.variance[c] = variance_of_halves(result.halves[0][c], result.halves[1][c]);
  } else {
    result.halves = {noisy, noisy};
    for (Colour& half : result.halves)
      for (Plane& plane : half) repair(plane);
    if (channels.empty()) result.variance = black(image.width(), image.height());
  }
  if (channels.empty() && !result.measured_halves)
    for (Plane& plane : result.variance) std::fill(plane.values().begin(), plane.values().end(), INFINITY);
  fill_unknown_variance(result);
  if (settings.firefly > 0) clamp_fireflies(result, settings.firefly);
  if (result.measured_halves)
    fit_variance_to_halves(result);
  else
    split(result);
  if (settings.use_guides) add_guides(result, image);
  add_emission(result, image);
  return result;
}

}  // namespace lambert::denoise
