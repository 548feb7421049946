#include "lambert/material/spectrum.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(Glasses, KnowIndexAndAbbeNumber) {
  const GlassData bk7 = named_glass("BK7").value();
  EXPECT_FLOAT_EQ(bk7.eta, 1.5168f);
  EXPECT_FLOAT_EQ(bk7.abbe_number, 64.17f);
  EXPECT_FALSE(named_glass("BK8"));
}

TEST(Glasses, ListEveryNameThatIsKnownWithPhysicalValues) {
  for (const std::string& name : glass_names()) {
    const GlassData g = named_glass(name).value();
    EXPECT_GT(g.eta, 1.3f) << name;
    EXPECT_GT(g.abbe_number, 20) << name;
    EXPECT_LT(g.abbe_number, 90) << name;
  }
}

TEST(Glasses, FlintsDisperseMoreThanCrowns) {
  EXPECT_LT(named_glass("SF11")->abbe_number, named_glass("BAF10")->abbe_number);
  EXPECT_LT(named_glass("BAF10")->abbe_number, named_glass("BK7")->abbe_number);
  EXPECT_EQ(named_glass("F11")->eta, named_glass("SF11")->eta);
}

}  // namespace
}  // namespace lambert
