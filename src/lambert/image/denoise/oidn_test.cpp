#include "lambert/image/denoise/oidn.h"

#include "lambert/base/error.h"
#include "lambert/image/denoise/denoise.h"

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <algorithm>

namespace lambert {
namespace {

DenoiseSettings fake() { return {.method = DenoiseMethod::oidn, .oidn_library = LAMBERT_FAKE_OIDN}; }

std::string calls() {
  void* library = dlopen(LAMBERT_FAKE_OIDN, RTLD_NOW);
  const auto recorded = reinterpret_cast<const char* (*)()>(dlsym(library, "fake_oidn_calls"));
  std::string text = recorded ? recorded() : "";
  dlclose(library);
  return text;
}

Image filled(int width, int height, std::vector<std::string> channels, float value) {
  Image image(width, height, std::move(channels));
  std::fill(image.pixels().begin(), image.pixels().end(), value);
  return image;
}

TEST(Oidn, IsCalledAsItsDocumentationSays) {
  void* keep = dlopen(LAMBERT_FAKE_OIDN, RTLD_NOW);  // so that its memory of the calls outlives ours
  ASSERT_NE(keep, nullptr) << dlerror();
  const Image image =
      filled(5, 4, {"R", "G", "B", "A", "albedo.R", "albedo.G", "albedo.B", "normal.X", "normal.Y", "normal.Z"}, 0.5f);
  const Image out = denoise_image(image, fake());
  EXPECT_EQ(out.at(4, 3, 0), 0.25f);
  EXPECT_EQ(out.at(4, 3, 3), 0.5f) << "alpha stays";
  EXPECT_NE(out.metadata.at("denoiser").find("oidn"), std::string::npos);
  EXPECT_EQ(calls(),
            "device 1, commit, filter RT, color 3, albedo 3, normal 3, output 3, hdr on, commit, execute, release "
            "filter, release device");
  denoise_image(filled(5, 4, {"R", "G", "B", "normal.X", "normal.Y", "normal.Z"}, 0.5f), fake());
  EXPECT_EQ(calls().find("normal"), std::string::npos) << "normals alone are not allowed";
  dlclose(keep);
}

TEST(Oidn, AutomaticTakesItWhereItIs) {
  DenoiseSettings settings = fake();
  settings.method = DenoiseMethod::automatic;
  EXPECT_EQ(denoise_image(filled(3, 3, rgb_channels(), 1), settings).at(1, 1, 1), 0.5f);
  settings.oidn_library = "/nowhere/libOpenImageDenoise.so.2";
  EXPECT_EQ(denoise_image(filled(3, 3, rgb_channels(), 1), settings).metadata.at("denoiser"), "nfor");
}

TEST(Oidn, ItsErrorsAreOurs) {
  try {
    denoise_image(filled(13, 3, rgb_channels(), 1), fake());
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("thirteen is unlucky"), std::string::npos) << e.what();
  }
  DenoiseSettings missing{.method = DenoiseMethod::oidn, .oidn_library = "/nowhere/at/all.so"};
  EXPECT_THROW(denoise_image(filled(3, 3, rgb_channels(), 1), missing), Error);
}

}  // namespace
}  // namespace lambert
