#include "lambert/image/filter/edge_mode.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <array>

namespace lambert {
namespace {

// rows: AA-24
TEST(EdgeMode, Conventions) {
  constexpr std::array<int, 6> index = {-1, 0, 3, 4, 5, 8};
  const std::pair<EdgeMode, std::array<int, 6>> modes[] = {{EdgeMode::clamp, {0, 0, 3, 3, 3, 3}},
                                                           {EdgeMode::repeat, {3, 0, 3, 0, 1, 0}},
                                                           {EdgeMode::mirror, {0, 0, 3, 3, 2, 0}},
                                                           {EdgeMode::black, {-1, 0, 3, -1, -1, -1}}};
  for (const auto& [mode, expected] : modes)
    for (std::size_t i = 0; i < index.size(); ++i) EXPECT_EQ(edge_index(index[i], 4, mode), expected[i]) << index[i];
}

TEST(EdgeMode, AgreesWithWalkingThere) {
  for (int n = 1; n <= 5; ++n) {
    int repeat = 0, mirror = 0, step = 1;
    for (int i = 0; i <= 40; ++i) {
      EXPECT_EQ(edge_index(i, n, EdgeMode::repeat), repeat);
      EXPECT_EQ(edge_index(-1 - i, n, EdgeMode::repeat), n - 1 - repeat) << "the walk backwards from the other end";
      EXPECT_EQ(edge_index(i, n, EdgeMode::mirror), mirror);
      EXPECT_EQ(edge_index(-1 - i, n, EdgeMode::mirror), mirror) << "mirrored at the edge";
      repeat = (repeat + 1) % n;
      if (mirror + step < 0 || mirror + step >= n)
        step = -step;
      else
        mirror += step;
    }
  }
  constexpr int far = 1 << 30;
  for (const EdgeMode mode : {EdgeMode::repeat, EdgeMode::mirror, EdgeMode::clamp})
    for (const int i : {-far, far}) {
      EXPECT_GE(edge_index(i, 7, mode), 0);
      EXPECT_LT(edge_index(i, 7, mode), 7);
    }
}

TEST(EdgeMode, Names) {
  for (const std::string& name : edge_mode_names())
    EXPECT_EQ(edge_mode_names()[static_cast<std::size_t>(edge_mode(name))], name);
  EXPECT_NE(error_of([] { edge_mode("clmap"); }).find("clamp"), std::string::npos);
}

}  // namespace
}  // namespace lambert
