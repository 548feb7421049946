#include "vectors.h"

#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/filter/footprint.h"
#include "lambert/image/filter/lookup.h"
#include "lambert/image/filter/pyramid.h"
#include "lambert/image/filter/resolve.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// rows: AA-12
const CheckOf supersampling("V-AA-05", [](const Vector& v) {
  Image samples(3, 3, {"Y"});
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      samples.at(x, y, 0) =
          v.input.at("samples").at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x)).get<float>();
  v.expect_near(resolved(samples).at(0, 0, 0), v.expected.at("box"));
  v.expect_near(resolved(samples, 3, ResolveKernel::bartlett).at(0, 0, 0), v.expected.at("bartlett"));
  Image ones(3, 3, {"Y"});
  for (float& sample : ones.pixels()) sample = 1;
  v.expect_near(resolved(ones).at(0, 0, 0), v.expected.at("sums")[0]);
  v.expect_near(resolved(ones, 3, ResolveKernel::bartlett).at(0, 0, 0), v.expected.at("sums")[1]);
});

// rows: AA-20
const CheckOf mip_map_sizes("V-AA-09", [](const Vector& v) {
  const int size = v.input.at("size");
  ASSERT_EQ(v.input.at("channels"), 3);
  const Pyramid pyramid(Image(size, size, rgb_channels()));
  EXPECT_EQ(pyramid.level_count(), v.expected.at("levels").get<int>());
  EXPECT_EQ(pyramid.value_count(), v.expected.at("total_bytes").get<std::size_t>()) << "a byte each";
  EXPECT_EQ(packed(pyramid).pixels().size(), v.expected.at("square_bytes").get<std::size_t>());
  v.expect_near(static_cast<double>(pyramid.value_count()) / static_cast<double>(pyramid.level(0).pixels().size()),
                v.expected.at("ratio"));
});

// rows: AA-21
const CheckOf level_from_derivatives("V-AA-11", [](const Vector& v) {
  const auto of = [&](const char* name) { return v.input.at(name).get<float>(); };
  const double d = largest_edge(Footprint{{of("du_dx"), of("dv_dx")}, {of("du_dy"), of("dv_dy")}});
  v.expect_near(d, v.expected.at("D"));
  const LevelChoice choice = level_for(d, 10);
  EXPECT_EQ(choice.level, v.expected.at("levels")[0].get<int>());
  EXPECT_EQ(choice.level + 1, v.expected.at("levels")[1].get<int>());
  v.expect_near(choice.fraction, v.expected.at("fraction"));
  v.expect_near(choice.level + choice.fraction, v.expected.at("k"));
});

// rows: AA-22
const CheckOf bilinear_and_trilinear("V-AA-12", [](const Vector& v) {
  const auto texel = [&](int x, int y) {
    return Vec4(v.input.at("texels").at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x)).get<float>());
  };
  // Texel centres lie at (i + 1/2) / 2.
  const Vec2 uv((v.input.at("fu").get<float>() + 0.5f) / 2, (v.input.at("fv").get<float>() + 0.5f) / 2);
  const Vec4 fine = bilinear_lookup(Vec2i(2), uv, {EdgeMode::clamp, EdgeMode::clamp}, texel);
  v.expect_near(fine.x, v.expected.at("bilinear"));
  const Vec4 coarse(v.input.at("coarse_value").get<float>());
  v.expect_near(blended_levels(v.input.at("fraction").get<float>(), [&](int i) { return i == 0 ? fine : coarse; }).x,
                v.expected.at("trilinear"));
});

// rows: AA-24
const CheckOf edge_modes("V-AA-13", [](const Vector& v) {
  const int size = v.input.at("size");
  for (const char* mode : {"clamp", "repeat", "mirror"}) {
    std::vector<int> indices;
    for (const int i : v.input.at("index")) indices.push_back(edge_index(i, size, edge_mode(mode)));
    EXPECT_EQ(indices, v.expected.at(mode).get<std::vector<int>>()) << mode;
  }
});

}  // namespace
}  // namespace lambert
