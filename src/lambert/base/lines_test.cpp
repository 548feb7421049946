#include "lambert/base/lines.h"

#include <gtest/gtest.h>

#include <string>

namespace lambert {
namespace {

std::string numbered(std::string_view text) {
  std::string all;
  for_lines(text, [&](std::string_view line, std::size_t number) {
    all += std::to_string(number) + "[" + std::string(line) + "]";
  });
  return all;
}

TEST(Lines, AreCountedFromOneWithoutTheirEnds) {
  EXPECT_EQ(numbered(""), "");
  EXPECT_EQ(numbered("a"), "1[a]");
  EXPECT_EQ(numbered("a\n"), "1[a]");
  EXPECT_EQ(numbered("a\n\nbc\r\n"), "1[a]2[]3[bc\r]");
  EXPECT_EQ(numbered("\n"), "1[]");
  EXPECT_EQ(numbered("a\nb"), "1[a]2[b]");
}

}  // namespace
}  // namespace lambert
