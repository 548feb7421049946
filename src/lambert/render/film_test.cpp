#include "lambert/render/film.h"

#include "lambert/base/error.h"
#include "lambert/base/hash.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

// Filters with negative lobes: weights of either sign.
TEST(Film, WeightsThatCancelLeaveNoHole) {
  Film film({1, 1}, {{0, 0}, {1, 1}}, {});
  film.add({0, 0}, {.radiance = Rgb(0.5f), .weight = 1.2f});
  film.add({0, 0}, {.radiance = Rgb(0.5f), .weight = -1.2f});
  EXPECT_FLOAT_EQ(film.mean({0, 0}).g, 0.5f);
}

TEST(Film, AverageTakesOneHalfWhereTheOtherHasNothing) {
  const Film nothing({1, 1}, {{0, 0}, {1, 1}}, {});
  Film film = nothing, cancelled = nothing;
  film.add({0, 0}, {.radiance = Rgb(0.5f), .weight = 1.2f});
  cancelled.add({0, 0}, {.radiance = Rgb(0.25f), .weight = 1.2f});
  cancelled.add({0, 0}, {.radiance = Rgb(0.25f), .weight = -1.2f});
  EXPECT_FLOAT_EQ(Film::average(film, nothing).mean({0, 0}).g, 0.5f);
  EXPECT_FLOAT_EQ(Film::average(nothing, film).mean({0, 0}).g, 0.5f);
  EXPECT_FLOAT_EQ(Film::average(film, cancelled).mean({0, 0}).g, 0.375f);
}

const Vec2i at(1, 0);

Film film(std::vector<Aov> aovs = {}) { return {{4, 3}, {{1, 0}, {4, 2}}, std::move(aovs)}; }

float number(int i) { return hash_to_float(hash_values(i)); }

TEST(Film, MeanIsWeighted) {
  Film f = film();
  f.add(at, {.radiance = {1, 2, 3}, .weight = 1});
  f.add(at, {.radiance = {4, 0, 1}, .weight = 0.5f});
  f.add(at, {.radiance = {1, 1, 1}, .weight = -0.25f});
  EXPECT_FLOAT_EQ(f.mean(at).r, (1 + 2 - 0.25f) / 1.25f);
  EXPECT_FLOAT_EQ(f.mean(at).g, (2 - 0.25f) / 1.25f);
  EXPECT_FLOAT_EQ(f.mean(at).b, (3 + 0.5f - 0.25f) / 1.25f);
  EXPECT_EQ(f.sample_count(at), 3u);
  EXPECT_EQ(f.total_samples(), 3u);
  EXPECT_EQ(f.mean({2, 0}), Rgb());
}

// Of x uniform in [0,1): 1/12 per sample.
TEST(Film, VarianceOfAMeanOfUniformNumbers) {
  Film f = film();
  EXPECT_TRUE(std::isinf(f.variance_of_mean(at)));
  f.add(at, {.radiance = Rgb(0.5f)});
  EXPECT_TRUE(std::isinf(f.variance_of_mean(at))) << "one sample says nothing";
  constexpr int count = 20000;
  Film many = film();
  for (int i = 0; i < count; ++i) many.add(at, {.radiance = Rgb(number(i))});
  EXPECT_NEAR(many.variance_of_mean(at) * count, 1 / 12.0, 2e-3);
}

// The textbook's Σ (x - mean)² / (n (n - 1)), where cancellation is worst: a large mean and a small spread.
TEST(Film, VarianceIsThatOfTwoPasses) {
  Film f = film();
  constexpr int count = 500;
  const auto value = [](int i) { return 1000 + 0.5f * number(i); };
  double mean = 0, squares = 0;
  for (int i = 0; i < count; ++i) f.add(at, {.radiance = Rgb(value(i))}), mean += static_cast<double>(value(i)) / count;
  for (int i = 0; i < count; ++i) squares += std::pow(static_cast<double>(value(i)) - mean, 2);
  const double expected = squares / (count * (count - 1.0));
  EXPECT_NEAR(f.variance_of_mean(at), expected, 0.02 * expected);
  Film constant = film();
  for (int i = 0; i < 10; ++i) constant.add(at, {.radiance = Rgb(0.1f)});
  EXPECT_NEAR(constant.variance_of_mean(at), 0, 1e-12);
}

TEST(Film, AverageWeighsHalvesAlikeWhateverTheirCounts) {
  Film a = film(), b = film();
  a.add(at, {.radiance = Rgb(1)});
  a.add(at, {.radiance = Rgb(3)});
  for (int i = 0; i < 10; ++i) b.add(at, {.radiance = Rgb(i % 2 == 0 ? 10.0f : 20.0f)});
  const Film both = Film::average(a, b);
  EXPECT_FLOAT_EQ(both.mean(at).g, 0.5f * (2 + 15));
  EXPECT_EQ(both.sample_count(at), 12u);
  EXPECT_EQ(both.mean({2, 1}), Rgb());
}

// Var((A + B) / 2) = (Var A + Var B) / 4. Film keeps sums only, so the average's variance is an estimate; it must not
// be far below.
TEST(Film, AverageKeepsTheVarianceOfEqualHalves) {
  Film a = film(), b = film();
  for (int i = 0; i < 2000; ++i) a.add(at, {.radiance = Rgb(number(i))}), b.add(at, {.radiance = Rgb(number(-1 - i))});
  const double expected = (a.variance_of_mean(at) + b.variance_of_mean(at)) / 4;
  EXPECT_NEAR(Film::average(a, b).variance_of_mean(at), expected, 0.02 * expected);
}

TEST(Film, DevelopsTheCropWithItsLayers) {
  Film f = film({Aov::depth, Aov::albedo, Aov::object_id, Aov::sample_count, Aov::variance, Aov::normal});
  EXPECT_TRUE(f.keeps_features());
  const Features near{.albedo = Rgb(0.2f), .normal = {0, 0, 1}, .position = {1, 2, 3}, .depth = 2, .object = 7};
  const Features far{.albedo = Rgb(0.6f), .normal = {0, 1, 0}, .position = {1, 2, 3}, .depth = 4, .object = 9};
  f.add({3, 1}, {.radiance = Rgb(1), .features = near});
  f.add({3, 1}, {.radiance = Rgb(1), .features = far});
  f.add({3, 1}, {.radiance = Rgb(4)});  // beside everything
  f.add({3, 1}, {.radiance = Rgb(4)});
  const Image image = f.develop();
  ASSERT_EQ(image.width(), 3);
  ASSERT_EQ(image.height(), 2);
  const std::vector<std::string> channels = {
      "R",          "G",        "B",        "Z",       "albedo.R", "albedo.G", "albedo.B", "object.id", "samples.count",
      "variance.Y", "normal.X", "normal.Y", "normal.Z"};
  EXPECT_EQ(image.channels(), channels);
  const auto value = [&](const char* name) { return image.at(2, 1, *image.channel(name)); };
  EXPECT_FLOAT_EQ(value("R"), 2.5f);
  EXPECT_FLOAT_EQ(value("Z"), 3) << "of what was hit";
  EXPECT_FLOAT_EQ(value("albedo.G"), 0.2f) << "over all samples";
  EXPECT_FLOAT_EQ(value("object.id"), 7) << "the first";
  EXPECT_FLOAT_EQ(value("samples.count"), 4);
  EXPECT_FLOAT_EQ(value("normal.Y"), 0.5f);
  EXPECT_FLOAT_EQ(value("variance.Y"), 2.25f * 4 / 12);
  for (std::size_t c = 0; c < image.channel_count(); ++c) EXPECT_EQ(image.at(0, 0, c), 0);
}

TEST(Film, KnowsItsLayersByName) {
  for (const std::string& name : aov_names()) EXPECT_EQ(aov_names()[static_cast<std::size_t>(aov(name))], name);
  try {
    aov("albdo");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("unknown layer 'albdo'"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("albedo"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace lambert
