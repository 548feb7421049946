#pragma once
/// Removes the noise of rendered images, guided by what the renderer knows of each pixel. Nothing is learned from other
/// pictures.

#include "lambert/base/progress.h"
#include "lambert/image/denoise/bilateral.h"
#include "lambert/image/denoise/nfor.h"
#include "lambert/image/denoise/nlm.h"
#include "lambert/image/image.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class DenoiseMethod : std::uint8_t {
  automatic,  ///< Open Image Denoise where the machine has it, otherwise nfor
  nfor,       ///< first-order regression on guides (Bitterli et al. 2016)
  nlm,        ///< non-local means of two halves (Rousselle et al. 2012)
  bilateral,  ///< cross-bilateral
  oidn,       ///< Open Image Denoise, loaded at run time
};
DenoiseMethod denoise_method(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> denoise_method_names();

struct DenoiseSettings {
  DenoiseMethod method = DenoiseMethod::automatic;
  denoise::GatherSettings input;
  denoise::NforSettings nfor;
  denoise::NlmSettings nlm;
  denoise::BilateralSettings bilateral;
  std::string oidn_library;  ///< path; empty: as the system finds it
  bool keep_layers = false;  ///< the layers "denoising.…" stay
  FractionSink progress = {};
};

/// The image with its colour denoised, as R, G, B (or Y), and its other channels as they are, those named "denoising.…"
/// only if they are to be kept. Which channels are used: see denoise::gather(). The result does not depend on the
/// number of threads. The metadata "denoiser" names the method that was used. Throws Error where there is no colour,
/// and for oidn where there is no library or it fails.
Image denoise_image(const Image& image, const DenoiseSettings& settings = {});

}  // namespace lambert
