#include "lambert/base/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace lambert {
namespace {

TEST(Progress, PartsLieInTheWhole) {
  std::vector<double> told;
  const FractionSink whole = [&](double f) { told.push_back(f); };
  const FractionSink second = part_of(whole, 0.5, 1), last = part_of(second, 0.5, 1);
  second(0), last(0), last(0.5), last(1);
  EXPECT_EQ(told, (std::vector{0.5, 0.75, 0.875, 1.0}));
  EXPECT_FALSE(part_of({}, 0, 1));
}

TEST(Progress, LoopsTellWhatIsDone) {
  for (const std::size_t count : {1, 7, 1000}) {
    std::vector<double> told;
    std::atomic<std::size_t> bodies = 0;
    parallel_for(
        count, [&](double f) { told.push_back(f); }, [&](std::size_t) { ++bodies; });
    EXPECT_EQ(bodies, count);
    ASSERT_FALSE(told.empty());
    EXPECT_LE(told.size(), 101u);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_EQ(told.back(), 1);
  }
  std::atomic<std::size_t> bodies = 0;
  parallel_for(5, FractionSink(), [&](std::size_t) { ++bodies; });
  EXPECT_EQ(bodies, 5u);
}

}  // namespace
}  // namespace lambert
