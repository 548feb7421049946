#pragma once
/// What the tests of the readers share.

#include "lambert/polygon/formats/features.h"

#include "damage.h"

namespace lambert::polygon::test {

/// Of a file that holds one.
inline Feature only_feature(const Features& features) {
  EXPECT_EQ(features.features.size(), 1u);
  return features.features.at(0);
}

}  // namespace lambert::polygon::test
