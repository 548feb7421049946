#include "lambert/image/composite/key.h"

#include "lambert/base/error.h"

#include <gtest/gtest.h>

namespace lambert::composite {
namespace {

constexpr Rgb green(0.05f, 0.6f, 0.1f);

/// `subject` before `backing`, covered by `alpha`.
Pixel mixed(Rgb subject, Rgb backing, float alpha) {
  const Rgb c = lerp(backing, subject, alpha);
  return {c.r, c.g, c.b, 1};
}

// rows: AA-26 AA-27
TEST(Key, AGreySubjectIsFoundWithItsCoverage) {
  for (float alpha = 0; alpha <= 1; alpha += 0.125f) {
    const Rgb grey(0.4f);
    for (const Pixel p : {apply(ColourKey{.colour = green, .inner = 0}, mixed(grey, green, alpha)),
                          apply(ScreenKey{.colour = green}, mixed(grey, green, alpha))}) {
      EXPECT_NEAR(p.a, alpha, 1e-5f);
      EXPECT_NEAR(p.r, alpha * 0.4f, 1e-5f) << "premultiplied, the backing taken away";
      EXPECT_NEAR(p.g, alpha * 0.4f, 1e-5f);
    }
  }
}

TEST(Key, TheSoftRange) {
  const ColourKey key{.colour = green, .inner = 0.25f, .outer = 0.75f};
  EXPECT_EQ(matte(key, green), 0);
  EXPECT_EQ(matte(key, lerp(green, Rgb(0.3f), 0.25f)), 0);
  EXPECT_NEAR(matte(key, lerp(green, Rgb(0.3f), 0.5f)), 0.5f, 1e-5f);
  EXPECT_EQ(matte(key, lerp(green, Rgb(0.3f), 0.8f)), 1);
}

TEST(Key, SpillIsHeldBackButNoOtherColour) {
  EXPECT_EQ(suppress_spill({0.3f, 0.5f, 0.2f}, green, 1), Rgb(0.3f, 0.3f, 0.2f));
  EXPECT_EQ(suppress_spill({0.3f, 0.5f, 0.2f}, green, 0), Rgb(0.3f, 0.5f, 0.2f));
  EXPECT_EQ(suppress_spill({0.7f, 0.5f, 0.2f}, green, 1), Rgb(0.7f, 0.5f, 0.2f));
  EXPECT_NEAR(suppress_spill({0.1f, 0.2f, 0.8f}, {0, 0, 1}, 1).b, 0.2f, 1e-6f);
}

TEST(Key, AScreenKeepsSubjectsOfOtherColoursAndShadows) {
  const ScreenKey key{.colour = green};
  EXPECT_EQ(matte(key, {0.8f, 0.3f, 0.1f}), 1);
  EXPECT_NEAR(matte(key, green * 0.5f), 0.5f, 1e-5f) << "a shadow of one half";
  const Pixel shadow = apply(key, {0.5f * green.r, 0.5f * green.g, 0.5f * green.b, 1});
  EXPECT_NEAR(shadow.g, 0, 1e-5f) << "black";
}

TEST(Key, DifferenceFromTheCleanPlate) {
  const DifferenceKey key{0.1f, 0.2f};
  const Pixel clean{0.2f, 0.3f, 0.4f, 1};
  EXPECT_EQ(apply(key, clean, clean), clear_pixel);
  const Pixel subject{0.9f, 0.3f, 0.4f, 1};
  EXPECT_EQ(apply(key, subject, clean), subject);
  EXPECT_NEAR(apply(key, {0.35f, 0.3f, 0.4f, 1}, clean).a, 0.5f, 1e-5f);
}

TEST(Key, NonsenseIsRefused) {
  EXPECT_THROW(check(ColourKey{.colour = Rgb(0.5f)}), Error);
  EXPECT_THROW(check(ColourKey{.colour = Rgb()}), Error);
  EXPECT_THROW(check(ColourKey{.colour = green, .inner = 0.5f, .outer = 0.5f}), Error);
  EXPECT_THROW(check(ScreenKey{.colour = Rgb(0.4f, 0.4f, 0.1f)}), Error);
  EXPECT_THROW(check(DifferenceKey{0.2f, 0.1f}), Error);
  EXPECT_NO_THROW(check(ScreenKey{.colour = green}));
}

}  // namespace
}  // namespace lambert::composite
