#include "lambert/bsdf/iridescence.h"

#include "lambert/bsdf/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

TEST(Iridescence, NoFilmIsTheBase) {
  for (const float cos : {1.0f, 0.6f, 0.2f}) {
    const Rgb base(0.04f, 0.5f, 0.9f), film = fresnel_iridescent(cos, 1.3f, 0, base),
                                       plain = fresnel_schlick(cos, base, Rgb(1));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(film[i], plain[i], 0.01f) << cos;
  }
}

TEST(Iridescence, ReflectsBetweenNothingAndAll) {
  for (const float ior : {1.1f, 1.3f, 1.8f, 2.5f})
    for (float thickness = 0; thickness < 1200; thickness += 37)
      for (const float cos : {1.0f, 0.5f, 0.1f, 0.0f}) {
        const Rgb r = fresnel_iridescent(cos, ior, thickness, Rgb(0.04f, 0.3f, 1));
        EXPECT_TRUE(min_component(r) >= 0 && max_component(r) <= 1) << ior << " " << thickness << " " << cos;
      }
  EXPECT_NEAR(fresnel_iridescent(0, 1.3f, 400, Rgb(0.04f)).g, 1, 1e-3f) << "grazing";
}

// A film of index sqrt(η) and a quarter of a wavelength thick extinguishes reflection off glass: 550 nm / (4 · 1.225)
// is 112 nm; twice as thick, half a wave, it leaves green as it was.
TEST(Iridescence, AQuarterWaveCoatingTakesTheReflectionAway) {
  const float film = std::sqrt(1.5f), quarter = 550 / (4 * film);
  EXPECT_LT(fresnel_iridescent(1, film, quarter, Rgb(0.04f)).g, 0.005f);
  EXPECT_NEAR(fresnel_iridescent(1, film, 2 * quarter, Rgb(0.04f)).g, 0.04f, 0.012f);
}

// Films many waves thick have no colour: orders of interference overlap, and intensities add,
// R = R12 + T² R23 / (1 - R12 R23).
TEST(Iridescence, ThickFilmsAreGrey) {
  const float r12 = f0_of_eta(1.4f), r23 = f0_of_eta(1.5f / 1.4f), t = 1 - r12;
  const Rgb r = fresnel_iridescent(1, 1.4f, 20000, Rgb(0.04f));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(r[i], r12 + t * t * r23 / (1 - r12 * r23), 1e-3f);
}

TEST(Iridescence, ColoursChangeWithAngle) {
  const Rgb normal = fresnel_iridescent(1, 1.3f, 400, Rgb(0.9f)),
            tilted = fresnel_iridescent(0.5f, 1.3f, 400, Rgb(0.9f));
  EXPECT_GT(std::abs(normal.r - tilted.r) + std::abs(normal.g - tilted.g) + std::abs(normal.b - tilted.b), 0.1f);
}

}  // namespace
}  // namespace lambert
