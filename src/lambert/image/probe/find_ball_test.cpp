#include "lambert/image/probe/find_ball.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <gtest/gtest.h>

namespace lambert::probe {
namespace {

Rgb world(Vec3 d) {
  const float boxes = std::sin(9 * d.x) * std::sin(8 * d.y + 1) * std::sin(7 * d.z + 2) > 0.1f ? 1.5f : 0.4f;
  return pattern(d) * boxes;
}

/// A ball before boards and a lawn.
Image picture_of_ball(Vec2 centre, float radius, int width, int height) {
  Image image(width, height, rgb_channels());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Rgb sum;
      for (int k = 0; k < 9; ++k) {
        const Vec2 p = Vec2(x, y) + (Vec2(k % 3, k / 3) + 0.5f) / 3.0f, q = (p - centre) / radius;
        const float r2 = dot(q, q);
        if (r2 < 1) {
          const float z = std::sqrt(1 - r2);
          sum += world(Vec3(2 * z * q.x, -2 * z * q.y, 2 * z * z - 1)) * 0.6f;
        } else {
          const float board = std::fmod(p.x + 1000, 37.0f) < 3 ? 0.2f : 1.0f;
          sum += p.y > 0.7f * static_cast<float>(height) ? Rgb(0.1f, 0.3f, 0.1f) : Rgb(0.5f, 0.4f, 0.3f) * board;
        }
      }
      const float noise = 1 + 0.04f * (hash_to_float(hash_values(x, y)) - 0.5f);
      image.set_rgb(x, y, sum * (noise / 9));
    }
  return image;
}

// rows: LF-09 LF-12
TEST(FindBall, FindsTheCircle) {
  const struct {
    Vec2 centre;
    float radius;
    int width, height;
  } cases[] = {
      {{163.3f, 118.8f}, 61.4f, 320, 240}, {{300, 260.5f}, 140.2f, 640, 480}, {{80.2f, 90.7f}, 33.3f, 256, 200}};
  for (const auto& c : cases) {
    const Image image = picture_of_ball(c.centre, c.radius, c.width, c.height);
    const auto found = find_ball(image);
    ASSERT_TRUE(found) << c.radius;
    EXPECT_NEAR(found->centre.x, static_cast<double>(c.centre.x), 1.2);
    EXPECT_NEAR(found->centre.y, static_cast<double>(c.centre.y), 1.2);
    EXPECT_NEAR(found->radius, static_cast<double>(c.radius), 1.0);
    const Image crop = crop_ball(image, *found);
    EXPECT_EQ(crop.width(), crop.height());
    EXPECT_NEAR(crop.width(), 2 * c.radius, 2);
  }
}

TEST(FindBall, FindsNoneWhereThereIsNone) {
  EXPECT_FALSE(find_ball(Image(1, 1, {"Y"})));
  EXPECT_FALSE(find_ball(Image(64, 64, rgb_channels())));
  Image ramp(120, 80, rgb_channels());
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 120; ++x) ramp.set_rgb(x, y, Rgb(x < 60 ? 1.0f : 0.2f));
  EXPECT_FALSE(find_ball(ramp));
}

TEST(BallReflectivity, IsTheRatioOfTwoPatches) {
  Image image(8, 4, rgb_channels());
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) image.set_rgb(x, y, x < 4 ? Rgb(1, 2, 4) : Rgb(0.6f, 1, 1));
  const Rgb r = ball_reflectivity(image, {5, 0, 3, 4}, {0, 1, 3, 2});
  EXPECT_NEAR(r.r, 0.6f, 1e-6f);
  EXPECT_NEAR(r.b, 0.25f, 1e-6f);
  EXPECT_THROW(ball_reflectivity(image, {6, 0, 3, 4}, {0, 0, 1, 1}), Error);
}

}  // namespace
}  // namespace lambert::probe
