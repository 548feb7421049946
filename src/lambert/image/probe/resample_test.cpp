#include "lambert/image/probe/resample.h"

#include "lambert/base/error.h"
#include "lambert/image/io.h"
#include "lambert/image/probe/lookup.h"
#include "lambert/image/probe/missing.h"
#include "lambert/image/probe/probe_test_tools.h"

#include <ImfEnvmap.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace lambert::probe {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

const std::vector<AnyProjection>& whole_sphere() {
  static const std::vector<AnyProjection> all{
      LatLong{},     Cube{},       Cube{.opengl = true}, MirrorBall{},
      angular_map(), Octahedral{}, EqualArea{},          LatLong{.centre_is_plus_z = true}};
  return all;
}

float largest_error(const Probe& a, const Probe& b, float but_rim = 1) {
  float worst = 0;
  for (std::size_t c = 0; c < a.charts.size(); ++c)
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) {
        if (length(2.0f * uv_of(a, Vec2(x, y) + 0.5f) - 1.0f) > but_rim) continue;
        const Rgb e = a.charts[c].rgb(x, y) - b.charts[c].rgb(x, y);
        worst = std::max({worst, std::abs(e.r), std::abs(e.g), std::abs(e.b)});
      }
  return worst;
}

// rows: IS-19 IS-20 LF-09 LF-13
TEST(Resample, AnyLayoutToAnyOtherShowsTheSameWorld) {
  std::vector<Probe> sources;
  for (const AnyProjection& from : whole_sphere()) sources.push_back(map_of(from, 128, pattern));
  for (const AnyProjection& to : whole_sphere()) {
    const Probe truth = map_of(to, 32, pattern, 5);
    for (const Probe& source : sources) {
      const AnyProjection& from = source.projection;
      const Vec2i size = chart_size(to, 32);
      const Probe got = resample(source, to, TexelRule::cells, size);
      const bool rim = std::holds_alternative<MirrorBall>(from) || std::holds_alternative<MirrorBall>(to);
      // Texels at the rim of a ball are wide; what a coarse one has smeared cannot come back.
      double error = 0, count = 0;
      for (std::size_t c = 0; c < got.charts.size(); ++c)
        for (int y = 0; y < got.height(); ++y)
          for (int x = 0; x < got.width(); ++x) {
            const Rgb e = got.charts[c].rgb(x, y) - truth.charts[c].rgb(x, y);
            error += static_cast<double>(e.r * e.r + e.g * e.g + e.b * e.b), ++count;
          }
      EXPECT_LT(std::sqrt(error / count), rim ? 0.09 : 0.02) << from.index() << " to " << to.index();
    }
  }
}

// rows: LF-09
TEST(Resample, AConstantStaysWhatItIs) {
  for (const AnyProjection& from : whole_sphere())
    for (const AnyProjection& to : whole_sphere())
      for (const int rows : {7, 40}) {
        const Probe source = map_of(from, 16, [](Vec3) { return Rgb(0.3f, 2, 900); });
        const Probe got = resample(source, to, TexelRule::cells, chart_size(to, rows),
                                   {.rotation = rotation(degrees(30), degrees(-50), degrees(10))});
        const Probe truth = map_of(to, rows, [](Vec3) { return Rgb(0.3f, 2, 900); });
        EXPECT_LT(largest_error(got, truth, 1 - 2.0f / static_cast<float>(rows)), 1e-2f);
      }
}

// rows: LF-09
TEST(Resample, KeepsTheLight) {
  const Vec3 sun = normalize(Vec3(0.3f, 0.6f, -0.5f));
  const auto sky = [&](Vec3 d) { return pattern(d) + (dot(d, sun) > std::cos(0.06f) ? Rgb(900, 700, 400) : Rgb()); };
  const Probe source = map_of(LatLong{}, 128, sky);
  const Rgb before = total_light(source);
  for (const AnyProjection& to : whole_sphere())
    for (const int rows : {24, 64, 300}) {
      if (rows > 64 && to.index() > 2) continue;
      const Probe got = resample(source, to, TexelRule::cells, chart_size(to, rows));
      const Rgb after = total_light(got);
      EXPECT_NEAR(after.g / before.g, 1, 2e-3f) << to.index() << " " << rows;
    }
  // One texel of light.
  Probe spark = map_of(LatLong{}, 64, [](Vec3) { return Rgb(); });
  spark.charts[0].set_rgb(37, 21, Rgb(1000));
  const Probe cube = resample(spark, Cube{}, TexelRule::cells, {20, 20});
  EXPECT_NEAR(total_light(cube).g / total_light(spark).g, 1, 1.5e-2f);
}

// rows: IS-20 LF-09
TEST(Resample, PolesAndSeamsAreWhole) {
  const Probe source = map_of(LatLong{}, 64, pattern, 4);
  const Lookup lookup(source);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const Vec3 d = random_direction(i), near = normalize(d + 1e-3f * random_direction(i + 5000));
    EXPECT_NEAR(lookup.rgb(d).r, lookup.rgb(near).r, 0.012f);
    EXPECT_NEAR(lookup.rgb(d).r, pattern(d).r, 0.06f);
  }
  EXPECT_NEAR(lookup.rgb({0, 1, 0}).g, pattern({0, 1, 0}).g, 0.02f);
  EXPECT_NEAR(lookup.rgb({0, 0, 1}).g, pattern({0, 0, 1}).g, 0.02f);
  const Probe cube = map_of(Cube{}, 32, pattern, 4);
  const Lookup faces(cube);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Vec3 d = random_direction(i);
    d.x = std::copysign(d.y, d.x);  // edges, among others
    d = normalize(d);
    EXPECT_NEAR(faces.rgb(d).b, pattern(d).b, 0.12f);
  }
}

// rows: LF-09
TEST(Resample, AllOfAMovedMapIsThere) {
  const Mat3 turn = rotation(degrees(70), degrees(20), degrees(-40));
  const Probe source = map_of(LatLong{}, 128, pattern, 2);
  const Probe got = resample(source, LatLong{}, TexelRule::cells, {128, 64}, {.rotation = turn});
  const Probe truth = map_of(
      LatLong{}, 64, [&](Vec3 d) { return pattern(glm::transpose(turn) * d); }, 4);
  EXPECT_LT(largest_error(got, truth, 10), 0.02f);
  // Yaw turns what is ahead to the left, pitch up.
  EXPECT_LT(length(rotation(degrees(90), degrees(0), degrees(0)) * Vec3(0, 0, -1) - Vec3(-1, 0, 0)), 1e-6f);
  EXPECT_LT(length(rotation(degrees(0), degrees(90), degrees(0)) * Vec3(0, 0, -1) - Vec3(0, 1, 0)), 1e-6f);
  EXPECT_THROW(rotation({1, 0, 0, 0, 1, 0, 0, 0, 2}), Error);
}

TEST(Resample, NothingToDoChangesNoBit) {
  const Probe source = map_of(MirrorBall{}, 33, pattern);
  const Probe got = resample(source, MirrorBall{}, TexelRule::cells, {33, 33});
  EXPECT_TRUE(
      std::equal(got.charts[0].pixels().begin(), got.charts[0].pixels().end(), source.charts[0].pixels().begin()));
}

TEST(Resample, WhatAFisheyeDoesNotSeeIsBlackAndOneTexelMapsWork) {
  const Probe half = map_of(Fisheye{}, 64, [](Vec3) { return Rgb(1); });
  const Probe got = resample(half, LatLong{}, TexelRule::cells, {64, 32});
  EXPECT_NEAR(got.charts[0].rgb(32, 16).r, 1, 1e-5f);
  EXPECT_EQ(got.charts[0].rgb(0, 16).r, 0);
  Image grey(1, 1, {"Y"});
  grey.at(0, 0, 0) = 3;
  for (const AnyProjection& p : whole_sphere()) {
    Probe one{p, TexelRule::cells, std::vector<Image>(static_cast<std::size_t>(chart_count(p)), grey)};
    EXPECT_NEAR(resample(one, Cube{}, TexelRule::cells, {2, 2}).charts[0].at(0, 0, 0), 3, 1e-4f);
    EXPECT_NEAR(resample(one, LatLong{}, TexelRule::cells, {2, 1}).charts[0].at(0, 0, 0), 3, 1e-4f);
  }
}

TEST(FillMissing, FillsFromNeighboursAndCounts) {
  Image image(5, 4, rgb_channels());
  for (float& v : image.pixels()) v = 2;
  image.at(1, 1, 0) = NAN, image.at(2, 1, 1) = infinite, image.at(4, 3, 2) = -infinite;
  EXPECT_EQ(fill_missing(image), 3u);
  for (const float v : image.pixels()) EXPECT_EQ(v, 2);
  EXPECT_EQ(fill_missing(image), 0u);
  Image none(2, 2, {"Y"});
  for (float& v : none.pixels()) v = NAN;
  EXPECT_EQ(fill_missing(none), 4u);
  EXPECT_EQ(none.at(1, 1, 0), 0);
}

// rows: IS-19 IS-20
// Directions of pixels as OpenEXR's own functions have them.
TEST(OpenExrLayouts, ArePlacedAsOpenExrPlacesThem) {
  const Layout lat_long = layout("openexr-lat-long"), cube = layout("openexr-cube");
  const Probe map{lat_long.projection, lat_long.texels, {Image(64, 32, {"Y"})}};
  const Probe faces{cube.projection, cube.texels, std::vector<Image>(6, Image(16, 16, {"Y"}))};
  const Imath::Box2i map_window({0, 0}, {63, 31}), cube_window({0, 0}, {15, 95});
  for (int y = 1; y < 31; y += 3)
    for (int x = 0; x < 64; x += 5) {
      const auto theirs = Imf::LatLongMap::direction(map_window, {static_cast<float>(x), static_cast<float>(y)});
      const Vec3 ours = *direction(map.projection, {0, uv_of(map, Vec2(x, y) + 0.5f)});
      EXPECT_LT(length(ours - Vec3(theirs.x, theirs.y, theirs.z)), 1e-5f) << x << " " << y;
    }
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < 16; y += 3)
      for (int x = 0; x < 16; x += 5) {
        const auto theirs = Imf::CubeMap::direction(static_cast<Imf::CubeMapFace>(face), cube_window,
                                                    {static_cast<float>(x), static_cast<float>(y)});
        const Vec3 t = normalize(Vec3(theirs.x, theirs.y, theirs.z));
        const auto place = Imf::CubeMap::pixelPosition(static_cast<Imf::CubeMapFace>(face), cube_window,
                                                       {static_cast<float>(x), static_cast<float>(y)});
        // Where the pixel lies in their strip is where arranged() puts ours.
        const int row = static_cast<int>(std::lround(place.y)) - 16 * face;
        const int column = static_cast<int>(std::lround(place.x));
        const Vec3 ours = *direction(faces.projection, {face, uv_of(faces, Vec2(column, row) + 0.5f)});
        EXPECT_LT(length(ours - t), 1e-5f) << face << " " << x << " " << y;
      }
}

// rows: IS-19 IS-20 LF-13
TEST(OpenExrLayouts, TheOrientationPairShowsOneWorld) {
  const std::filesystem::path folder = LAMBERT_SHARED_DATA "/hdr/openexr-envmaps/MultiResolution";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const Layout lat_long = layout("openexr-lat-long"), cube = layout("openexr-cube");
  const Probe map = cut(lat_long, {read_image(folder / "OrientationLatLong.exr")});
  const Probe faces = cut(cube, {read_image(folder / "OrientationCube.exr")});
  const auto rms = [](const Probe& a, const Probe& b) {
    double sum = 0, count = 0;
    for (std::size_t c = 0; c < a.charts.size(); ++c)
      for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
          const float e = a.charts[c].rgb(x, y).g - b.charts[c].rgb(x, y).g;
          sum += static_cast<double>(e * e), ++count;
        }
    return std::sqrt(sum / count);
  };
  const Probe to_map = resample(faces, map.projection, map.texels, {map.width(), map.height()});
  const Probe to_faces = resample(map, faces.projection, faces.texels, {faces.width(), faces.height()});
  const Probe back = resample(to_faces, map.projection, map.texels, {map.width(), map.height()});
  RecordProperty("cube_to_map", std::to_string(rms(to_map, map)));
  EXPECT_LT(rms(to_map, map), 0.05);
  EXPECT_LT(rms(to_faces, faces), 0.05);
  EXPECT_LT(rms(back, map), 0.05);
}

}  // namespace
}  // namespace lambert::probe
