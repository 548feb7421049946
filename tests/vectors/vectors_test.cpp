#include "vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <set>

namespace lambert {

void PrintTo(const Vector& v, std::ostream* out) { *out << v.id; }

namespace {

class EveryVector : public testing::TestWithParam<Vector> {};
INSTANTIATE_TEST_SUITE_P(, EveryVector, testing::ValuesIn(vectors()), [](const auto& test) {
  std::string name = test.param.id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(EveryVector, Holds) {
  const auto check = checks().find(GetParam().id);
  ASSERT_NE(check, checks().end()) << "no check of " << GetParam().id;
  check->second(GetParam());
}

TEST(Vectors, EachHasACheckAndEachCheckItsVector) {
  std::set<std::string> listed, checked;
  for (const Vector& v : vectors()) EXPECT_TRUE(listed.insert(v.id).second) << v.id << " comes twice";
  for (const auto& [id, check] : checks()) checked.insert(id);
  EXPECT_EQ(listed, checked);
  EXPECT_FALSE(listed.empty());
}

}  // namespace
}  // namespace lambert
