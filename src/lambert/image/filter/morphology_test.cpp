#include "lambert/image/filter/morphology.h"

#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

template <class Choose>
Image brute_force(const Image& image, Vec2i radius, Choose choose) {
  Image out = image;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c) {
        float v = image.at(x, y, c);
        for (int j = std::max(0, y - radius.y); j <= std::min(image.height() - 1, y + radius.y); ++j)
          for (int i = std::max(0, x - radius.x); i <= std::min(image.width() - 1, x + radius.x); ++i)
            v = choose(v, image.at(i, j, c));
        out.at(x, y, c) = v;
      }
  return out;
}
bool equal(const Image& a, const Image& b) { return std::ranges::equal(a.pixels(), b.pixels()); }

TEST(Morphology, IsTheLeastAndTheGreatestOfTheWindow) {
  const auto least = [](float a, float b) { return std::min(a, b); };
  const auto greatest = [](float a, float b) { return std::max(a, b); };
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 1}, {1, 9}, {8, 8}, {23, 17}, {40, 11}})
    for (const Vec2i radius : {Vec2i(0), Vec2i(1), Vec2i(2, 0), Vec2i(0, 3), Vec2i(5, 4), Vec2i(60000)}) {
      const Image image = noise(width, height, {"R", "A", "Z"});
      EXPECT_TRUE(equal(eroded(image, radius), brute_force(image, radius, least))) << width << " " << radius.x;
      EXPECT_TRUE(equal(dilated(image, radius), brute_force(image, radius, greatest))) << width << " " << radius.x;
    }
}

// Erosion is dilation of the negative; opening <= image <= closing; opening and closing change nothing the second time.
TEST(Morphology, Duality) {
  const Image image = noise(31, 19, {"Y"});
  Image negative = image;
  for (float& v : negative.pixels()) v = -v;
  const Vec2i radius(2, 1);
  const Image erosion = eroded(image, radius), dilation = dilated(negative, radius);
  const Image opening = opened(image, radius), closing = closed(image, radius);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    EXPECT_EQ(erosion.pixels()[i], -dilation.pixels()[i]);
    EXPECT_LE(opening.pixels()[i], image.pixels()[i]);
    EXPECT_GE(closing.pixels()[i], image.pixels()[i]);
  }
  EXPECT_TRUE(equal(opened(opening, radius), opening));
  EXPECT_TRUE(equal(closed(closing, radius), closing));
}

TEST(Morphology, NanIsPassedOver) {
  for (int at = 0; at < 9; ++at) {
    Image image(9, 1, {"Y"});
    for (int x = 0; x < 9; ++x) image.at(x, 0, 0) = static_cast<float>(x);
    image.at(at, 0, 0) = NAN;
    const Image least = eroded(image, {1, 0}), greatest = dilated(image, {1, 0});
    for (int x = 0; x < 9; ++x) {
      int low = std::max(0, x - 1), high = std::min(8, x + 1);
      low += low == at, high -= high == at;
      EXPECT_EQ(least.at(x, 0, 0), static_cast<float>(low)) << at << " " << x;
      EXPECT_EQ(greatest.at(x, 0, 0), static_cast<float>(high)) << at << " " << x;
    }
  }
}

TEST(Morphology, RefusesANegativeRadius) {
  EXPECT_NE(error_of([] { eroded(Image(2, 2, {"Y"}), {-1, 0}); }).find("radius"), std::string::npos);
}

}  // namespace
}  // namespace lambert
