#include "lambert/light/light_choice.h"

#include "lambert/base/error.h"
#include "lambert/light/light_test_tools.h"
#include "lambert/light/many_lights.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

LightContext unit_scene() {
  LightContext c;
  c.scene_bounds.add(Vec3(-10)), c.scene_bounds.add(Vec3(10));
  return c;
}

std::vector<Light> lights_of_all_kinds() {
  std::vector<Light> lights = many_lights(15);
  lights.push_back(EnvironmentLight(Rgb(0.1f)));
  lights.push_back(DirectionalLight{{0, -1, 0}, Rgb(1)});
  return lights;
}

constexpr std::array all_strategies = {LightStrategy::uniform, LightStrategy::power, LightStrategy::tree};

TEST(LightStrategy, NamesAreKnownBothWays) {
  EXPECT_EQ(light_strategy("power"), LightStrategy::power);
  EXPECT_EQ(light_strategy_names(), (std::vector<std::string>{"uniform", "power", "tree"}));
  try {
    light_strategy("powr");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("did you mean 'power'"), std::string::npos);
  }
}

TEST(LightChooser, HasNoChoiceAmongNoneAndOne) {
  EXPECT_EQ(LightChooser().choose({}, {}, 0.5f).probability, 0);
  const std::vector<Light> one{PointLight{}};
  for (const LightStrategy s : all_strategies) {
    const LightChooser chooser(one, {}, s);
    EXPECT_EQ(chooser.choose({1, 0, 0}, {0, 1, 0}, 0.3f).probability, 1);
    EXPECT_EQ(chooser.probability({1, 0, 0}, {0, 1, 0}, 0), 1);
  }
}

// rows: PT-28
TEST(LightChooser, ChoosesAsOftenAsItSays) {
  const std::vector<Light> lights = lights_of_all_kinds();
  for (const LightStrategy strategy : all_strategies) {
    const LightChooser chooser(lights, unit_scene(), strategy);
    TestNumbers r(5);
    for (int place = 0; place < 10; ++place) {
      const Vec3 p = 11.0f * r.next_in_cube(), n = r.next_direction();
      constexpr int draws = 40000;
      std::vector<double> observed(lights.size() + 1), expected(lights.size() + 1);
      for (int i = 0; i < draws; ++i) {
        const auto c = chooser.choose(p, n, r.next());
        observed[c.probability > 0 ? c.light : lights.size()] += 1;
      }
      double rest = 1;
      for (std::uint32_t l = 0; l < lights.size(); ++l) {
        const auto probability = static_cast<double>(chooser.probability(p, n, l));
        expected[l] = draws * probability;
        rest -= probability;
      }
      expected.back() = draws * std::max(0.0, rest > 1e-5 ? rest : 0.0);
      const auto result = statistics::chi_square(observed, expected, 30);
      EXPECT_TRUE(result) << result.message;
    }
  }
}

TEST(LightChooser, PowerIsProportionalAndUniformIsNot) {
  const std::vector<Light> lights{PointLight{{}, Rgb(1)}, PointLight{{}, Rgb(3)}};
  EXPECT_FLOAT_EQ(LightChooser(lights, {}, LightStrategy::power).probability({}, {}, 1), 0.75f);
  EXPECT_FLOAT_EQ(LightChooser(lights, {}, LightStrategy::uniform).probability({}, {}, 1), 0.5f);
}

TEST(LightChooser, GivesLightsAtInfinityAFixedShareBesideTheTree) {
  const std::vector<Light> lights = lights_of_all_kinds();
  const LightChooser chooser(lights, unit_scene(), LightStrategy::tree);
  EXPECT_FLOAT_EQ(chooser.probability({1, 2, 3}, {0, 1, 0}, 15), 1.0f / 3);
  EXPECT_FLOAT_EQ(chooser.probability({1, 2, 3}, {0, 1, 0}, 16), 1.0f / 3);
}

TEST(LightChooser, BlackLightsAreNeverChosen) {
  const std::vector<Light> lights{EnvironmentLight(Rgb(0.0f)), PointLight{{}, Rgb(0)}};
  const LightChooser chooser(lights, {}, LightStrategy::tree);
  EXPECT_EQ(chooser.choose({1, 1, 1}, {0, 1, 0}, 0.4f).probability, 0);
  EXPECT_EQ(chooser.probability({1, 1, 1}, {0, 1, 0}, 0), 0);
}

// rows: PT-28
TEST(LightChooser, EstimatesStayUnbiased) {
  const std::vector<Light> lights = many_lights(200);
  const Vec3 p(1, 2, 3), n(0, 1, 0);
  double truth = 0;
  for (const Light& l : lights) {
    truth += std::visit([&](const auto& light) { return irradiance(light, LightContext{}, p, n, 60); }, l);
  }
  for (const LightStrategy strategy : all_strategies) {
    const LightChooser chooser(lights, unit_scene(), strategy);
    TestNumbers r(23);
    constexpr int draws = 200000;
    double sum = 0, squares = 0;
    for (int i = 0; i < draws; ++i) {
      const auto c = chooser.choose(p, n, r.next());
      const Vec2 u{r.next(), r.next()};
      const auto s = c.probability > 0 ? sample_light(lights[c.light], {}, p, u) : std::nullopt;
      const float cos = s ? std::max(0.0f, dot(s->wi, n)) : 0;
      const double x = s ? static_cast<double>(luminance(s->radiance) * cos / (s->pdf_omega * c.probability)) : 0;
      sum += x, squares += x * x;
    }
    const double mean = sum / draws, variance = squares / draws - mean * mean;
    const auto result = statistics::z_test(mean, std::sqrt(variance / draws), truth, all_strategies.size());
    EXPECT_TRUE(result) << result.message;
  }
}

/// Relative variance of estimating irradiance by one light: Σ E_l² / p_l / E² - 1.
double relative_variance(const std::vector<Light>& lights, LightStrategy strategy, Vec3 p, Vec3 n) {
  const LightChooser chooser(lights, unit_scene(), strategy);
  double total = 0, squares = 0;
  for (std::uint32_t l = 0; l < lights.size(); ++l) {
    const double e =
        std::visit([&](const auto& light) { return irradiance(light, LightContext{}, p, n, 4); }, lights[l]);
    if (e == 0) continue;
    total += e, squares += e * e / static_cast<double>(chooser.probability(p, n, l));
  }
  return squares / (total * total) - 1;
}

// rows: PT-28
TEST(LightChooser, TheTreeHasLessVarianceThanPower) {
  const std::vector<Light> lights = many_lights(500);
  TestNumbers r(31);
  double tree = 0, power = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 p = 10.0f * r.next_in_cube(), n = r.next_direction();
    tree += relative_variance(lights, LightStrategy::tree, p, n);
    power += relative_variance(lights, LightStrategy::power, p, n);
  }
  EXPECT_LT(tree, 0.5 * power);
}

}  // namespace
}  // namespace lambert
