#include "lambert/formats/pbrt/infinite_light.h"

#include "lambert/base/file.h"
#include "lambert/formats/pbrt/spectra.h"
#include "lambert/image/io.h"
#include "lambert/image/probe/octahedral.h"

#include <filesystem>
#include <utility>

namespace lambert::pbrt {
namespace {

/// Of an upward-facing patch, in pbrt's measure: it weights each of N pixels with 2π/N, half its solid angle, and so do
/// we, since scenes are tuned to the pictures that this gives.
float upward_illuminance(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width()),
                    (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height()));
      const float z = probe::equal_area_square_to_sphere(uv).z;
      if (z > 0) sum += static_cast<double>(luminance(image.rgb(x, y)) * z);
    }
  }
  const double pixels = static_cast<double>(image.width()) * static_cast<double>(image.height());
  return static_cast<float>(sum * 2 * static_cast<double>(pi) / pixels);
}

void check_finite(const ParameterList& list, const Image& image, const std::string& filename) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (is_finite(image.rgb(x, y))) continue;
      list.fail(filename + ": pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is not finite");
    }
  }
}

EnvironmentLight image_light(const Context& context, const ParameterList& list, const GraphicsState& state,
                             const std::string& filename) {
  Image image = at_directive(list, [&] {
    const std::filesystem::path path = context.resolve(filename);
    return displayed(decode_image(MappedFile(path).bytes(), path.string()));  // never standard input
  });
  check_finite(list, image, filename);
  const bool equal_area = image.width() == image.height();
  if (!equal_area) context.notes.add("an infinite light's image is not square: read as latitude and longitude, +y up");
  float scale = list.number("scale", 1);
  const float illuminance = list.number("illuminance", -1);
  if (illuminance > 0 && equal_area) {
    const float unscaled = upward_illuminance(image);
    if (unscaled > 0) scale *= illuminance / unscaled;
  }
  const auto mapping = equal_area ? EnvironmentMapping::equal_area : EnvironmentMapping::lat_long;
  return {std::move(image), mapping, Rgb(scale), state.ctm};
}

}  // namespace

EnvironmentLight infinite_light(const Context& context, const ParameterList& list, const GraphicsState& state) {
  if (list.find("portal", {ParameterType::point3})) context.notes.add("the 'portal' of an infinite light is ignored");
  const std::string filename = list.string("filename", list.string("mapname", ""));
  if (!filename.empty()) {
    if (list.has("L")) list.fail("takes 'L' or 'filename', not both");
    return image_light(context, list, state, filename);
  }
  const float illuminance = list.number("illuminance", -1);
  const float scale = list.number("scale", 1) * (illuminance > 0 ? illuminance / pi : 1);
  return EnvironmentLight(rgb_value(context, list, "L", Rgb(1.0f), SpectrumRole::illuminant) * scale);
}

}  // namespace lambert::pbrt
