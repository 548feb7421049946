#include "lambert/material/material.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

Material with_alpha(AlphaMode mode, float alpha) {
  Material m;
  m.alpha_mode = mode;
  m.alpha.value = alpha;
  return m;
}

TEST(AlphaPasses, NeverThroughOpaqueMaterials) {
  EXPECT_FALSE(alpha_passes(with_alpha(AlphaMode::opaque, 0), {}, {}, 0, 0.5f));
}

TEST(AlphaPasses, BelowTheCutoffOfAMask) {
  Material m = with_alpha(AlphaMode::mask, 0.6f);
  EXPECT_FALSE(alpha_passes(m, {}, {}, 1, 0.99f));
  EXPECT_TRUE(alpha_passes(m, {}, {}, 0.5f, 0)) << "the vertex's alpha counts";
  m.alpha_cutoff = 0.6f;
  EXPECT_FALSE(alpha_passes(m, {}, {}, 1, 0)) << "solid at the cutoff itself";
}

TEST(AlphaPasses, WithTheComplementOfAlphaWhenBlended) {
  const Material m = with_alpha(AlphaMode::blend, 0.3f);
  EXPECT_FALSE(alpha_passes(m, {}, {}, 1, 0.29f));
  EXPECT_TRUE(alpha_passes(m, {}, {}, 1, 0.31f));
  EXPECT_TRUE(alpha_passes(with_alpha(AlphaMode::blend, 0), {}, {}, 1, 0));
}

TEST(AlphaPasses, ReadsItsChannel) {
  TextureSet textures;
  Material m = with_alpha(AlphaMode::mask, 1);
  m.alpha.texture = textures.add(ConstantTexture{{1, 1, 1, 0.2f}});
  m.alpha.channel = 3;
  EXPECT_TRUE(alpha_passes(m, textures, {}, 1, 0));
}

}  // namespace
}  // namespace lambert
