#include "lambert/image/denoise/oidn.h"

#include "lambert/base/error.h"
#include "lambert/image/denoise/layer_names.h"
#include "lambert/image/denoise/noisy_image.h"
#include "lambert/image/denoise/repair.h"

#include <dlfcn.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace lambert::denoise {

/// The part of the C interface that is used, as its documentation gives it.
struct Oidn::Functions {
  // The objects are opaque; enumerations have the size of int.
  using Device = void*;
  using Filter = void*;
  static constexpr int device_cpu = 1, format_float3 = 3;

  void* library = nullptr;
  std::string library_name;
  Device (*new_device)(int type) = nullptr;
  void (*commit_device)(Device) = nullptr;
  int (*get_device_error)(Device, const char** message) = nullptr;
  void (*release_device)(Device) = nullptr;
  Filter (*new_filter)(Device, const char* type) = nullptr;
  void (*set_image)(Filter, const char* name, void* pixels, int format, std::size_t width, std::size_t height,
                    std::size_t byte_offset, std::size_t pixel_stride, std::size_t row_stride) = nullptr;
  void (*set_bool)(Filter, const char* name, bool value) = nullptr;
  void (*commit_filter)(Filter) = nullptr;
  void (*execute_filter)(Filter) = nullptr;
  void (*release_filter)(Filter) = nullptr;

  template <class F>
  bool load(F& function, std::initializer_list<const char*> names) {
    for (const char* symbol : names)
      if (void* found = dlsym(library, symbol)) {
        function = reinterpret_cast<F>(found);
        return true;
      }
    return false;
  }
  bool load_all() {
    return load(new_device, {"oidnNewDevice"}) && load(commit_device, {"oidnCommitDevice"}) &&
           load(get_device_error, {"oidnGetDeviceError"}) && load(release_device, {"oidnReleaseDevice"}) &&
           load(new_filter, {"oidnNewFilter"}) && load(set_image, {"oidnSetSharedFilterImage"}) &&
           load(set_bool, {"oidnSetFilterBool", "oidnSetFilter1b"}) &&  // version 2, version 1
           load(commit_filter, {"oidnCommitFilter"}) && load(execute_filter, {"oidnExecuteFilter"}) &&
           load(release_filter, {"oidnReleaseFilter"});
  }
  ~Functions() {
    if (library) dlclose(library);
  }
};

namespace {

constexpr std::array<const char*, 3> known_names{"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1",
                                                 "libOpenImageDenoise.so.0"};

/// Three channels, interleaved, finite.
std::vector<float> interleaved(const Image& image, const std::vector<std::size_t>& channels) {
  const auto area = static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
  std::vector<float> pixels(3 * area);
  for (std::size_t c = 0; c < 3; ++c) {
    Plane plane(image.width(), image.height());
    for (std::size_t i = 0; i < area; ++i)
      plane.values()[i] = image.pixels()[i * image.channel_count() + channels[channels.size() == 1 ? 0 : c]];
    repair(plane);
    for (std::size_t i = 0; i < area; ++i) pixels[3 * i + c] = plane.values()[i];
  }
  return pixels;
}

}  // namespace

Oidn::Oidn(std::unique_ptr<Functions> functions) : functions_(std::move(functions)) {}
Oidn::~Oidn() = default;

std::unique_ptr<Oidn> Oidn::find(const std::string& path) {
  const auto open = [](const std::string& name) -> std::unique_ptr<Oidn> {
    auto functions = std::make_unique<Functions>();
    functions->library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    functions->library_name = name;
    if (!functions->library || !functions->load_all()) return nullptr;
    return std::unique_ptr<Oidn>(new Oidn(std::move(functions)));
  };
  if (!path.empty()) return open(path);
  for (const char* name : known_names)
    if (auto found = open(name)) return found;
  return nullptr;
}

std::string Oidn::not_found(const std::string& path) {
  if (!path.empty()) return path + ": is not the library of Open Image Denoise";
  return "Open Image Denoise is not installed: the loader finds no libOpenImageDenoise.so.2 or .1 (LD_LIBRARY_PATH "
         "says "
         "where to look; --method nfor needs no library)";
}

std::string Oidn::name() const { return "oidn " + functions_->library_name; }

Colour Oidn::denoise(const Image& image) const {
  const Functions& f = *functions_;
  std::vector<float> colour = interleaved(image, colour_channels(image)), albedo, normal;
  if (const auto c = albedo_channels(image); !c.empty()) albedo = interleaved(image, c);
  if (const auto c = normal_channels(image); !c.empty() && !albedo.empty()) normal = interleaved(image, c);
  std::vector<float> output(colour.size());

  const auto device = f.new_device(Functions::device_cpu);
  if (!device) throw Error(f.library_name + ": cannot make a CPU device");
  f.commit_device(device);
  const auto filter = f.new_filter(device, "RT");
  if (filter) {
    const auto set = [&](const char* name, std::vector<float>& pixels) {
      if (pixels.empty()) return;
      f.set_image(filter, name, pixels.data(), Functions::format_float3, static_cast<std::size_t>(image.width()),
                  static_cast<std::size_t>(image.height()), 0, 0, 0);
    };
    set("color", colour), set("albedo", albedo), set("normal", normal), set("output", output);
    f.set_bool(filter, "hdr", true);
    f.commit_filter(filter);
    f.execute_filter(filter);
    f.release_filter(filter);
  }
  const char* message = nullptr;
  const int error = f.get_device_error(device, &message);
  const std::string words = message ? message : "it gives no reason";
  f.release_device(device);
  if (error != 0 || !filter) throw Error(f.library_name + " failed: " + words);

  Colour result = black(image.width(), image.height());
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < result[c].values().size(); ++i) result[c].values()[i] = output[3 * i + c];
  return result;
}

}  // namespace lambert::denoise
