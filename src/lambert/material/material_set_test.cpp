#include "lambert/base/error.h"
#include "lambert/base/hash.h"
#include "lambert/material/material.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

Material mix(MaterialId a, MaterialId b, float amount = 0.5f) {
  Material m;
  m.name = "mixture";
  m.model = MixMaterial{a, b, {amount}};
  return m;
}

TEST(MaterialSet, ResolvesAMixInItsProportion) {
  MaterialSet set;
  const MaterialId a = set.add({}), b = set.add({}), m = set.add(mix(a, b, 0.3f));
  int chose_b = 0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    if (set.resolve(m, {}, {}, hash_values(i)) == b) ++chose_b;
  }
  EXPECT_NEAR(chose_b, 0.3 * n, 4 * std::sqrt(0.21 * n));
  EXPECT_EQ(set.resolve(a, {}, {}, 7), a);
}

TEST(MaterialSet, DecidesAnewInAMixOfMixes) {
  MaterialSet set;
  const MaterialId a = set.add({}), b = set.add({}), c = set.add({});
  const MaterialId inner = set.add(mix(b, c)), outer = set.add(mix(a, inner));
  std::array<int, 3> count{};
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) ++count[set.resolve(outer, {}, {}, hash_values(i))];
  EXPECT_NEAR(count[0], n / 2, 4 * std::sqrt(n / 4));
  EXPECT_NEAR(count[1], n / 4, 4 * std::sqrt(n * 3 / 16));
}

std::string validation_error(const MaterialSet& set) {
  try {
    set.validate();
    return "";
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(MaterialSet, AcceptsSharedParts) {
  MaterialSet set;
  const MaterialId a = set.add({}), b = set.add({}), m = set.add(mix(a, b));
  set.add(mix(m, m));
  set.add(mix(m, a));
  EXPECT_EQ(validation_error(set), "");
}

TEST(MaterialSet, RefusesCyclesAndUnknownMaterials) {
  MaterialSet set;
  const MaterialId a = set.add({}), m = set.add(mix(a, a)), outer = set.add(mix(m, a));
  set[m].model = MixMaterial{a, outer};
  EXPECT_NE(validation_error(set).find("'mixture' mixes material 'mixture', which is made of it"), std::string::npos);
  set[m].model = MixMaterial{a, 99};
  EXPECT_NE(validation_error(set).find("does not exist"), std::string::npos);
  set[m].model = MixMaterial{m, m};
  EXPECT_NE(validation_error(set), "");
}

}  // namespace
}  // namespace lambert
