#include "lambert/image/denoise/denoise.h"

#include "lambert/base/error.h"
#include "lambert/image/denoise/guide_filter.h"
#include "lambert/image/denoise/oidn.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert {
namespace {

using denoise::Colour;

constexpr std::array<std::pair<std::string_view, DenoiseMethod>, 5> methods{{
    {"auto", DenoiseMethod::automatic},
    {"nfor", DenoiseMethod::nfor},
    {"nlm", DenoiseMethod::nlm},
    {"bilateral", DenoiseMethod::bilateral},
    {"oidn", DenoiseMethod::oidn},
}};

void scale(Colour& colour, float factor) {
  for (denoise::Plane& plane : colour)
    for (float& v : plane.values()) v *= factor;
}

/// The filters see a picture of about unit brightness, so that their result does not depend on the unit of radiance.
Colour filtered(const Image& image, const DenoiseSettings& settings, DenoiseMethod method) {
  denoise::NoisyImage noisy = denoise::gather(image, settings.input);
  const float unit = denoise::brightness_unit(noisy, denoise::modulation({}, noisy.width, noisy.height));
  for (Colour* colour : {&noisy.halves[0], &noisy.halves[1], &noisy.emission}) scale(*colour, 1 / unit);
  for (Colour* variance : {&noisy.variance, &noisy.emission_variance}) {
    scale(*variance, 1 / unit);
    scale(*variance, 1 / unit);
  }
  Colour result = method == DenoiseMethod::nlm         ? denoise_nlm(noisy, settings.nlm, settings.progress)
                  : method == DenoiseMethod::bilateral ? denoise_bilateral(noisy, settings.bilateral)
                                                       : denoise_nfor(noisy, settings.nfor, settings.progress);
  scale(result, unit);
  return result;
}

/// `image` with its colour replaced.
Image with_colour(const Image& image, const std::vector<std::size_t>& colour, const Colour& result, bool keep_layers) {
  std::vector<std::string> names = colour.size() == 1 ? std::vector<std::string>{"Y"} : rgb_channels();
  std::vector<std::size_t> kept;
  for (std::size_t c = 0; c < image.channel_count(); ++c) {
    const bool is_colour = std::find(colour.begin(), colour.end(), c) != colour.end();
    if (is_colour || (!keep_layers && image.channels()[c].starts_with("denoising."))) continue;
    kept.push_back(c);
    names.push_back(image.channels()[c]);
  }
  Image out(image.width(), image.height(), std::move(names));
  out.metadata = image.metadata;
  out.place({image.data_window().x, image.data_window().y}, image.display_window());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      std::size_t to = 0;
      for (; to < colour.size(); ++to) out.at(x, y, to) = result[to].at(x, y);
      for (const std::size_t c : kept) out.at(x, y, to++) = image.at(x, y, c);
    }
  return out;
}

}  // namespace

DenoiseMethod denoise_method(std::string_view name) {
  for (const auto& [known, method] : methods)
    if (known == name) return method;
  throw Error("unknown method of denoising " + unknown_word(name, denoise_method_names()));
}

std::vector<std::string> denoise_method_names() {
  std::vector<std::string> names;
  for (const auto& [name, method] : methods) names.emplace_back(name);
  return names;
}

Image denoise_image(const Image& image, const DenoiseSettings& settings) {
  const std::vector<std::size_t> colour = denoise::colour_channels(image);
  DenoiseMethod method = settings.method;
  Colour result;
  std::string name;
  const auto library = method == DenoiseMethod::automatic || method == DenoiseMethod::oidn
                           ? denoise::Oidn::find(settings.oidn_library)
                           : nullptr;
  if (library) {
    result = library->denoise(image);
    name = library->name();
  } else {
    if (method == DenoiseMethod::oidn) throw Error(denoise::Oidn::not_found(settings.oidn_library));
    if (method == DenoiseMethod::automatic) method = DenoiseMethod::nfor;
    result = filtered(image, settings, method);
    for (const auto& [known, m] : methods)
      if (m == method) name = known;
  }
  Image out = with_colour(image, colour, result, settings.keep_layers);
  out.metadata["denoiser"] = name;
  return out;
}

}  // namespace lambert
