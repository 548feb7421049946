#include "lambert/base/settings.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lambert {
namespace {

struct Example {
  int depth = 3;
  float clamp = 0.5f;
  bool direct = true;
  std::string mode = "fast";
  SettingTable table() {
    return SettingTable({{"depth", "", &depth},
                         {"clamp", "", &clamp},
                         {"direct", "", &direct},
                         {"mode", "", &mode, {"fast", "exact"}}});
  }
};

TEST(SettingTable, RefusesNumbersBelowTheLeast) {
  int count = 5;
  float share = 0.5f;
  SettingTable table({{"count", "", &count, {}, 1}, {"share", "", &share, {}, 0}});
  EXPECT_EQ(error_of([&] { table.set("count", "0"); }),
            "setting 'count': expected a whole number of at least 1, got '0'");
  EXPECT_EQ(error_of([&] { table.set("share", "-0.1"); }),
            "setting 'share': expected a number of at least 0, got '-0.1'");
  EXPECT_EQ(count, 5);
  table.set("count", "1"), table.set("share", "0");
  EXPECT_EQ(count, 1);
}

TEST(SettingTable, RefusesNumbersOutOfTheRange) {
  float share = 0.5f;
  SettingTable table({{"share", "", &share, {}, {}, 0.0f, 1.5f}});
  EXPECT_EQ(error_of([&] { table.set("share", "0"); }), "setting 'share': expected a number above 0, got '0'");
  EXPECT_EQ(error_of([&] { table.set("share", "1.6"); }),
            "setting 'share': expected a number of at most 1.5, got '1.6'");
  table.set("share", "1.5");
  EXPECT_EQ(share, 1.5f);
}

TEST(SettingTable, WritesThroughToTheStruct) {
  Example e;
  SettingTable table = e.table();
  table.set("depth", "-7");
  table.set("clamp", "2.5e3");
  table.set("direct", "false");
  table.set("mode", "exact");
  EXPECT_EQ(e.depth, -7);
  EXPECT_EQ(e.clamp, 2500);
  EXPECT_FALSE(e.direct);
  EXPECT_EQ(e.mode, "exact");
  std::vector<std::string> words;
  for (const Setting& s : table.settings()) words.push_back(to_string(s));
  EXPECT_EQ(words, (std::vector<std::string>{"-7", "2500", "false", "exact"}));
}

TEST(SettingTable, ErrorsNameKeyValueAndWhatWasExpected) {
  Example e;
  SettingTable table = e.table();
  const auto error = [&](const char* key, const char* value) { return error_of([&] { table.set(key, value); }); };
  EXPECT_EQ(error("depth", "2.5"), "setting 'depth': expected a whole number, got '2.5'");
  EXPECT_EQ(error("depth", ""), "setting 'depth': expected a whole number, got ''");
  EXPECT_EQ(error("depth", "99999999999"), "setting 'depth': expected a whole number, got '99999999999'");
  EXPECT_EQ(error("clamp", "1x"), "setting 'clamp': expected a number, got '1x'");
  EXPECT_EQ(error("clamp", "inf"), "setting 'clamp': expected a finite number, got 'inf'");
  EXPECT_EQ(error("clamp", "nan"), "setting 'clamp': expected a finite number, got 'nan'");
  EXPECT_EQ(error("direct", "yes"), "setting 'direct': expected true or false, got 'yes'");
  EXPECT_NE(error("mode", "exakt").find("setting 'mode': unknown value 'exakt'"), std::string::npos);
  EXPECT_NE(error("mode", "exakt").find("exact"), std::string::npos) << "the nearest word";
  EXPECT_NE(error("dept", "1").find("unknown setting 'dept'"), std::string::npos);
  EXPECT_NE(error("dept", "1").find("depth"), std::string::npos);
  EXPECT_EQ(e.depth, 3) << "nothing was changed";
  EXPECT_EQ(e.mode, "fast");
}

}  // namespace
}  // namespace lambert
