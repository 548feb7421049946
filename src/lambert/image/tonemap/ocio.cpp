#include "lambert/image/tonemap/ocio.h"

#include "lambert/base/error.h"
#include "lambert/image/colour.h"
#include "lambert/image/tonemap/ocio_module.h"

#include <dlfcn.h>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace lambert::tone {
namespace {

using Apply = decltype(&lambert_ocio_apply);

bool configured() {
  const char* const config = std::getenv("OCIO");
  return config && *config;
}

std::filesystem::path module_path() {
  std::error_code none;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
  for (const auto& place : {folder / "lambert_ocio.so", folder / "../lib/lambert/lambert_ocio.so",
                            folder / "../lib/x86_64-linux-gnu/lambert/lambert_ocio.so"})
    if (std::filesystem::exists(place, none)) return place;
  return {};
}

/// Stays loaded: libraries with threads of their own do not like to be unloaded.
Apply loaded() {
  const auto path = module_path();
  if (path.empty()) throw Error("tone operator ocio: this program was built without OpenColorIO (libopencolorio-dev)");
  void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = module ? dlsym(module, "lambert_ocio_apply") : nullptr;
  if (!function) throw Error("tone operator ocio: " + std::string(dlerror()));
  return reinterpret_cast<Apply>(function);
}

}  // namespace

bool Ocio::available() { return configured() && !module_path().empty(); }

void Ocio::map(RgbPlanes& planes, const LuminanceMap&) const {
  if (!configured()) throw Error("tone operator ocio: $OCIO names no configuration");
  const Apply apply = loaded();
  const std::size_t count = planes.r.values.size();
  std::vector<float> rgb(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    rgb[3 * i] = planes.r.values[i], rgb[3 * i + 1] = planes.g.values[i], rgb[3 * i + 2] = planes.b.values[i];
  }
  std::array<char, 1024> error{};
  const LambertOcioTransform transform{display.c_str(), view.c_str(), input.c_str()};
  if (apply(&transform, rgb.data(), planes.r.width, planes.r.height, error.data(), error.size()) != 0)
    throw Error("tone operator ocio: " + std::string(error.data()));
  for_rows(planes.r.height, [&](int y) {
    const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(planes.r.width);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(planes.r.width); ++i) {
      planes.r.values[i] = srgb_decode(rgb[3 * i]);
      planes.g.values[i] = srgb_decode(rgb[3 * i + 1]);
      planes.b.values[i] = srgb_decode(rgb[3 * i + 2]);
    }
  });
}

}  // namespace lambert::tone
