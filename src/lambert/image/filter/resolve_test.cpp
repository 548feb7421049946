#include "lambert/image/filter/resolve.h"

#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// rows: AA-12
TEST(Resolve, TheNotesKernels) {
  const float bartlett[3][3] = {{1, 2, 1}, {2, 4, 2}, {1, 2, 1}};
  const Image samples = noise(12, 9, {"R", "G", "B", "A"});
  const Image box = resolved(samples), tent = resolved(samples, 3, ResolveKernel::bartlett);
  ASSERT_EQ(Vec2i(box.width(), box.height()), Vec2i(4, 3));
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        float flat = 0, weighted = 0;
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i) {
            flat += samples.at(3 * x + i, 3 * y + j, c) / 9;
            weighted += samples.at(3 * x + i, 3 * y + j, c) * bartlett[j][i] / 16;
          }
        EXPECT_NEAR(box.at(x, y, c), flat, 1e-6f);
        EXPECT_NEAR(tent.at(x, y, c), weighted, 1e-6f);
      }
}

TEST(Resolve, OtherFactors) {
  Image samples(4, 1, {"Y"});
  for (int x = 0; x < 4; ++x) samples.at(x, 0, 0) = static_cast<float>(x * x);
  EXPECT_NE(error_of([&] { resolved(samples, 4); }).find("4x1"), std::string::npos);
  EXPECT_NE(error_of([&] { resolved(samples, 0); }).find("factor"), std::string::npos);
  EXPECT_EQ(resolved(samples, 1).at(3, 0, 0), 9);
  Image square(4, 4, {"Y"});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) square.at(x, y, 0) = static_cast<float>(x * x);
  EXPECT_NEAR(resolved(square, 4).at(0, 0, 0), 3.5f, 1e-6f);
  EXPECT_NEAR(resolved(square, 4, ResolveKernel::bartlett).at(0, 0, 0), (2 * 1 + 2 * 4 + 9) / 6.0f, 1e-6f);
}

}  // namespace
}  // namespace lambert
