#include "lambert/base/error.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(SourceLocation, LeavesOutWhatIsUnknown) {
  EXPECT_EQ((SourceLocation{"a.pbrt", 3, 7}.to_string()), "a.pbrt:3:7");
  EXPECT_EQ((SourceLocation{"a.pbrt", 3, 0}.to_string()), "a.pbrt:3");
  EXPECT_EQ((SourceLocation{"a.glb", 0, 0}.to_string()), "a.glb");
}

TEST(Error, SaysWhereAndWhat) {
  EXPECT_STREQ(Error(SourceLocation{"a.obj", 2, 1}, "no such material").what(), "a.obj:2:1: no such material");
  EXPECT_STREQ(Error(SourceLocation{}, "no such material").what(), "no such material");
}

TEST(UnknownWord, SuggestsTheNearest) {
  const std::vector<std::string> allowed = {"box", "triangle", "gaussian"};
  EXPECT_EQ(unknown_word("gausian", allowed), "'gausian'; did you mean 'gaussian'? (known: box, triangle, gaussian)");
  EXPECT_EQ(unknown_word("mitchell", allowed), "'mitchell' (known: box, triangle, gaussian)");
  EXPECT_EQ(unknown_word("word", {}), "'word'");
}

TEST(UnknownWord, HostileWordsStayShort) { EXPECT_LT(unknown_word(std::string(1 << 20, 'x'), {"box"}).size(), 100u); }

}  // namespace
}  // namespace lambert
