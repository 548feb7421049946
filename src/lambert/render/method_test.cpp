#include "lambert/render/method.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace lambert {
namespace {

TEST(Methods, AreMadeByName) {
  const auto names = method_names();
  EXPECT_NE(std::find(names.begin(), names.end(), "path"), names.end());
  for (const std::string& name : names) {
    const auto method = make_method(name);
    EXPECT_EQ(method->info().name, name);
    EXPECT_FALSE(method->info().summary.empty());
    EXPECT_FALSE(method->info().light_paths.empty());
    const auto table = method->settings();
    for (const Setting& s : table.settings()) EXPECT_FALSE(s.help.empty()) << name << " " << s.key;
  }
  EXPECT_NE(error_of([] { make_method("pth"); }).find("unknown method 'pth'"), std::string::npos);
  EXPECT_NE(error_of([] { make_method("pth"); }).find("path"), std::string::npos);
}

}  // namespace
}  // namespace lambert
