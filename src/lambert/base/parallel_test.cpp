#include "lambert/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace lambert {
namespace {

class Parallel : public testing::TestWithParam<std::size_t> {
 protected:
  Parallel() { set_thread_count(GetParam()); }
  ~Parallel() override { set_thread_count(0); }
};

TEST_P(Parallel, EveryIndexOnce) {
  std::vector<std::atomic<int>> seen(10007);
  parallel_for(seen.size(), [&](std::size_t i) { ++seen[i]; });
  for (const auto& count : seen) ASSERT_EQ(count, 1);
  parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST_P(Parallel, ExceptionReachesTheCaller) {
  try {
    parallel_for(1000, [](std::size_t i) {
      if (i == 137) throw std::runtime_error("at 137");
    });
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(std::string(e.what()), "at 137");
  }
}

TEST_P(Parallel, LoopsNest) {
  std::atomic<int> sum = 0;
  parallel_for(20, [&](std::size_t) { parallel_for(20, [&](std::size_t) { ++sum; }); });
  EXPECT_EQ(sum, 400);
}

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 4));

TEST(ThreadCount, IsLimitedAndReset) {
  const std::size_t all = thread_count();
  EXPECT_GE(all, 1u);
  set_thread_count(1);
  EXPECT_EQ(thread_count(), 1u);
  set_thread_count(0);
  EXPECT_EQ(thread_count(), all);
}

}  // namespace
}  // namespace lambert
