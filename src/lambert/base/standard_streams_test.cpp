#include "lambert/base/standard_streams.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(StandardStreams, AreNamedByAMinus) {
  for (const char* name : {"-", "png:-", "EXR:-", "svg:-"}) EXPECT_TRUE(is_standard_stream(name)) << name;
  for (const char* name : {"", ":-", "./-", "a/-", "-.png", "a.b:-", "a/b:-", "png:", "png:x"})
    EXPECT_FALSE(is_standard_stream(name)) << name;
}

TEST(StandardStreams, FormatIsTheExtensionOrStandsInFront) {
  EXPECT_EQ(format_extension("a/b.PnG"), ".png");
  EXPECT_EQ(format_extension("PNG:-"), ".png");
  EXPECT_EQ(format_extension("-"), "");
  EXPECT_EQ(format_extension("./-"), "");
  EXPECT_EQ(format_extension("exr:a.tif"), ".tif");
}

TEST(StandardStreams, MessagesNameThem) {
  EXPECT_EQ(input_name("-"), "standard input");
  EXPECT_EQ(input_name("png:-"), "png:-");
  EXPECT_EQ(output_name("png:-"), "standard output");
  EXPECT_EQ(output_name("./-"), "./-");
}

}  // namespace
}  // namespace lambert
