#include "lambert/draw/montage.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <vector>

namespace lambert::draw {
namespace {

Image flat(Rgb colour, int width, int height) {
  Image image(width, height, rgb_channels());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.set_rgb(x, y, colour);
  return image;
}

TEST(Montage, ShowsEveryPanelAsItIs) {
  const std::vector<Panel> panels{
      {"red", flat({3, 0, 0}, 40, 20)}, {"green", flat({0, 2, 0}, 40, 20)}, {"blue", flat({0, 0, 1}, 20, 10)}};
  const Image sheet = montage(panels, {.columns = 2});
  std::size_t red = 0, green = 0, blue = 0;
  for (int y = 0; y < sheet.height(); ++y)
    for (int x = 0; x < sheet.width(); ++x) {
      const Rgb c = sheet.rgb(x, y);
      red += c == Rgb(3, 0, 0), green += c == Rgb(0, 2, 0), blue += c == Rgb(0, 0, 1);
    }
  EXPECT_EQ(red, 800u);
  EXPECT_EQ(green, 800u);
  EXPECT_EQ(blue, 200u);
  EXPECT_EQ(sheet.width(), 2 * 50 + 10);
}

TEST(Montage, WritesNamesBelow) {
  const std::vector<Panel> named{{"a", flat(Rgb(1), 40, 20)}}, unnamed{{"", flat(Rgb(1), 40, 20)}};
  const auto darkness = [](const Image& image) {
    double sum = 0;
    for (const float v : image.pixels()) sum += 1 - static_cast<double>(v);
    return sum;
  };
  EXPECT_EQ(darkness(montage(unnamed)), 0);
  EXPECT_GT(darkness(montage(named)), 10);
}

TEST(Montage, ShowsAlphaOverWhite) {
  Image clear(4, 4, rgba_channels());
  EXPECT_EQ(montage(std::vector<Panel>{{"", clear}}).rgb(11, 11), Rgb(1));
}

TEST(Montage, RefusesNothingAndTooMuch) {
  EXPECT_EQ(error_of([] { montage({}); }), "a montage needs a panel");
  const std::vector<Panel> wide(3, {"wide", Image(5000, 1, {"Y"})});
  EXPECT_NE(error_of([&] { montage(wide, {.columns = 3}); }).find("too large"), std::string::npos);
}

TEST(Magnified, RepeatsPixels) {
  Image image(2, 1, {"Y"});
  image.at(1, 0, 0) = 5;
  const Image large = magnified(image, 3);
  EXPECT_EQ(large.width(), 6);
  EXPECT_EQ(large.at(2, 2, 0), 0);
  EXPECT_EQ(large.at(3, 0, 0), 5);
}

}  // namespace
}  // namespace lambert::draw
