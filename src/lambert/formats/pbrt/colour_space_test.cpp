#include "lambert/formats/pbrt/colour_space.h"

#include <gtest/gtest.h>

namespace lambert::pbrt {
namespace {

void expect_near(Rgb a, Rgb b, float tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(ColourSpace, WhiteStaysWhite) {
  for (const std::string& name : ColourSpace::names()) {
    expect_near(ColourSpace(name).to_rec709(Rgb(1, 1, 1)), Rgb(1, 1, 1), 1e-5f);
  }
}

TEST(ColourSpace, SrgbIsUntouched) {
  const Rgb c(0.1f, 0.7f, -0.2f);
  EXPECT_EQ(ColourSpace("srgb").to_rec709(c), c);
  EXPECT_EQ(ColourSpace().to_rec709(c), c);
}

// ITU-R BT.2087, the linear conversion from BT.2020 to BT.709.
TEST(ColourSpace, Rec2020ByTheStandardMatrix) {
  const ColourSpace rec2020("rec2020");
  expect_near(rec2020.to_rec709(Rgb(1, 0, 0)), Rgb(1.6605f, -0.1246f, -0.0182f), 2e-4f);
  expect_near(rec2020.to_rec709(Rgb(0, 1, 0)), Rgb(-0.5876f, 1.1329f, -0.1006f), 2e-4f);
  expect_near(rec2020.to_rec709(Rgb(0, 0, 1)), Rgb(-0.0728f, -0.0083f, 1.1187f), 2e-4f);
}

}  // namespace
}  // namespace lambert::pbrt
