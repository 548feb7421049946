#include "lambert/image/hdr/recover.h"

#include "lambert/base/error.h"
#include "lambert/image/hdr/exposure.h"
#include "lambert/image/hdr/hdr_test_tools.h"
#include "lambert/image/hdr/merge.h"
#include "lambert/image/io.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace lambert::hdr {
namespace {

const std::vector<double> five{1.0 / 64, 1.0 / 16, 0.25, 1, 4};

std::string refusal(const ExposureStack& stack) {
  try {
    recover_response(stack);
  } catch (const Error& e) {
    return e.what();
  }
  return "none";
}

// rows: LF-11
// The curves that cameras have, recovered from photographs without noise, of both depths.
TEST(Recover, FindsKnownCurves) {
  const Image map = test_map(256, 192);
  for (const std::string curve : {"srgb", "linear", "gamma 1.8", "film", "log"})
    for (const int bits : {8, 16}) {
      const ExposureStack stack = photographs(map, curve, five, bits);
      const Recovery r = recover_response(stack);
      const Response known = response_named(curve, 3, r.response.levels());
      EXPECT_LT(response_error(r.response, known), 0.005) << curve << " " << bits;
      EXPECT_LT(radiance_error(stack, merge(stack, r.response).image, map), 0.005) << curve << " " << bits;
      EXPECT_FLOAT_EQ(r.response.exposure[0].back(), 1);
    }
}

// rows: LF-11
TEST(Recover, EveryMethodComesNearTheCurve) {
  const Image map = test_map(256, 192);
  const ExposureStack stack = photographs(map, "film", five);
  const Response known = response_named("film", 3, 256);
  const auto error = [&](RecoveryMethod m) {
    return response_error(recover_response(stack, {.method = m}).response, known);
  };
  EXPECT_LT(error(RecoveryMethod::automatic), 0.003);
  EXPECT_LT(error(RecoveryMethod::debevec), 0.02);
  EXPECT_LT(error(RecoveryMethod::robertson), 0.03);
  EXPECT_LT(error(RecoveryMethod::mitsunaga), 0.02);
}

// rows: LF-11
TEST(Recover, SaysWhichKnownCurveItIsAndOnlyIfItIs) {
  const Image map = test_map(256, 192);
  EXPECT_EQ(recover_response(photographs(map, "srgb", five)).model, "srgb");
  EXPECT_EQ(recover_response(photographs(map, "gamma 2.2", five)).model, "gamma 2.2");
  EXPECT_EQ(recover_response(photographs(map, "film", five)).model, "recovered");
  EXPECT_EQ(recover_response(photographs(map, "gamma 2", five)).model, "recovered");
}

// rows: LF-11
// Poisson noise of 5000 electrons at saturation and reading: the error stays of the order of what the noise leaves.
TEST(Recover, BearsNoise) {
  const Image map = test_map(256, 192);
  for (const std::string curve : {"srgb", "film"}) {
    const ExposureStack stack = photographs(map, curve, five, 8, {.full_well = 5000, .read_noise = 5});
    const Recovery r = recover_response(stack);
    EXPECT_LT(response_error(r.response, response_named(curve, 3, 256)), 0.015) << curve;
    // sqrt(X / 5000) / X' at the middle code of sRGB: X 0.216, X' 1/258.
    if (curve == "srgb") {
      EXPECT_NEAR(r.noise.at(1, 128), 1.7, 0.8);
    }
  }
}

// rows: LF-11
TEST(Recover, RefusesWhatCannotBeSolved) {
  const Image map = test_map(64, 64);
  EXPECT_NE(refusal(photographs(map, "srgb", {1})).find("two photographs"), std::string::npos);
  EXPECT_NE(refusal(photographs(map, "srgb", {1, 1})).find("equal"), std::string::npos);
  EXPECT_NE(refusal(photographs(map, "srgb", {1e4, 2e4})).find("everything is saturated"), std::string::npos);
  EXPECT_NE(refusal(photographs(map, "srgb", {1e-9, 2e-9})).find("everything is black"), std::string::npos);
  Image flat(64, 64, rgb_channels());
  for (float& v : flat.pixels()) v = 0.2f;
  EXPECT_NE(refusal(photographs(flat, "srgb", {0.5, 1, 2})).find("different codes"), std::string::npos);
  EXPECT_NE(refusal(photographs(test_map(3, 3), "srgb", {0.02, 0.05})).find("only"), std::string::npos);
}

/// A stack of the shared data, and what its photographs were made of.
struct Shared {
  ExposureStack stack;
  Image truth;
  std::filesystem::path folder;
};
Shared shared(const std::string& name) {
  Shared s{.folder = std::filesystem::path(LAMBERT_SHARED_DATA) / "exposures" / "synthetic-cc0" / name};
  std::vector<std::string> files;
  std::vector<double> exposures;
  for (const ListedExposure& e : read_exposure_list(s.folder / "list.txt"))
    files.push_back(e.file.string()), exposures.push_back(relative_exposure(e.setting));
  s.stack = read_stack(files, exposures);
  check_exposures(s.stack);
  s.truth = read_image(s.folder / "gt.exr");
  return s;
}

// rows: LF-11
TEST(Recover, SolvesTheSharedStacks) {
  if (!std::filesystem::exists(std::filesystem::path(LAMBERT_SHARED_DATA) / "exposures"))
    GTEST_SKIP() << "no shared data at " LAMBERT_SHARED_DATA;
  for (const std::string name : {"venice_srgb", "workshop_film"}) {
    const Shared s = shared(name);
    const Recovery r = recover_response(s.stack);
    // The table of the film is too coarse below exposure 1/256: from code 64 on it says what stands behind a code.
    const Response known = read_response(s.folder / "response.csv", 3, 256);
    std::vector<double> a, b;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t z = 64; z < 250; ++z)
        a.push_back(static_cast<double>(r.response.channel(c)[z])),
            b.push_back(static_cast<double>(known.channel(c)[z]));
    EXPECT_LT(median_log_error(a, b), 0.002) << name;
    EXPECT_LT(radiance_error(s.stack, merge(s.stack, r.response, {.code_noise = r.noise}).image, s.truth), 0.0025)
        << name;
  }
}

}  // namespace
}  // namespace lambert::hdr
