#include "lambert/image/image.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace lambert {
namespace {

TEST(Image, StartsBlackAndKeepsWhatIsSet) {
  Image image(3, 2, rgba_channels());
  EXPECT_EQ(image.pixels().size(), 24u);
  EXPECT_TRUE(std::all_of(image.pixels().begin(), image.pixels().end(), [](float v) { return v == 0; }));
  image.set_rgb(2, 1, {1, 2, 3});
  image.at(2, 1, 3) = 0.5f;
  EXPECT_EQ(image.rgb(2, 1), Rgb(1, 2, 3));
  EXPECT_EQ(image.row(1)[2 * 4 + 3], 0.5f) << "rows from the top, channels interleaved";
  EXPECT_EQ(image.pixels()[5 * 4 + 1], 2);
  EXPECT_EQ(image.rgb(1, 1), Rgb(0.0f));
}

TEST(Image, ChannelsHaveNames) {
  const Image image(1, 1, {"R", "G", "B", "Z", "normal.X"});
  EXPECT_EQ(image.channel("Z"), 3u);
  EXPECT_EQ(image.channel("normal.X"), 4u);
  EXPECT_EQ(image.channel("A"), std::nullopt);
  EXPECT_EQ(image.channel("normal"), std::nullopt);
}

TEST(Image, GreyIsSpreadAndOtherChannelsAreNoColour) {
  for (const std::vector<std::string>& channels :
       {std::vector<std::string>{"Y"}, {"Y", "A"}, {"Y", "A", "Z"}, {"Z", "id"}}) {
    Image image(1, 1, channels);
    image.at(0, 0, 0) = 0.25f, image.at(0, 0, channels.size() - 1) += 0.5f;
    EXPECT_FALSE(image.has_colour());
    EXPECT_EQ(image.rgb(0, 0), Rgb(image.at(0, 0, 0))) << channels.size();
  }
}

TEST(Image, RefusesSizesThatNoImageHas) {
  EXPECT_EQ(error_of([] { Image(0, 4, rgb_channels()); }), "an image cannot be 0x4 with 3 channels");
  EXPECT_EQ(error_of([] { Image(4, -1, rgb_channels()); }), "an image cannot be 4x-1 with 3 channels");
  EXPECT_EQ(error_of([] { Image(4, 4, {}); }), "an image cannot be 4x4 with 0 channels");
  EXPECT_EQ(error_of([] { Image(2147483647, 2147483647, rgb_channels()); }),
            "an image of 2147483647x2147483647 with 3 channels is too large");
  EXPECT_EQ(error_of([] {
              Image(1 << 16, 1 << 15, {"R", "G"});
            }),
            "an image of 65536x32768 with 2 channels is too large");
}

TEST(Image, WindowsFollowThePixelsUntilPlaced) {
  Image image(4, 3, rgb_channels());
  EXPECT_EQ(image.data_window(), (Window{0, 0, 4, 3}));
  EXPECT_EQ(image.display_window(), image.data_window());
  image.place({-1, 2}, {0, 0, 10, 8});
  EXPECT_EQ(image.data_window(), (Window{-1, 2, 4, 3}));
  EXPECT_EQ(image.display_window(), (Window{0, 0, 10, 8}));
  EXPECT_THROW(image.place({0, 0}, {0, 0, 0, 8}), Error);
}

TEST(Image, IsCutToAnyWindow) {
  Image image(3, 2, {"Y", "A"});
  for (int i = 0; i < 12; ++i) image.pixels()[static_cast<std::size_t>(i)] = static_cast<float>(i + 1);
  image.place({-1, 4}, {0, 0, 2, 6});
  image.metadata["a"] = "b";
  constexpr int far = 2000000000;
  for (const Window& w : {Window{-1, 4, 3, 2}, Window{0, 0, 2, 6}, Window{-5, 3, 9, 1}, Window{1, 5, 40, 40},
                          Window{far, -far, 3, 3}, Window{-far, far, 1, 2}}) {
    const Image part = cut(image, w);
    EXPECT_EQ(part.data_window(), w);
    EXPECT_EQ(part.display_window(), image.display_window());
    EXPECT_EQ(part.metadata, image.metadata);
    for (int y = 0; y < w.height; ++y)
      for (int x = 0; x < w.width; ++x) {
        const std::int64_t i = std::int64_t{w.x} + x + 1, j = std::int64_t{w.y} + y - 4;
        const bool inside = i >= 0 && i < 3 && j >= 0 && j < 2;
        EXPECT_EQ(part.at(x, y, 1), inside ? image.at(static_cast<int>(i), static_cast<int>(j), 1) : 0);
      }
  }
  EXPECT_EQ(displayed(image).width(), 2);
  EXPECT_NE(error_of([&] { cut(image, {0, 0, 0, 4}); }), "");
}

}  // namespace
}  // namespace lambert
