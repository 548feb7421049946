#include "lambert/material/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lambert {
namespace {

/// Reflectance of a conductor at normal incidence.
float normal_reflectance(float eta, float k) {
  return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
}
Rgb normal_reflectance(const char* name) {
  const MetalData m = named_metal(name).value();
  return {normal_reflectance(m.eta.r, m.k.r), normal_reflectance(m.eta.g, m.k.g), normal_reflectance(m.eta.b, m.k.b)};
}

TEST(Metals, HaveTheirColours) {
  const Rgb gold = normal_reflectance("Au"), copper = normal_reflectance("Cu"), silver = normal_reflectance("Ag");
  EXPECT_GT(gold.r, gold.g + 0.1f);
  EXPECT_GT(gold.g, gold.b + 0.3f);
  EXPECT_GT(copper.r, copper.g + 0.2f);
  EXPECT_GT(min_component(silver), 0.9f);
  EXPECT_NEAR(normal_reflectance("Al").g, 0.92f, 0.02f);
}

TEST(Metals, ListEveryNameThatIsKnown) {
  for (const std::string& name : metal_names()) EXPECT_TRUE(named_metal(name)) << name;
  for (const char* name : {"Ag", "Al", "Au", "Cu", "CuZn", "MgO", "TiO2"}) EXPECT_TRUE(named_metal(name)) << name;
  EXPECT_FALSE(named_metal("Unobtainium"));
}

SpectrumSamples read_spd(const std::filesystem::path& path) {
  SpectrumSamples samples;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    float nm = 0, value = 0;
    if (numbers >> nm >> value) samples.emplace_back(nm, value);
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

// The table is what the conversion makes of the measured spectra.
TEST(Metals, AgreeWithMeasuredSpectra) {
  const std::filesystem::path folder = std::filesystem::path(LAMBERT_SHARED_DATA) / "brdf/pbrt-v2/spds/metals";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const std::string name : {"Ag", "Al", "Au", "Be", "Cu", "Hg", "Ir", "MgO", "Mo", "Nb", "Rh", "Ta", "TiN", "W"}) {
    const MetalData m = named_metal(name).value();
    const Rgb eta = spectrum_to_reflectance_rgb(read_spd(folder / (name + ".eta.spd")));
    const Rgb k = spectrum_to_reflectance_rgb(read_spd(folder / (name + ".k.spd")));
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(m.eta[i], eta[i], 2e-3f) << name;
      EXPECT_NEAR(m.k[i], k[i], 2e-3f) << name;
    }
  }
}

}  // namespace
}  // namespace lambert
