#include "lambert/polygon/sweep/ordered_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace lambert::polygon {
namespace {

TEST(OrderedList, BehavesLikeASortedVector) {
  std::mt19937_64 random(1);
  OrderedList list;
  std::vector<std::uint32_t> sorted;
  const auto expect_same = [&] {
    std::vector<std::uint32_t> forwards, backwards;
    for (auto n = list.next(OrderedList::end); n != OrderedList::end; n = list.next(n)) forwards.push_back(list[n]);
    for (auto n = list.previous(OrderedList::end); n != OrderedList::end; n = list.previous(n))
      backwards.push_back(list[n]);
    std::reverse(backwards.begin(), backwards.end());
    ASSERT_EQ(forwards, sorted);
    ASSERT_EQ(backwards, sorted);
  };
  for (int i = 0; i < 20000; ++i) {
    const auto value = static_cast<std::uint32_t>(random() % 1000);
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), value);
    const auto node = list.partition_point([value](std::uint32_t v) { return v < value; });
    ASSERT_EQ(node == OrderedList::end, place == sorted.end());
    if (place != sorted.end()) {
      ASSERT_EQ(list[node], *place);
    }
    // Grows to some hundreds, then shrinks to nothing.
    if (random() % 100 < (i < 10000 ? 60 : 30)) {
      list.insert_before(node, value);
      sorted.insert(place, value);
    } else if (place != sorted.end()) {
      list.erase(node);
      sorted.erase(place);
    }
    if (i % 97 == 0) expect_same();
  }
  expect_same();
}

}  // namespace
}  // namespace lambert::polygon
