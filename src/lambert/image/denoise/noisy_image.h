#pragma once
/// What a denoiser works on, gathered from the channels of an image.

#include "lambert/image/denoise/plane.h"
#include "lambert/image/image.h"

#include <cstdint>
#include <vector>

namespace lambert::denoise {

/// What a layer of the scene's surfaces says.
enum class GuideKind : std::uint8_t { albedo, normal, depth };

/// A layer that shares its edges with the colour and has little noise: 3 planes, 1 for depth.
struct Guide {
  GuideKind kind = GuideKind::albedo;
  std::vector<Plane> mean, variance;  ///< variance of the mean; zero where the file says nothing
};

/// Everything is finite.
struct NoisyImage {
  int width = 0, height = 0;
  /// Two estimates of the same picture whose errors are independent; their mean and `emission` are the noisy picture.
  std::array<Colour, 2> halves;
  /// Of the mean of the halves.
  Colour variance;
  std::vector<Guide> guides;
  /// Light that comes from lamps and sky straight or through mirrors and glass: what noise it has comes from the edges
  /// of things within a pixel, the lens, or the choice between reflection and refraction. Black where the file does not
  /// tell it apart.
  Colour emission, emission_variance;
  bool measured_halves = false;  ///< those of the file

  const Guide* guide(GuideKind kind) const;
};

struct GatherSettings {
  bool use_guides = true;
  /// A pixel of one half is at most this times the brightest of what stands around it, the outliers among those left
  /// out, or what the other half says; 0: off.
  float firefly = 5;
};

/// Colour: R, G, B, or Y, or the layers "Noisy Image" or "Combined". Halves and variances: those of `lambert render
/// --aov denoising`; otherwise halves are made from the variance ("variance.R" or ".Y", or as measured in the image
/// itself) by adding and subtracting noise of the same variance, which makes them uncorrelated (independent for
/// Gaussian noise: Oliveira, Lei and Tibshirani, "Unbiased Risk Estimation in the Normal Means Problem via Coupled
/// Bootstrap Techniques", 2021). Guides: "denoising.albedo", "albedo", "Denoising Albedo" and their like, under any
/// layer's name. Numbers that are not finite are replaced by the mean of their neighbours. Throws Error when there is
/// no colour.
NoisyImage gather(const Image& image, const GatherSettings& settings = {});

/// The places of the colour in `image`: three, or one for grey. Throws Error when there is none.
std::vector<std::size_t> colour_channels(const Image& image);
/// Three, or none.
std::vector<std::size_t> albedo_channels(const Image& image);
std::vector<std::size_t> normal_channels(const Image& image);

}  // namespace lambert::denoise
